// No two types of one name in one namespace: the linker takes the first of two inline functions or tables of one name,
// whoever meant the other, and says nothing. And each layer has a namespace of its own.
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "source_tree.h"

namespace erg::test {
namespace {

using Names = std::map<std::string, std::set<std::string>>;

/// Adds the types that a file defines in the project's namespaces ("erg::io::Provenance"), each with the file: not
/// those of unnamed namespaces, nor of a file taken in by another that opens the namespace, nor those within a type.
/// Relies on the format: what belongs to a namespace is not indented.
void add_types(const std::string& path, std::istream& text, Names& files_of) {
  static const std::regex type(
      R"((?:template <.*> )?(?:class|struct|union|enum|enum class|enum struct) (?:alignas\(\w+\) )?(\w+)(?: final)?(?: :.*| \{.*)?)");
  static const std::regex alias(R"((?:template <.*> )?using (\w+) =.*)");
  static const std::regex opening(R"(namespace (erg(?:::\w+)*) \{)");
  std::string ours;
  bool unnamed = false;
  std::smatch match;
  for (std::string line; std::getline(text, line);) {
    if (std::regex_match(line, match, opening)) ours = match[1];
    if (line == "namespace {") unnamed = true;
    if (line == "}  // namespace") unnamed = false;
    if (ours.empty() || unnamed) continue;
    if (std::regex_match(line, match, type) || std::regex_match(line, match, alias)) {
      files_of[ours + "::" + match[1].str()].insert(path);
    }
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
  EXPECT_TRUE(files_of.contains("erg::Terrain"));
  EXPECT_TRUE(files_of.contains("erg::io::Provenance"));
  EXPECT_TRUE(files_of.contains("erg::session::Snapshot"));
  for (const auto& [name, files] : files_of) EXPECT_EQ(files.size(), 1u) << name << " in" << listed(files);
}

TEST(Names, OfTwoTypesAreSeen) {
  Names files_of;
  std::istringstream first(
      "namespace erg {\nstruct Part {\n  struct Inner {\n  };\n};\nclass Known;\n}  // namespace erg\n");
  std::istringstream second(
      "namespace erg {\nnamespace {\nstruct Own {\n};\n}  // namespace\nclass Part final : public Whole {\n};\n");
  std::istringstream other("namespace erg::ui {\nstruct Part {\n};\n}  // namespace erg::ui\n");
  add_types("first", first, files_of);
  add_types("second", second, files_of);
  add_types("other", other, files_of);
  EXPECT_EQ(files_of, (Names{{"erg::Part", {"first", "second"}}, {"erg::ui::Part", {"other"}}}));
}

/// The namespace of a layer: that of its outermost folder. A family of kernels may have one of its own in it.
std::string namespace_of(const std::string& path) {
  const std::string folder = path.substr(0, path.find('/'));
  return folder == "core" ? "erg" : "erg::" + folder;
}

TEST(Names, OfALayerLieInItsNamespace) {
  static const std::regex opening(R"((?:^|\n)namespace (erg(?:::[a-z]\w*)?))");
  std::set<std::string> seen;
  for (const auto& [path, includes] : source_tree()) {
    const std::string text = read_text(source_root() / "src" / path);
    for (auto found = std::sregex_iterator(text.begin(), text.end(), opening); found != std::sregex_iterator();
         ++found) {
      EXPECT_EQ((*found)[1], namespace_of(path)) << path;
      seen.insert((*found)[1]);
    }
  }
  EXPECT_GT(seen.size(), 13u);
}

}  // namespace
}  // namespace erg::test
