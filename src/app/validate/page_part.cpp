#include "app/validate/page_part.h"

#include <algorithm>

namespace erg::app {
namespace {

/// Where the first line from `from` on starts that is a heading of at most `level` #; the page's end without one.
std::size_t next_heading(const std::string& page, std::size_t from, std::size_t level) {
  for (std::size_t line = from; line < page.size();) {
    const std::size_t marks = std::min(page.find_first_not_of('#', line), page.size()) - line;
    const bool heading = marks > 0 && line + marks < page.size() && page[line + marks] == ' ';
    if (heading && marks <= level) return line;
    const std::size_t end = page.find('\n', line);
    if (end == std::string::npos) break;
    line = end + 1;
  }
  return page.size();
}

}  // namespace

std::string with_part(const std::string& page, const std::string& part) {
  const std::string heading = part.substr(0, part.find('\n') + 1);
  const std::size_t found = page.find("\n" + heading);
  if (found == std::string::npos) return page + "\n" + part;
  const std::size_t start = found + 1;
  const std::size_t end = next_heading(page, start + heading.size(), heading.find_first_not_of('#'));
  return page.substr(0, start) + part + (end < page.size() ? "\n" : "") + page.substr(end);
}

}  // namespace erg::app
