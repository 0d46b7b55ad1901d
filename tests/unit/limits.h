// Limits set on this process for as long as a test needs them: a disk that is full, memory that is short, a user who
// may not write everywhere.
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <string>

namespace erg::test {

/// No file can grow beyond so many bytes: writing fails as on a full disk. Any user may set that. The signal that comes
/// with it ends a process that does not see to it, as a shell's `ulimit -f` does: a test that writes in its own process
/// holds a SignalIgnored.
inline void limit_files(rlim_t bytes) {
  rlimit limit{};
  ::getrlimit(RLIMIT_FSIZE, &limit);
  limit.rlim_cur = bytes;
  ::setrlimit(RLIMIT_FSIZE, &limit);
}

/// A signal that does nothing for as long as this lives.
class SignalIgnored {
 public:
  explicit SignalIgnored(int signal) : signal_(signal), before_(std::signal(signal, SIG_IGN)) {}
  SignalIgnored(const SignalIgnored&) = delete;
  SignalIgnored& operator=(const SignalIgnored&) = delete;
  ~SignalIgnored() { std::signal(signal_, before_); }

 private:
  int signal_;
  void (*before_)(int);
};

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
