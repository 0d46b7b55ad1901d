// Tables of text for the terminal and for Markdown.
#pragma once

#include <string>
#include <vector>

namespace erg::app {

/// Rows of cells under a heading. Every row has as many cells as the heading.
struct TextTable {
  std::vector<std::string> heading;
  std::vector<std::vector<std::string>> rows;

  /// Columns padded to equal width, two spaces between them.
  std::string aligned() const;
  /// A Markdown table.
  std::string markdown() const;
};

/// A number with so many digits after the point; zero has no sign.
std::string fixed_text(double value, int digits);

/// "1 seed", "3 seeds".
std::string count_text(int count, const std::string& noun);

}  // namespace erg::app
