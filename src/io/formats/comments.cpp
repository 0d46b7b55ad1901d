#include "io/formats/comments.h"

#include <sstream>

namespace erg::io {

std::string comments(const std::string& mark, const MetadataEntries& entries) {
  std::string all;
  for (const auto& [name, text] : entries) {
    all.append(mark).append(name).append(":");
    const bool single = text.find('\n') == std::string::npos;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) all.append(single ? " " : "\n" + mark).append(line);
    all += '\n';
  }
  return all;
}

}  // namespace erg::io
