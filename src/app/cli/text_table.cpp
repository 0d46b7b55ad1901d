#include "app/cli/text_table.h"

#include <algorithm>
#include <cstdio>

namespace erg::app {
namespace {

std::string aligned_row(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += cells[i];
    if (i + 1 < cells.size()) line += std::string(widths[i] - cells[i].size() + 2, ' ');
  }
  return line + '\n';
}

// A bar inside a cell would end the cell.
std::string markdown_cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string markdown_row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + markdown_cell(cell) + " |";
  return line + '\n';
}

}  // namespace

std::string TextTable::aligned() const {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < heading.size(); ++i) {
    std::size_t width = heading[i].size();
    for (const auto& row : rows) width = std::max(width, row[i].size());
    widths.push_back(width);
  }
  std::string text = aligned_row(heading, widths);
  for (const auto& row : rows) text += aligned_row(row, widths);
  return text;
}

std::string TextTable::markdown() const {
  std::string text = markdown_row(heading) + "|";
  for (std::size_t i = 0; i < heading.size(); ++i) text += "---|";
  text += '\n';
  for (const auto& row : rows) text += markdown_row(row);
  return text;
}

std::string fixed_text(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  const std::string shown = text;
  const bool zero = shown.find_first_not_of("-0.") == std::string::npos;
  return zero && shown.front() == '-' ? shown.substr(1) : shown;
}

std::string count_text(int count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace erg::app
