// What the weather brings is declared once: reader, writer, schema, window and comparison go through the table.
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "source_tree.h"

namespace erg::test {
namespace {

/// The keys of the table in channels.cpp.
std::vector<std::string> channel_keys() {
  static const std::regex key(R"re(\.declared = \{\.key = "(\w+)")re");
  std::string text;
  for (const auto& [path, includes] : source_tree()) {
    if (path.ends_with("/channels.cpp")) text = read_text(source_root() / "src" / path);
  }
  std::vector<std::string> keys;
  for (auto at = std::sregex_iterator(text.begin(), text.end(), key); at != std::sregex_iterator(); ++at) {
    keys.push_back((*at)[1]);
  }
  return keys;
}

/// The lines that name a channel: its key in quotes, or a member. Comments do not count.
std::vector<std::string> lines_naming(const std::string& key, const std::string& text) {
  const std::regex named("\"" + key + "\"|(\\.|->|&\\w+::)" + key + "\\b");
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string code = line.substr(0, line.find("//"));
    if (std::regex_search(code, named)) found.push_back(line);
  }
  return found;
}

TEST(Channels, AreNamedWhereTheyAreDeclaredAndByModelsThatUseThem) {
  const std::vector<std::string> keys = channel_keys();
  ASSERT_GE(keys.size(), 2u);
  int files = 0;
  for (const auto& [path, includes] : source_tree()) {
    const std::string layer = layer_of(path);
    if (layer == "models" || !may_include(layer).contains("models")) continue;  // those above the models
    ++files;
    const std::string text = read_text(source_root() / "src" / path);
    for (const std::string& key : keys) {
      for (const std::string& line : lines_naming(key, text)) ADD_FAILURE() << path << " names " << key << ": " << line;
    }
  }
  EXPECT_GT(files, 100);
}

TEST(Channels, ThatAreNamedAreSeen) {
  EXPECT_EQ(lines_naming("fog", "now.fog = 1;\nfind(\"fog\");\n&Forcing::fog\na->fog\n").size(), 4u);
  EXPECT_EQ(lines_naming("fog", "double foggy;  // .fog\n\"fogs\" fog\n").size(), 0u);
}

}  // namespace
}  // namespace erg::test
