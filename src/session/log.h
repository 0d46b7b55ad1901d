// What happened, for the log window. May be written to from any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <vector>

#include "core/errors.h"

namespace erg::session {

/// How much a line matters; the later the more.
enum class LogLevel { information, warning, error };

/// "information", "warning", "error".
std::string to_string(LogLevel level);

/// One line.
struct LogLine {
  std::uint64_t number = 0;  ///< grows by one from line to line
  LogLevel level = LogLevel::information;
  std::string time;  ///< "14:03:27", local
  std::string text;

  /// As copied: "14:03:27 warning: text".
  std::string whole() const;
};

/// The last `kept_lines` lines.
class Log {
 public:
  static constexpr std::size_t kept_lines = 5000;

  /// Adds text; every line of it becomes a line of the log.
  void add(LogLevel level, const std::string& text);
  void information(const std::string& text) { add(LogLevel::information, text); }
  void warning(const std::string& text) { add(LogLevel::warning, text); }
  void error(const std::string& text) { add(LogLevel::error, text); }
  /// Every mistake as an error on a line of its own.
  void mistakes(const InputError& error);

  /// The lines of at least this level, oldest first.
  std::vector<LogLine> lines(LogLevel least = LogLevel::information) const;
  /// The same as text to copy.
  std::string text(LogLevel least = LogLevel::information) const;
  /// How many lines of exactly this level were added since the last clear.
  std::size_t count(LogLevel level) const;
  /// Changes whenever the lines do.
  std::uint64_t version() const;
  void clear();

 private:
  mutable std::mutex mutex_;
  std::deque<LogLine> lines_;
  std::size_t counts_[3] = {};
  std::uint64_t next_number_ = 0;
  std::uint64_t version_ = 0;
};

}  // namespace erg::session
