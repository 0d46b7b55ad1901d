#include "app/cli/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace erg::app {
namespace {

constexpr int bar_width = 30;
constexpr char erase_line[] = "\r\033[K";

double seconds_between(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

ProgressStyle progress_style(bool quiet) {
  if (quiet) return ProgressStyle::silent;
  return isatty(STDERR_FILENO) != 0 ? ProgressStyle::bar : ProgressStyle::lines;
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<long long>(std::llround(seconds));
  char text[32];
  if (whole < 60) {
    std::snprintf(text, sizeof text, "%lld s", whole);
  } else if (whole < 3600) {
    std::snprintf(text, sizeof text, "%lld:%02lld min", whole / 60, whole % 60);
  } else {
    std::snprintf(text, sizeof text, "%lld:%02lld h", whole / 3600, whole % 3600 / 60);
  }
  return text;
}

Progress::Progress(ProgressStyle style, std::string label, std::int64_t first, std::int64_t last)
    : style_(style), label_(std::move(label)), first_(first), last_(last) {}

Progress::~Progress() {
  if (style_ == ProgressStyle::bar) std::fputs(erase_line, stderr);
}

void Progress::update(std::int64_t step, std::int64_t polls) {
  if (style_ == ProgressStyle::silent) return;
  const Clock::time_point now = Clock::now();
  const double pause = style_ == ProgressStyle::bar ? 0.1 : 10.0;
  if (seconds_between(shown_, now) < pause) return;
  shown_ = now;

  const double elapsed = seconds_between(start_, now);
  const auto done = static_cast<double>(step - first_);
  const double share = last_ > 0 ? static_cast<double>(step) / static_cast<double>(last_) : 1.0;
  const std::string left = done > 0 ? duration_text(elapsed / done * static_cast<double>(last_ - step)) : "?";
  const double rate = static_cast<double>(polls) / elapsed / 1e6;
  if (style_ == ProgressStyle::bar) {
    const std::string filled(static_cast<std::size_t>(std::lround(share * bar_width)), '#');
    std::fprintf(stderr, "%s%s [%-*s] %3.0f%%  step %lld of %lld  %.1f million polls/s  %s left", erase_line,
                 label_.c_str(), bar_width, filled.c_str(), share * 100, static_cast<long long>(step),
                 static_cast<long long>(last_), rate, left.c_str());
  } else {
    std::fprintf(stderr, "%s: step %lld of %lld (%.0f%%), %.1f million polls/s, %s left\n", label_.c_str(),
                 static_cast<long long>(step), static_cast<long long>(last_), share * 100, rate, left.c_str());
  }
  std::fflush(stderr);
}

}  // namespace erg::app
