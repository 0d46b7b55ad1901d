// How far a run is: a bar on a terminal, a plain line now and then elsewhere.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace erg::app {

/// How the progress is shown.
enum class ProgressStyle { silent, lines, bar };

/// `bar` when standard error is a terminal, else `lines`; `silent` when asked to be quiet.
ProgressStyle progress_style(bool quiet);

/// "3 s", "4:05 min", "2:10 h".
std::string duration_text(double seconds);

/// Shows progress from `first` to `last` steps on standard error.
class Progress {
 public:
  Progress(ProgressStyle style, std::string label, std::int64_t first, std::int64_t last);
  /// Erases the bar.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Call after every step; prints at most a few times a second (bar) or every ten seconds (lines).
  /// `polls`: cells polled since the start, for the rate.
  void update(std::int64_t step, std::int64_t polls);

 private:
  using Clock = std::chrono::steady_clock;

  ProgressStyle style_;
  std::string label_;
  std::int64_t first_;
  std::int64_t last_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
};

}  // namespace erg::app
