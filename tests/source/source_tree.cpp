#include "source_tree.h"

#include <fstream>
#include <sstream>
#include <string_view>

namespace erg::test {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

namespace {

std::vector<std::string> included_by(const fs::path& path) {
  std::vector<std::string> included;
  std::ifstream text(path);
  for (std::string line; std::getline(text, line);) {
    constexpr std::string_view include = "#include \"";
    if (!line.starts_with(include)) continue;
    included.push_back(line.substr(include.size(), line.find('"', include.size()) - include.size()));
  }
  return included;
}

}  // namespace

const std::map<std::string, std::vector<std::string>>& source_tree() {
  static const std::map<std::string, std::vector<std::string>> tree = [] {
    std::map<std::string, std::vector<std::string>> all;
    const fs::path src = source_root() / "src";
    for (const auto& entry : fs::recursive_directory_iterator(src)) {
      const fs::path kind = entry.path().extension();
      if (kind != ".h" && kind != ".cpp" && kind != ".inl" && kind != ".cu" && kind != ".def" && kind != ".k") continue;
      all[entry.path().lexically_relative(src).generic_string()] = included_by(entry.path());
    }
    return all;
  }();
  return tree;
}

std::string layer_of(const std::string& path) {
  std::string folder = path.substr(0, path.rfind('/'));
  while (!arrows().contains(folder) && folder.find('/') != std::string::npos) folder.resize(folder.rfind('/'));
  return folder;
}

const std::map<std::string, std::set<std::string>>& arrows() {
  static const std::map<std::string, std::set<std::string>> all = [] {
    std::map<std::string, std::set<std::string>> read;
    std::istringstream noted(ERG_ARROWS);  // "core: io/files:core sim:models,executors"
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
