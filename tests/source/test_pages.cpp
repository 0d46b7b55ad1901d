// The pages: what they quote stands in the file that they name, and what they link to is there.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "source_tree.h"

namespace erg::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> pages() {
  std::vector<fs::path> found;
  for (const char* name : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"}) found.push_back(source_root() / name);
  for (const auto& entry : fs::recursive_directory_iterator(source_root() / "docs")) {
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  }
  return found;
}

// A block of code after the line <!-- from FILE -->.
struct Quote {
  std::string file;
  std::string text;
};

std::vector<Quote> quotes(const std::string& page) {
  static const std::regex form("<!-- from ([^ ]+) -->\\n```[a-z]*\\n");
  std::vector<Quote> found;
  for (std::sregex_iterator at(page.begin(), page.end(), form), end; at != end; ++at) {
    const auto begin = static_cast<std::size_t>(at->position() + at->length());
    found.push_back({(*at)[1], page.substr(begin, page.find("```\n", begin) - begin)});
  }
  return found;
}

// A line "..." stands for lines that are left out: what is around it stands in the file, in this order.
bool stands_in(const std::string& quote, const std::string& file) {
  static const std::string gap = "...\n";
  std::size_t from = 0;
  for (std::size_t begin = 0; begin <= quote.size();) {
    const std::size_t end = std::min(quote.find("\n" + gap, begin), quote.size() - 1) + 1;
    const std::string part = quote.substr(begin, end - begin);
    const std::size_t place = file.find(part, from);
    if (place == std::string::npos) return false;
    from = place + part.size();
    begin = end + gap.size();
  }
  return true;
}

TEST(Pages, QuoteWhatStandsInTheFile) {
  int checked = 0;
  for (const fs::path& path : pages()) {
    for (const Quote& quote : quotes(read_text(path))) {
      EXPECT_TRUE(stands_in(quote.text, read_text(source_root() / quote.file)))
          << path << " quotes what does not stand in " << quote.file << ":\n"
          << quote.text;
      ++checked;
    }
  }
  EXPECT_GE(checked, 4);
}

TEST(Pages, AQuoteThatHasRottedIsSeen) {
  EXPECT_TRUE(stands_in("a\nb\n", "x\na\nb\ny\n"));
  EXPECT_TRUE(stands_in("a\n...\nc\n", "a\nb\nc\n"));
  EXPECT_FALSE(stands_in("a\nc\n", "a\nb\nc\n"));
  EXPECT_FALSE(stands_in("c\n...\na\n", "a\nb\nc\n"));
  EXPECT_EQ(quotes("<!-- from f.cpp -->\n```cpp\nint a;\n```\n").at(0).text, "int a;\n");
}

TEST(Pages, LinkToWhatIsThere) {
  static const std::regex link("\\]\\(([^)#: ]+)(#[^)]*)?\\)");
  int checked = 0;
  for (const fs::path& path : pages()) {
    const std::string page = read_text(path);
    for (std::sregex_iterator at(page.begin(), page.end(), link), end; at != end; ++at) {
      EXPECT_TRUE(fs::exists(path.parent_path() / (*at)[1].str())) << path << " links to " << (*at)[1];
      ++checked;
    }
  }
  EXPECT_GT(checked, 40);
}

}  // namespace
}  // namespace erg::test
