#include "session/log.h"

#include <algorithm>

#include "session/surroundings.h"

namespace erg::session {
namespace {

std::size_t index_of(LogLevel level) { return static_cast<std::size_t>(level); }

}  // namespace

std::string to_string(LogLevel level) {
  switch (level) {
    case LogLevel::information:
      return "information";
    case LogLevel::warning:
      return "warning";
    case LogLevel::error:
      break;
  }
  return "error";
}

std::string LogLine::whole() const { return time + " " + to_string(level) + ": " + text; }

void Log::add(LogLevel level, const std::string& text) {
  const std::string time = local_time("%H:%M:%S");
  const std::lock_guard lock(mutex_);
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end > begin || text.empty()) {
      lines_.push_back({next_number_++, level, time, text.substr(begin, end - begin)});
      ++counts_[index_of(level)];
    }
    begin = end + 1;
  }
  while (lines_.size() > kept_lines) lines_.pop_front();
  ++version_;
}

void Log::mistakes(const InputError& error) {
  for (const Mistake& mistake : error.mistakes()) add(LogLevel::error, mistake.text());
}

std::vector<LogLine> Log::lines(LogLevel least) const {
  const std::lock_guard lock(mutex_);
  std::vector<LogLine> found;
  for (const LogLine& line : lines_) {
    if (line.level >= least) found.push_back(line);
  }
  return found;
}

std::string Log::text(LogLevel least) const {
  std::string all;
  for (const LogLine& line : lines(least)) all.append(line.whole()).append("\n");
  return all;
}

std::size_t Log::count(LogLevel level) const {
  const std::lock_guard lock(mutex_);
  return counts_[index_of(level)];
}

std::uint64_t Log::version() const {
  const std::lock_guard lock(mutex_);
  return version_;
}

void Log::clear() {
  const std::lock_guard lock(mutex_);
  lines_.clear();
  for (std::size_t& count : counts_) count = 0;
  ++version_;
}

}  // namespace erg::session
