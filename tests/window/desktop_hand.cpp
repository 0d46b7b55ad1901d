#include "desktop_hand.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "io/config/config_file.h"

namespace erg::test {
namespace {

using namespace std::chrono_literals;

constexpr auto patience = 60s;  // on a machine that is busy with other things
constexpr auto a_moment = 60ms;
constexpr auto pause = 5ms;
constexpr std::uint64_t settled = 3;  // so many frames after an input everything lies where it belongs

// Counts its own pauses: a process that was held up on a busy machine has not been waiting.
bool soon(const std::function<bool()>& holds, std::chrono::milliseconds limit = patience) {
  for (auto waited = 0ms; waited < limit; waited += pause) {
    if (holds()) return true;
    std::this_thread::sleep_for(pause);
  }
  return holds();
}

pid_t start(const std::vector<std::string>& words, const std::function<void()>& in_child) {
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  const pid_t process = fork();
  if (process < 0) throw std::runtime_error("cannot start " + words.front());
  if (process > 0) return process;
  in_child();
  execvp(pointers[0], pointers.data());
  _exit(127);
}

std::string read_all(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void end(pid_t& process, int signal) {
  if (process <= 0) return;
  kill(process, signal);
  waitpid(process, nullptr, 0);
  process = -1;
}

}  // namespace

Display::Display(const std::string& size) {
  int ends[2] = {-1, -1};
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const std::string channel = std::to_string(ends[1]);
  process_ = start({"Xvfb", "-displayfd", channel, "-screen", "0", size, "-nolisten", "tcp", "-noreset"}, [] {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDERR_FILENO);
  });
  close(ends[1]);
  // It writes the number of the display when it is ready.
  std::string number;
  char letter = 0;
  while (read(ends[0], &letter, 1) == 1 && letter != '\n') number += letter;
  close(ends[0]);
  if (number.empty()) throw std::runtime_error("Xvfb does not start; is the package xvfb installed?");
  name_ = ":" + number;
}

Display::~Display() { kill(); }

void Display::kill() { end(process_, SIGKILL); }

DesktopHand::DesktopHand(const Display& display, const std::filesystem::path& folder,
                         const std::vector<std::string>& arguments,
                         const std::map<std::string, std::string>& environment)
    : display_(display.name()), map_(folder / "widgets"), errors_(folder / "errors") {
  std::vector<std::string> words{ERG_PROGRAM, "gui"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  words.insert(words.end(), {"--ui-map", map_.string()});
  process_ = start(words, [&] {
    setenv("DISPLAY", display_.c_str(), 1);
    setenv("HOME", folder.c_str(), 1);
    setenv("XDG_CONFIG_HOME", (folder / "config").c_str(), 1);
    setenv("XDG_STATE_HOME", (folder / "state").c_str(), 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
    const int file = open(errors_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (dup2(file, STDERR_FILENO) < 0 || chdir(folder.c_str()) != 0) _exit(126);
  });
}

DesktopHand::~DesktopHand() { end(process_, SIGKILL); }

std::map<std::string, DesktopHand::Place> DesktopHand::places() const {
  std::map<std::string, Place> found;
  std::istringstream lines(read_all(map_));
  std::string line;
  std::getline(lines, line);  // the count of frames
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string name;
    std::getline(words, name, '\t');
    Place place;
    std::string state;
    words >> place.left >> place.top >> place.right >> place.bottom >> state;
    place.enabled = state == "on";
    found.emplace(name, place);
  }
  return found;
}

void DesktopHand::wait_for(const std::string& name, bool any) const {
  const bool came = soon([&] {
    const auto all = places();
    const auto found = all.find(name);
    return found != all.end() && (any || found->second.enabled);
  });
  if (!came) throw std::runtime_error("no widget \"" + name + "\" among:\n" + read_all(map_) + errors());
}

void DesktopHand::wait_for_file(const std::filesystem::path& path) const {
  if (!soon([&] { return std::filesystem::exists(path); })) throw std::runtime_error("no file " + path.string());
}

DesktopHand::Place DesktopHand::place(const std::string& name) const {
  Place last;
  Place now;
  do {
    last = now;
    wait_for(name);
    const std::uint64_t before = frames();
    soon([&] { return frames() > before; }, a_moment);
    const auto all = places();
    const auto found = all.find(name);
    if (found != all.end()) now = found->second;
  } while (!(now == last));
  return now;
}

std::uint64_t DesktopHand::frames() const {
  std::uint64_t count = 0;
  std::istringstream(read_all(map_)) >> count;
  return count;
}

bool DesktopHand::has_ended() const {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid != 0;
}

void DesktopHand::hand(const std::string& words, std::uint64_t presses) const {
  const std::uint64_t goal = frames() + presses + settled;
  command("xdotool " + words);
  if (!soon([&] { return frames() >= goal || has_ended(); })) throw std::runtime_error("nothing is drawn: " + words);
}

void DesktopHand::command(const std::string& words) const {
  const std::string line = "DISPLAY=" + display_ + " " + words;
  if (std::system(line.c_str()) != 0) throw std::runtime_error("failed: " + line);
}

void DesktopHand::move_to(const std::string& name) const {
  const Place at = place(name);
  const std::string there = std::to_string((at.left + at.right) / 2) + " " + std::to_string((at.top + at.bottom) / 2);
  // Where the pointer is already, nothing happens that would be drawn.
  if (there != pointer_) hand("mousemove " + there, 0);
  pointer_ = there;
}

void DesktopHand::click(const std::string& name) const {
  move_to(name);
  hand("mousedown 1 mouseup 1", 2);
}

void DesktopHand::drag(const std::string& name, int right, int down) const {
  move_to(name);
  hand("mousedown 1", 1);
  for (int part = 0; part < 2; ++part) {
    hand("mousemove_relative -- " + std::to_string(right / 2) + " " + std::to_string(down / 2), 0);
  }
  hand("mouseup 1", 1);
  pointer_.clear();
}

void DesktopHand::key(const std::string& keys) const { hand("key " + keys, 1); }

void DesktopHand::raw(const std::string& words) const { hand(words, 1); }

void DesktopHand::type(const std::string& text) const { hand("type --delay 2 -- '" + text + "'", text.size()); }

void DesktopHand::edit(const std::string& name) const {
  move_to(name);
  hand("keydown ctrl mousedown 1 mouseup 1 keyup ctrl", 2);
  key("ctrl+a");
}

void DesktopHand::enter(const std::string& name, const std::string& text) const {
  edit(name);
  type(text);
  key("Return");
}

void DesktopHand::move_window(const std::string& place) const {
  command("xdotool search --sync --onlyvisible --name ' - Erg' windowmove " + place);
}

int DesktopHand::height(const std::string& name) const {
  wait_for(name);
  const Place at = places().at(name);
  return at.bottom - at.top;
}

bool DesktopHand::comes_true(const std::function<bool()>& holds) const { return soon(holds); }

void DesktopHand::picture(const std::filesystem::path& path) const {
  command("import -window root '" + path.string() + "'");
}

void DesktopHand::carry_out(const Deed& deed) const {
  const auto x_button = [](int button) { return std::to_string(button == 0 ? 1 : button == 1 ? 3 : 2); };
  switch (deed.kind) {
    case Deed::Kind::move:
      return command("xdotool mousemove " + std::to_string(static_cast<int>(deed.x)) + " " +
                     std::to_string(static_cast<int>(deed.y)));
    case Deed::Kind::press:
      return command("xdotool mousedown " + x_button(deed.button));
    case Deed::Kind::release:
      return command("xdotool mouseup " + x_button(deed.button));
    case Deed::Kind::wheel:
      return command(std::string("xdotool click ") + (deed.lines > 0 ? "4" : "5"));
    case Deed::Kind::key:
      return command("xdotool key " + deed.key.name);
    case Deed::Kind::type:
      return command("xdotool type -- '" + deed.text + "'");
  }
}

std::vector<Spot> DesktopHand::spots() const {
  std::vector<Spot> all;
  for (const auto& [name, place] : places()) {
    all.push_back({name, static_cast<float>(place.left), static_cast<float>(place.top), static_cast<float>(place.right),
                   static_cast<float>(place.bottom)});
  }
  return all;
}

bool DesktopHand::runs() {
  int status = 0;
  if (process_ > 0 && waitpid(process_, &status, WNOHANG) == process_) {
    process_ = -1;
    ended_with_ = code_of(status);
  }
  return process_ > 0;
}

double DesktopHand::memory() const {
  std::ifstream status("/proc/" + std::to_string(process_) + "/status");
  double kibi = 0;
  for (std::string word; status >> word;) {
    if (word == "VmRSS:") status >> kibi;
  }
  return kibi / 1024;
}

void DesktopHand::terminate() const { ::kill(process_, SIGTERM); }

void DesktopHand::quit() {
  // Without a window manager keys go to the window under the pointer.
  command("xdotool mouseup 1 mouseup 2 mouseup 3 mousemove 500 300");
  const bool ended = soon([this] {
    // Each key waits for the frames that show what it did: on a busy machine the next Escape would take the question
    // away before it was seen.
    for (const char* const keys : {"Escape", "ctrl+q"}) {
      if (runs()) key(keys);
    }
    const std::string without_saving = "UNSAVED/WITHOUT SAVING";
    if (runs() && places().contains(without_saving)) click(without_saving);
    return !runs();
  });
  if (!ended) throw std::runtime_error("the program does not quit");
}

int DesktopHand::code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : -1; }

int DesktopHand::wait() {
  if (!soon([this] { return !runs(); })) throw std::runtime_error("the program does not end");
  return ended_with_;
}

std::string DesktopHand::errors() const { return read_all(errors_); }

std::string write_small_terrain(const std::filesystem::path& folder) {
  sim::Config config("momiji");
  config.title = "small";
  config.grid.set("nx", std::int64_t{64});
  config.grid.set("ny", std::int64_t{48});
  config.run.set("threads", std::int64_t{2});
  io::write_config(folder / "small.json", config);
  return (folder / "small.json").string();
}

}  // namespace erg::test
