// Meshes: read back by hand, and held against the terrain.
#include "io/formats/mesh.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <map>
#include <sstream>

#include "core/errors.h"
#include "temporary_folder.h"

namespace erg {

using io::write_obj;

namespace {

using Point = std::array<float, 3>;

/// 5 x 4 cells of 2 m, quanta of half a metre, uneven; sand of one quantum everywhere.
Terrain hills() {
  Terrain terrain({5, 4}, 2.0, 0.5);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 5; ++x) {
      terrain.edit_bedrock()(x, y) = (7 * x + 3 * y * y) % 11 - 4;
      terrain.edit_mobile()(x, y) = 1;
    }
  }
  return terrain;
}

Point corner(const Terrain& terrain, int x, int y) {
  return {2.0f * (static_cast<float>(x) + 0.5f), 2.0f * (static_cast<float>(y) + 0.5f),
          0.5f * static_cast<float>(terrain.height(x, y))};
}

template <typename T>
T take(const std::string& bytes, std::size_t& at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  at += sizeof value;
  return value;
}

float upward(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

const io::Provenance source{
    .config = "{\n}", .seed = 7, .step = 40, .model = "werner", .version = "9", .executor = "cpu"};

TEST(Mesh, ObjHasTheSurfaceInMetres) {
  const TemporaryFolder folder;
  const Terrain terrain = hills();
  write_obj(folder / "dunes.obj", terrain, source);
  std::istringstream lines(read_bytes(folder / "dunes.obj"));
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::string comments;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(1));
    Point point{};
    std::array<std::size_t, 3> corners{};
    if (line[0] == '#') comments += line + "\n";
    if (line[0] == 'v' && words >> point[0] >> point[1] >> point[2]) points.push_back(point);
    if (line[0] == 'f' && words >> corners[0] >> corners[1] >> corners[2]) triangles.push_back(corners);
  }
  ASSERT_EQ(points.size(), 20u);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 5; ++x) {
      EXPECT_EQ(points[static_cast<std::size_t>(5 * y + x)], corner(terrain, x, y)) << x << ", " << y;
    }
  }
  ASSERT_EQ(triangles.size(), 24u);
  float area = 0;
  for (const auto& corners : triangles) {
    const float twice = upward(points.at(corners[0] - 1), points.at(corners[1] - 1), points.at(corners[2] - 1));
    EXPECT_GT(twice, 0) << "seen from above, counter-clockwise";
    area += twice / 2;
  }
  EXPECT_FLOAT_EQ(area, 8 * 6) << "in plan, between the outer cells' centres";
  EXPECT_NE(comments.find("# erg:seed: 7\n"), std::string::npos) << comments;
}

TEST(Mesh, PlyHasTheSameAndTheThickness) {
  const TemporaryFolder folder;
  const Terrain terrain = hills();
  io::write_ply(folder / "dunes.ply", terrain, source);
  const std::string bytes = read_bytes(folder / "dunes.ply");
  EXPECT_NE(bytes.find("element vertex 20\n"), std::string::npos);
  EXPECT_NE(bytes.find("element face 24\n"), std::string::npos);
  std::size_t at = bytes.find("end_header\n") + 11;
  ASSERT_EQ(bytes.size() - at, 20 * 16 + 24 * 13u);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 5; ++x) {
      EXPECT_EQ(take<Point>(bytes, at), corner(terrain, x, y));
      EXPECT_EQ(take<float>(bytes, at), 0.5f);
    }
  }
  for (int triangle = 0; triangle < 24; ++triangle) {
    EXPECT_EQ(take<std::uint8_t>(bytes, at), 3);
    for (const std::uint32_t index : take<std::array<std::uint32_t, 3>>(bytes, at)) EXPECT_LT(index, 20u);
  }
}

TEST(Mesh, StlIsAClosedBody) {
  const TemporaryFolder folder;
  io::write_stl(folder / "dunes.stl", hills(), source);
  const std::string bytes = read_bytes(folder / "dunes.stl");
  EXPECT_FALSE(bytes.starts_with("solid")) << "that is how the text form begins";
  std::size_t at = 80;
  const auto triangles = take<std::uint32_t>(bytes, at);
  ASSERT_EQ(bytes.size(), 84 + 50u * triangles);
  // In a closed body each edge is run along once in either direction.
  std::map<std::pair<Point, Point>, int> edges;
  double volume = 0;
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const auto normal = take<Point>(bytes, at);
    const auto corners = take<std::array<Point, 3>>(bytes, at);
    take<std::uint16_t>(bytes, at);
    EXPECT_NEAR(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2], 1, 1e-5);
    for (std::size_t side = 0; side < 3; ++side) ++edges[{corners[side], corners[(side + 1) % 3]}];
    const auto& [a, b, c] = corners;
    volume += (a[0] * (static_cast<double>(b[1]) * c[2] - static_cast<double>(b[2]) * c[1]) +
               a[1] * (static_cast<double>(b[2]) * c[0] - static_cast<double>(b[0]) * c[2]) +
               a[2] * (static_cast<double>(b[0]) * c[1] - static_cast<double>(b[1]) * c[0])) /
              6;
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  EXPECT_GT(volume, 48 * 0.8) << "its walls face outward, and its floor lies a tenth of 8 m below";
}

TEST(Mesh, OneRowOfCellsIsNoSurface) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_obj(folder / "x.obj", Terrain({5, 1}, 1, 1), source), InputError);
}

}  // namespace
}  // namespace erg
