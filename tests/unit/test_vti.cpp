#include "io/formats/vti.h"

#include <gtest/gtest.h>

#include <cstring>
#include <regex>

#include "core/errors.h"
#include "temporary_folder.h"

namespace erg {

using io::write_vti;

namespace {

// What a reader of the format does: finds an array's offset in the XML and reads its block behind the underscore.
template <typename T>
std::vector<T> read_array(const std::string& file, const std::string& name) {
  std::smatch match;
  const std::regex tag("<DataArray type=\"(\\w+)\" Name=\"" + name + "\" format=\"appended\" offset=\"(\\d+)\"/>");
  if (!std::regex_search(file, match, tag)) return {};
  const std::size_t base = file.find("<AppendedData encoding=\"raw\">");
  const std::size_t start = file.find('_', base) + 1 + std::stoul(match[2]);
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, file.data() + start, sizeof bytes);
  std::vector<T> values(bytes / sizeof(T));
  std::memcpy(values.data(), file.data() + start + sizeof bytes, bytes);
  return values;
}

TEST(Vti, HoldsEveryLayerWhereItsHeaderSays) {
  const TemporaryFolder folder;
  Terrain terrain({3, 2}, 2.0, 0.5);
  for (std::size_t cell = 0; cell < 6; ++cell) {
    terrain.edit_mobile()[cell] = static_cast<int>(cell);
    terrain.edit_bedrock()[cell] = -10;
  }
  const Field grass{{"grass", "Grass", "", 0, 1, "vegetation", ""}, Grid<float>({3, 2}, 0.5f)};
  terrain.edit_fields().push_back(grass);
  Grid<std::uint8_t> shadow({3, 2});
  shadow(2, 1) = 1;
  const std::vector<Field> more{{{"flux", "Flux", "lifts/step", 0, 1, "batlow", ""}, Grid<float>({3, 2}, 0.25f)}};
  write_vti(folder / "a.vti", terrain, &shadow, {"{}", 1, 2, "werner", "1.0", "cpu"}, more);
  const std::string file = read_bytes(folder / "a.vti");
  EXPECT_NE(file.find("WholeExtent=\"0 2 0 1 0 0\" Origin=\"1 1 0\" Spacing=\"2 2 2\""), std::string::npos);
  EXPECT_EQ(read_array<float>(file, "sand"), (std::vector<float>{0, 0.5, 1, 1.5, 2, 2.5}));
  EXPECT_EQ(read_array<float>(file, "bedrock"), std::vector<float>(6, -5));
  EXPECT_EQ(read_array<float>(file, "surface"), (std::vector<float>{-5, -4.5, -4, -3.5, -3, -2.5}));
  EXPECT_EQ(read_array<std::uint8_t>(file, "shadow"), (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(read_array<float>(file, "grass"), std::vector<float>(6, 0.5f));
  EXPECT_EQ(read_array<float>(file, "flux"), std::vector<float>(6, 0.25f));
  EXPECT_NE(file.find("Name=\"erg:model\" NumberOfTuples=\"1\" format=\"ascii\">\n        119 101 114 110 101 114 0"),
            std::string::npos);
  EXPECT_TRUE(file.ends_with("</VTKFile>\n"));
  const std::string time = "Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">";
  EXPECT_NE(file.find(time + "2</DataArray>"), std::string::npos) << "the step, where days are not known";
  io::Provenance timed{"{}", 1, 2, "werner", "1.0", "cpu"};
  timed.days = 40.5;
  write_vti(folder / "b.vti", terrain, nullptr, timed);
  EXPECT_NE(read_bytes(folder / "b.vti").find(time + "40.5</DataArray>"), std::string::npos);
}

TEST(Vti, LeavesOutTheShadowWithoutAMap) {
  const TemporaryFolder folder;
  write_vti(folder / "a.vti", Terrain({1, 1}, 1, 1), nullptr, {});
  EXPECT_EQ(read_bytes(folder / "a.vti").find("shadow"), std::string::npos);
  EXPECT_THROW(write_vti("/no/such/folder/a.vti", Terrain({1, 1}, 1, 1), nullptr, {}), InputError);
}

}  // namespace
}  // namespace erg
