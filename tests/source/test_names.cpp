// No two types of one name: the linker takes the first of two inline functions or tables of one name, whoever meant the
// other, and says nothing.
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "source_tree.h"

namespace erg::test {
namespace {

using Names = std::map<std::string, std::set<std::string>>;

/// Adds the types that a file defines in the project's namespace, each with the file: not those of unnamed namespaces,
/// nor of a file taken in by another that opens the namespace, nor those within a type. Relies on the format: what
/// belongs to a namespace is not indented.
void add_types(const std::string& path, std::istream& text, Names& files_of) {
  static const std::regex type(
      R"((?:template <.*> )?(?:class|struct|union|enum|enum class|enum struct) (?:alignas\(\w+\) )?(\w+)(?: final)?(?: :.*| \{.*)?)");
  static const std::regex alias(R"((?:template <.*> )?using (\w+) =.*)");
  bool ours = false;
  bool unnamed = false;
  std::smatch match;
  for (std::string line; std::getline(text, line);) {
    if (line == "namespace erg {") ours = true;
    if (line == "namespace {") unnamed = true;
    if (line == "}  // namespace") unnamed = false;
    if (!ours || unnamed || !(std::regex_match(line, match, type) || std::regex_match(line, match, alias))) continue;
    files_of[match[1]].insert(path);
  }
}

std::string listed(const std::set<std::string>& files) {
  std::string text;
  for (const std::string& file : files) text += " " + file;
  return text;
}

TEST(Names, OfTypesStandForOneTypeEach) {
  Names files_of;
  for (const auto& [path, includes] : source_tree()) {
    std::istringstream text(read_text(source_root() / "src" / path));
    add_types(path, text, files_of);
  }
  ASSERT_GT(files_of.size(), 300u);
  EXPECT_TRUE(files_of.contains("Terrain"));
  EXPECT_TRUE(files_of.contains("EdgeClass"));
  EXPECT_TRUE(files_of.contains("CoverField"));
  for (const auto& [name, files] : files_of) EXPECT_EQ(files.size(), 1u) << name << " in" << listed(files);
}

TEST(Names, OfTwoTypesAreSeen) {
  Names files_of;
  std::istringstream first(
      "namespace erg {\nstruct Part {\n  struct Inner {\n  };\n};\nclass Known;\n}  // namespace erg\n");
  std::istringstream second(
      "namespace erg {\nnamespace {\nstruct Own {\n};\n}  // namespace\nclass Part final : public Whole {\n};\n");
  add_types("first", first, files_of);
  add_types("second", second, files_of);
  EXPECT_EQ(files_of, (Names{{"Part", {"first", "second"}}}));
}

}  // namespace
}  // namespace erg::test
