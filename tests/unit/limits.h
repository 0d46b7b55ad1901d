// Limits set on this process for as long as a test needs them: a disk that is full, memory that is short, a user who
// may not write everywhere.
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <string>

namespace erg::test {

/// No file can grow beyond so many bytes: writing fails as on a full disk. Any user may set that.
inline void limit_files(rlim_t bytes) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  ::getrlimit(RLIMIT_FSIZE, &limit);
  limit.rlim_cur = bytes;
  ::setrlimit(RLIMIT_FSIZE, &limit);
}

/// The process may take so many bytes of addresses more.
inline void limit_memory(rlim_t more) {
  std::uint64_t used = 0;
  std::string word;
  for (std::ifstream status("/proc/self/status"); status >> word;) {
    if (word == "VmSize:") status >> used;
  }
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = used * 1024 + more;
  ::setrlimit(RLIMIT_AS, &limit);
}

/// A limit as it was, afterwards.
class LimitRestored {
 public:
  explicit LimitRestored(__rlimit_resource which) : which_(which) { ::getrlimit(which_, &before_); }
  LimitRestored(const LimitRestored&) = delete;
  LimitRestored& operator=(const LimitRestored&) = delete;
  ~LimitRestored() { ::setrlimit(which_, &before_); }

 private:
  __rlimit_resource which_;
  rlimit before_{};
};

/// Somebody without special rights: permissions mean nothing to root.
class OrdinaryUser {
 public:
  OrdinaryUser() {
    if (was_ == 0 && ::seteuid(nobody) != 0) was_ = nobody;
  }
  OrdinaryUser(const OrdinaryUser&) = delete;
  OrdinaryUser& operator=(const OrdinaryUser&) = delete;
  ~OrdinaryUser() {
    if (::geteuid() != was_) static_cast<void>(!::seteuid(was_));
  }

 private:
  static constexpr uid_t nobody = 65534;
  uid_t was_ = ::geteuid();
};

}  // namespace erg::test
