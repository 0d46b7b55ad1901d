// From the text of a config to a Config, collecting every mistake on the way.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/errors.h"
#include "sim/config.h"

namespace erg::io {

/// The mistakes found in one file.
class MistakeList {
 public:
  explicit MistakeList(std::string name) : name_(std::move(name)) {}

  /// Adds one at a line of the file. Those after the first hundred are only counted: nobody reads on.
  void add(int line, std::string problem, std::string remedy);
  /// One that knows its place better than by line; it is sorted behind all others.
  void add_last(Mistake mistake);
  /// `file:line`.
  std::string place(int line) const { return name_ + ":" + std::to_string(line); }
  /// Throws one InputError with all mistakes, in the order of lines.
  void throw_if_any() const;

 private:
  static constexpr std::size_t most_told = 100;

  std::string name_;
  std::vector<std::pair<int, Mistake>> found_;
  std::size_t untold_ = 0;
};

/// What a config's text says. The config is of use only when there are no mistakes.
struct ConfigReading {
  sim::Config config;
  MistakeList mistakes;
  int image_line = 0;        ///< where scene.image stands
  int model_image_line = 0;  ///< where the model's own path stands
  bool has_comments = false;
};

/// Reads all of a text, whatever is wrong with it; `name` stands for the file in mistakes.
ConfigReading read_config_text(std::string_view text, const std::string& name);

}  // namespace erg::io
