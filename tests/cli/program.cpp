#include "program.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

namespace erg::test {

namespace fs = std::filesystem;

std::string ScratchFolder::write(const std::string& name, const std::string& text) const {
  write_bytes(file(name), text);
  return file(name);
}

std::vector<std::string> ScratchFolder::entries() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path())) names.push_back(entry.path().filename().string());
  return names;
}

Program::Program(const ScratchFolder& folder, const std::vector<std::string>& arguments,
                 const std::function<void()>& in_child) {
  // Beside the folder, so that what the program itself writes stands alone in it.
  output_ = folder.path().string() + ".output";
  errors_ = folder.path().string() + ".errors";
  std::vector<std::string> words{ERG_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  process_ = fork();
  if (process_ < 0) throw std::runtime_error("cannot start the program");
  if (process_ > 0) return;
  const int output = open(output_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int errors = open(errors_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (dup2(output, STDOUT_FILENO) < 0 || dup2(errors, STDERR_FILENO) < 0 || chdir(folder.path().c_str()) != 0)
    _exit(126);
  if (in_child) in_child();
  execv(ERG_PROGRAM, pointers.data());
  _exit(127);
}

Program::~Program() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    wait();
  }
  std::error_code ignored;
  fs::remove(output_, ignored);
  fs::remove(errors_, ignored);
}

void Program::send(int signal) const { kill(process_, signal); }

Ended Program::wait() {
  int status = 0;
  rusage used{};
  wait4(process_, &status, 0, &used);
  process_ = -1;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_bytes(output_), read_bytes(errors_),
          static_cast<std::uint64_t>(used.ru_maxrss) * 1024};
}

Ended run_erg(const ScratchFolder& folder, const std::vector<std::string>& arguments,
              const std::function<void()>& in_child) {
  return Program(folder, arguments, in_child).wait();
}

nlohmann::json read_json(const fs::path& path) { return nlohmann::json::parse(read_bytes(path)); }

std::string small_config(int steps) {
  nlohmann::json config;
  config["erg"] = 1;
  config["model"] = "momiji";
  config["grid"] = {{"nx", 48}, {"ny", 32}};
  config["run"] = {{"steps", steps}, {"seed", 7}};
  return config.dump(2);
}

}  // namespace erg::test
