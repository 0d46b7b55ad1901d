#include "app/cli/film.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <optional>
#include <vector>

#include "app/cli/output_folder.h"
#include "io/files/atomic_file.h"
#include "io/formats/png.h"

namespace erg::app {

using sim::Simulation;

namespace {

namespace fs = std::filesystem;

constexpr int smallest_film = 16;  // pixels a side: the codec works on blocks of so many

// Runs a program found on the PATH, its output thrown away; its exit code, or nothing when it could not be started.
std::optional<int> run_program(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", 0, 0);
  // What this program ignores (standard_streams.h) shall not be ignored there.
  sigset_t ignored;
  sigemptyset(&ignored);
  sigaddset(&ignored, SIGPIPE);
  sigaddset(&ignored, SIGXFSZ);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigdefault(&attributes, &ignored);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  pid_t process = 0;
  const int failed = posix_spawnp(&process, arguments[0], &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return std::nullopt;
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/// A file as ffmpeg takes it for one, whatever its name: it begins with a slash, so that what stands before a colon is
/// no protocol, and a dash no option.
std::string plain_file(const fs::path& path) { return fs::absolute(path).string(); }

/// The same where ffmpeg looks for a number: a percent sign that is none is written twice.
std::string numbered_files(const fs::path& folder, const char* pattern) {
  std::string files;
  for (const char c : plain_file(folder)) files += c == '%' ? std::string("%%") : std::string(1, c);
  return files + "/" + pattern;
}

}  // namespace

Film::Film(const fs::path& folder, const std::string& name, std::int64_t every, const PictureRequest& request,
           Simulation& simulation)
    : frames_(folder / (name + "-frames")), movie_(folder / (name + ".mp4")), every_(every) {
  context_ = render::make_offscreen_context(request.context);
  renderer_ = std::make_unique<render::Renderer>();
  plan_ = plan_picture(request, RunView(simulation).view());
  if (std::min(plan_.size.width, plan_.size.height) < smallest_film) {
    const std::string least = std::to_string(smallest_film);
    throw InputError("--size " + request.size, "is too small for a film", "give at least " + least + "x" + least);
  }
  make_folder(frames_);
  try_output((frames_ / frame_name(simulation)).string(), frames_ / frame_name(simulation));
  try_output(movie_.string(), movie_);
}

std::string Film::frame_name(const Simulation& simulation) const {
  char name[32];
  std::snprintf(name, sizeof name, "%06lld.png", static_cast<long long>(simulation.step_count() / every_));
  return name;
}

void Film::add_frame(Simulation& simulation) {
  const std::int64_t number = simulation.step_count() / every_;
  if (first_ < 0) first_ = number;
  last_ = number;
  const RunView run(simulation);
  const render::Picture picture = renderer_->draw(run.view(), plan_.look, plan_.camera, plan_.size);
  const io::MetadataEntries step{{"erg:step", std::to_string(simulation.step_count())}};
  io::write_png(frames_ / frame_name(simulation), picture.image, step);
}

void Film::finish(bool quiet) const {
  if (!quiet) std::cout << "  wrote frames into " << frames_.string() << "\n";
  // What ffmpeg leaves when it is killed or the disk is full never bears the film's name.
  const fs::path draft = io::unfinished_name(movie_);
  const std::string even = "scale=trunc(iw/2)*2:trunc(ih/2)*2";  // the codec wants even sides
  // Only so many: the frames of an earlier, longer run may lie behind them.
  const std::string count = std::to_string(last_ - first_ + 1);
  const std::optional<int> ended = run_program({"ffmpeg",
                                                "-y",
                                                "-loglevel",
                                                "error",
                                                "-framerate",
                                                "25",
                                                "-f",
                                                "image2",
                                                "-pattern_type",
                                                "sequence",
                                                "-start_number",
                                                std::to_string(first_),
                                                "-i",
                                                numbered_files(frames_, "%06d.png"),
                                                "-frames:v",
                                                count,
                                                "-vf",
                                                even,
                                                "-c:v",
                                                "libx264",
                                                "-pix_fmt",
                                                "yuv420p",
                                                "-f",
                                                "mp4",
                                                plain_file(draft)});
  if (!ended || *ended == 127) {
    std::cerr << "No film was made: ffmpeg is not installed (apt-get install ffmpeg). The frames are in "
              << frames_.string() << "\n";
    return;
  }
  std::error_code failed;
  if (*ended == 0) fs::rename(draft, movie_, failed);
  if (*ended != 0 || failed) {
    std::error_code ignored;
    fs::remove(draft, ignored);
    throw io::WriteError(movie_.string(), "ffmpeg could not write this film",
                         "its own words, if any, stand above; the frames are in " + frames_.string());
  }
  if (!quiet) std::cout << "  wrote " << movie_.string() << "\n";
}

}  // namespace erg::app
