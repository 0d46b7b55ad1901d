#include "source_tree.h"

#include <fstream>
#include <sstream>

namespace erg::test {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

SourceFile read_source(std::istream& text) {
  SourceFile file;
  for (std::string line; std::getline(text, line);) {
    constexpr std::string_view include = "#include ";
    if (line.rfind(include, 0) == 0) {
      const char closing = line[include.size()] == '<' ? '>' : '"';
      const std::string name = line.substr(include.size(), line.find(closing, include.size() + 1) + 1 - include.size());
      if (closing == '>') {
        file.foreign.push_back(name);
      } else {
        file.own.push_back(name.substr(1, name.size() - 2));
      }
    }
    file.lines.push_back(std::move(line));
  }
  return file;
}

const std::map<std::string, SourceFile>& source_tree() {
  static const std::map<std::string, SourceFile> tree = [] {
    std::map<std::string, SourceFile> all;
    const fs::path src = source_root() / "src";
    for (const auto& entry : fs::recursive_directory_iterator(src)) {
      const fs::path kind = entry.path().extension();
      if (kind != ".h" && kind != ".cpp" && kind != ".inl" && kind != ".cu") continue;
      std::ifstream text(entry.path());
      all[entry.path().lexically_relative(src).generic_string()] = read_source(text);
    }
    return all;
  }();
  return tree;
}

std::vector<std::string> headers() {
  std::vector<std::string> found;
  for (const auto& [path, file] : source_tree()) {
    if (path.ends_with(".h")) found.push_back(path);
  }
  return found;
}

std::string layer_of(const std::string& path) { return path.substr(0, path.find('/')); }

const std::map<std::string, std::set<std::string>>& arrows() {
  static const std::map<std::string, std::set<std::string>> all = [] {
    std::map<std::string, std::set<std::string>> read;
    std::istringstream noted(ERG_ARROWS);  // "core: wind:core sim:models,executors"
    for (std::string word; noted >> word;) {
      const std::size_t colon = word.find(':');
      std::set<std::string>& links = read[word.substr(0, colon)];
      std::istringstream names(word.substr(colon + 1));
      for (std::string name; std::getline(names, name, ',');) links.insert(name);
    }
    return read;
  }();
  return all;
}

std::set<std::string> may_include(const std::string& layer) {
  std::set<std::string> found{layer};
  for (const std::string& linked : arrows().at(layer)) found.merge(may_include(linked));
  return found;
}

}  // namespace erg::test
