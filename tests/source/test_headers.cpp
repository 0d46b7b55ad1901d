// Every header compiles alone: one that relies on what others happen to include before it is seen. Headers that include
// each other are compiled in one file, in an order in which each still stands alone (header_chains.h): that takes half
// the time of a file for each.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "header_chains.h"
#include "source_tree.h"

namespace erg::test {
namespace {

namespace fs = std::filesystem;

/// A folder that goes with it.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "erg-headers-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// What the compiler says against the headers of `root` in these chains, each chain a file of its own; "" when it takes
/// them all.
std::string refusal(const fs::path& root, const std::vector<HeaderChain>& chains) {
  const Folder folder;
  std::string command = ERG_COMPILE " -fsyntax-only -I'" + root.string() + "'";
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const fs::path file = folder.path() / ("chain" + std::to_string(i) + ".cpp");
    std::ofstream text(file);
    for (const std::string& header : chains[i]) text << "#include \"" << header << "\"\n";
    command += " '" + file.string() + "'";
  }
  const fs::path log = folder.path() / "log";
  const int status = std::system((command + " > '" + log.string() + "' 2>&1").c_str());
  return status == 0 ? "" : "refused: " + read_text(log).substr(0, 4000);
}

/// The chains whose last header lies in a layer.
const std::map<std::string, std::vector<HeaderChain>>& chains_of_layers() {
  static const std::map<std::string, std::vector<HeaderChain>> found = [] {
    std::map<std::string, std::vector<HeaderChain>> of_layers;
    for (const HeaderChain& chain : header_chains(source_tree())) of_layers[layer_of(chain.back())].push_back(chain);
    return of_layers;
  }();
  return found;
}

class HeadersOf : public testing::TestWithParam<std::string> {};

TEST_P(HeadersOf, CompileAlone) { EXPECT_EQ(refusal(source_root() / "src", chains_of_layers().at(GetParam())), ""); }

std::vector<std::string> layers() {
  std::vector<std::string> names;
  for (const auto& [layer, chains] : chains_of_layers()) names.push_back(layer);
  return names;
}
INSTANTIATE_TEST_SUITE_P(EachLayer, HeadersOf, testing::ValuesIn(layers()), [](const auto& of) {
  std::string name = of.param;
  std::ranges::replace(name, '/', '_');
  return name;
});

// Or a chain would prove less than its headers one by one.
TEST(Headers, StandInOneChainEachBehindNothingButWhatTheyInclude) {
  std::vector<std::string> held;
  for (const auto& [layer, chains] : chains_of_layers()) {
    for (const HeaderChain& chain : chains) {
      for (std::size_t i = 0; i < chain.size(); ++i) {
        held.push_back(chain[i]);
        if (i > 0) EXPECT_TRUE(included_at_last(source_tree(), chain[i]).contains(chain[i - 1])) << chain[i];
      }
    }
  }
  std::ranges::sort(held);
  std::vector<std::string> headers;
  for (const auto& [path, includes] : source_tree()) {
    if (path.ends_with(".h")) headers.push_back(path);
  }
  EXPECT_EQ(held, headers);
}

// What a header includes has to be there before its own text, in a chain as alone.
TEST(Headers, IncludeBeforeTheyDeclare) {
  for (const auto& [path, includes] : source_tree()) {
    if (!path.ends_with(".h")) continue;
    std::istringstream text(read_text(source_root() / "src" / path));
    bool declares = false;
    for (std::string line; std::getline(text, line);) {
      if (line.starts_with("namespace")) declares = true;
      const bool is_text = line.ends_with(".def\"") || line.ends_with(".k\"");  // read in where its lines are wanted
      EXPECT_FALSE(declares && line.starts_with("#include") && !is_text) << path << ": " << line;
    }
  }
}

TEST(Headers, AsFewChainsAsThereCanBe) {
  const Includes tree{{"a.h", {}},        {"b.h", {"a.h"}}, {"c.h", {"a.h"}},  {"d.h", {"b.h", "x.inl"}},
                      {"x.inl", {"e.h"}}, {"e.h", {}},      {"f.cpp", {"c.h"}}};
  // a.h stands before one of its users, b.h or e.h before d.h.
  EXPECT_EQ(header_chains(tree).size(), 3U);
}

TEST(Headers, OneThatDoesNotCompileAloneIsSeen) {
  const Folder folder;
  std::ofstream(folder.path() / "whole.h") << "#include <vector>\nstd::vector<int> numbers();\n";
  std::ofstream(folder.path() / "needs.h") << "std::vector<int> others();\n";
  std::ofstream(folder.path() / "user.h") << "#include <vector>\n#include \"needs.h\"\n";
  EXPECT_EQ(refusal(folder.path(), {{"whole.h"}}), "");
  for (const std::vector<HeaderChain>& chains :
       {std::vector<HeaderChain>{{"whole.h"}, {"needs.h"}}, {{"needs.h", "user.h"}}}) {
    const std::string said = refusal(folder.path(), chains);
    EXPECT_NE(said.find("needs.h:1"), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace erg::test
