// Runs the real program as a person does, in a folder of its own.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../unit/temporary_folder.h"

namespace erg::test {

/// How a run of the program ended.
struct Ended {
  int exit_code = -1;             ///< -1 when a signal ended it
  std::string output;             ///< standard output
  std::string errors;             ///< standard error
  std::uint64_t most_memory = 0;  ///< bytes that it held at most
};

/// The folder that the program works in.
class ScratchFolder : public TemporaryFolder {
 public:
  /// The path of a file in it.
  std::string file(const std::string& name) const { return (*this / name).string(); }
  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& text) const;
  /// Names of the files and folders in it.
  std::vector<std::string> entries() const;
};

/// The program at work in a scratch folder.
class Program {
 public:
  /// `in_child` is called in the new process before the program begins: for limits.
  Program(const ScratchFolder& folder, const std::vector<std::string>& arguments,
          const std::function<void()>& in_child = {});
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void send(int signal) const;
  /// Standard error so far.
  Ended wait();

 private:
  pid_t process_ = -1;
  std::filesystem::path output_;
  std::filesystem::path errors_;
};

/// Starts the program and waits for its end.
Ended run_erg(const ScratchFolder& folder, const std::vector<std::string>& arguments,
              const std::function<void()>& in_child = {});

nlohmann::json read_json(const std::filesystem::path& path);

/// A config that runs in an instant: 48 x 32 cells of Momiji, `steps` steps.
std::string small_config(int steps);

}  // namespace erg::test
