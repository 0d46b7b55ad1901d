// The layers: nothing includes what lies above it. Which arrows there are is read from src/CMakeLists.txt alone.
#include <gtest/gtest.h>

#include <utility>

#include "source_tree.h"

namespace erg::test {
namespace {

bool runs_up(const std::string& path, const std::string& included) {
  return !may_include(layer_of(path)).contains(layer_of(included));
}

TEST(Layers, NoIncludeRunsUp) {
  ASSERT_GT(source_tree().size(), 100U);
  for (const auto& [path, includes] : source_tree()) {
    ASSERT_TRUE(arrows().contains(layer_of(path))) << path << " lies in no layer of src/CMakeLists.txt";
    for (const std::string& included : includes) {
      EXPECT_TRUE(source_tree().contains(included)) << path << " includes " << included << ", which is not in src/";
      EXPECT_FALSE(runs_up(path, included)) << path << " includes " << included << ": the layer " << layer_of(path)
                                            << " does not link " << layer_of(included);
    }
  }
}

TEST(Layers, AFileLiesInTheInnermostLayerAroundIt) {
  EXPECT_EQ(layer_of("io/files/given_file.h"), "io/files");
  EXPECT_EQ(layer_of("render/without/osmesa_context.cpp"), "render");
}

TEST(Layers, AnIncludeThatRunsUpOrAcrossIsSeen) {
  EXPECT_TRUE(runs_up("core/grid.h", "forcing/wind_schedule.h"));
  EXPECT_TRUE(runs_up("models/model.h", "sim/config.h"));
  EXPECT_TRUE(runs_up("analysis/fourier.h", "forcing/bearing.h")) << "beside, not below";
  EXPECT_TRUE(runs_up("render/camera.h", "io/formats/png.h"));
  EXPECT_TRUE(runs_up("io/files/given_file.h", "io/config/config_file.h")) << "between the folders of a folder too";
  EXPECT_FALSE(runs_up("io/config/config_file.h", "io/files/given_file.h"));
  EXPECT_FALSE(runs_up("forcing/wind_schedule.h", "core/grid.h"));
  EXPECT_FALSE(runs_up("app/bench/bench.h", "core/grid.h"));
}

// No other folder than the window's could be built without a screen.
TEST(Layers, OnlyTheWindowKnowsFreeglutAndX) {
  int found = 0;
  for (const auto& [path, includes] : source_tree()) {
    const std::string text = read_text(source_root() / "src" / path);
    if (text.find("#include <GL/freeglut") == std::string::npos && text.find("#include <X11/") == std::string::npos)
      continue;
    ++found;
    EXPECT_EQ(layer_of(path), "ui/window") << path;
  }
  EXPECT_GT(found, 1);
}

// The row of a layer in the table of docs/architecture.md: | `layer` | what it holds | what it links |
std::set<std::string> links_on_the_page(const std::string& page, const std::string& layer) {
  const std::size_t row = page.find("\n| `" + layer + "` |");
  if (row == std::string::npos) return {"no row"};
  const std::string line = page.substr(row + 1, page.find('\n', row + 1) - row - 1);
  const std::size_t end = line.rfind('|');
  const std::size_t begin = line.rfind('|', end - 1);
  std::set<std::string> names;
  std::string name;
  for (const char letter : line.substr(begin + 1, end - begin - 1) + ",") {
    if ((letter >= 'a' && letter <= 'z') || letter == '/') {
      name += letter;
    } else if (!name.empty() && letter == ',') {
      names.insert(std::exchange(name, ""));
    }
  }
  return names;
}

TEST(Layers, TheArchitecturePageHasTheSameArrows) {
  const std::string page = read_text(source_root() / "docs" / "architecture.md");
  for (const auto& [layer, links] : arrows()) EXPECT_EQ(links_on_the_page(page, layer), links) << layer;
}

}  // namespace
}  // namespace erg::test
