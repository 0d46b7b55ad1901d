// Every header compiles alone: the compiler takes each by itself, so one that relies on what others happen to include
// before it is seen.
#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "source_tree.h"

namespace erg::test {
namespace {

namespace fs = std::filesystem;

/// What the compiler says against files, each taken by itself; "" when it takes them all.
std::string refusal(const std::vector<fs::path>& files) {
  const fs::path log = fs::temp_directory_path() / ("erg-headers-" + std::to_string(getpid()) + ".log");
  std::string command = ERG_COMPILE " -fsyntax-only -x c++";
  for (const fs::path& file : files) command += " '" + file.string() + "'";
  const int status = std::system((command + " > '" + log.string() + "' 2>&1").c_str());
  const std::string said = status == 0 ? "" : "refused: " + read_text(log).substr(0, 4000);
  fs::remove(log);
  return said;
}

/// The headers of each layer that has any.
const std::map<std::string, std::vector<fs::path>>& headers() {
  static const std::map<std::string, std::vector<fs::path>> found = [] {
    std::map<std::string, std::vector<fs::path>> of_layers;
    for (const auto& [path, includes] : source_tree()) {
      if (path.ends_with(".h")) of_layers[layer_of(path)].push_back(source_root() / "src" / path);
    }
    return of_layers;
  }();
  return found;
}

class HeadersOf : public testing::TestWithParam<std::string> {};

TEST_P(HeadersOf, CompileAlone) { EXPECT_EQ(refusal(headers().at(GetParam())), ""); }

std::vector<std::string> layers() {
  std::vector<std::string> names;
  for (const auto& [layer, files] : headers()) names.push_back(layer);
  return names;
}
INSTANTIATE_TEST_SUITE_P(EachLayer, HeadersOf, testing::ValuesIn(layers()), [](const auto& of) { return of.param; });

TEST(Headers, OneThatDoesNotCompileAloneIsSeen) {
  const fs::path folder = fs::temp_directory_path() / ("erg-header-" + std::to_string(getpid()));
  fs::create_directory(folder);
  std::ofstream(folder / "whole.h") << "#include <vector>\nstd::vector<int> numbers();\n";
  std::ofstream(folder / "needs.h") << "std::vector<int> others();\n";
  EXPECT_EQ(refusal({folder / "whole.h"}), "");
  const std::string said = refusal({folder / "whole.h", folder / "needs.h"});
  fs::remove_all(folder);
  EXPECT_NE(said.find("needs.h:1"), std::string::npos) << said;
}

}  // namespace
}  // namespace erg::test
