#include "io/formats/mesh.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/errors.h"
#include "core/surface_range.h"
#include "io/files/atomic_file.h"
#include "io/files/raw_bytes.h"
#include "io/formats/comments.h"

namespace erg::io {
namespace {

using Point = std::array<float, 3>;
using Corners = std::array<std::uint32_t, 3>;

constexpr int progress_rows = 32;  // rows between two calls of the progress

Point corner(const Terrain& terrain, int x, int y) {
  return {static_cast<float>((x + 0.5) * terrain.cell_size()), static_cast<float>((y + 0.5) * terrain.cell_size()),
          static_cast<float>(terrain.metres(terrain.height(x, y)))};
}

/// The two triangles of a square of four corners, counter-clockwise seen from above.
std::array<Corners, 2> square(const Terrain& terrain, int x, int y) {
  const auto nx = static_cast<std::uint32_t>(terrain.nx());
  const std::uint32_t here = static_cast<std::uint32_t>(y) * nx + static_cast<std::uint32_t>(x);
  return {{{here, here + 1, here + nx + 1}, {here, here + nx + 1, here + nx}}};
}

void check_extent(const std::filesystem::path& path, const Terrain& terrain) {
  check_whole(terrain);
  if (terrain.nx() >= 2 && terrain.ny() >= 2) return;
  throw InputError(path.string(), "a grid one cell wide has no surface", "take at least two cells each way");
}

/// Hands over rows in pieces and asks now and then whether to go on.
class RowWriter {
 public:
  RowWriter(const ByteSink& sink, const WriteProgress& progress, int rows)
      : sink_(sink), progress_(progress), rows_(rows) {}

  std::string& text() { return text_; }
  void end_row() {
    if (++done_ % progress_rows != 0 && done_ != rows_) return;
    sink_(text_);
    text_.clear();
    if (progress_ && !progress_(static_cast<double>(done_) / rows_)) throw StoppedWriting{};
  }

 private:
  const ByteSink& sink_;
  const WriteProgress& progress_;
  int rows_;
  int done_ = 0;
  std::string text_;
};

void append_number(std::string& text, float value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  text.append(" ").append(digits, end);
}

/// The triangles of the closed body of an STL file.
class Solid {
 public:
  explicit Solid(const Terrain& terrain) : terrain_(terrain) {
    const double side = std::min(terrain.nx(), terrain.ny()) * terrain.cell_size();
    floor_ = static_cast<float>(terrain.metres(surface_range(terrain).low) - side / 10);
  }

  /// Of the surface: two a square; of each wall two a square; of the floor two a square, so that all edges meet.
  std::uint32_t triangles() const {
    const auto columns = static_cast<std::uint32_t>(terrain_.nx() - 1);
    const auto rows = static_cast<std::uint32_t>(terrain_.ny() - 1);
    return 4 * columns * rows + 4 * (columns + rows);
  }

  /// Surface and floor between rows y and y + 1, and the walls at their ends.
  void append_row(int y, std::string& bytes) const {
    for (int x = 0; x + 1 < terrain_.nx(); ++x) {
      const Point a = top(x, y), b = top(x + 1, y), c = top(x + 1, y + 1), d = top(x, y + 1);
      triangle(a, b, c, bytes);
      triangle(a, c, d, bytes);
      triangle(below(a), below(c), below(b), bytes);
      triangle(below(a), below(d), below(c), bytes);
    }
    const int east = terrain_.nx() - 1;
    wall(top(0, y + 1), top(0, y), bytes);
    wall(top(east, y), top(east, y + 1), bytes);
  }

  /// The walls along the southern and the northern edge.
  void append_ends(std::string& bytes) const {
    const int north = terrain_.ny() - 1;
    for (int x = 0; x + 1 < terrain_.nx(); ++x) {
      wall(top(x, 0), top(x + 1, 0), bytes);
      wall(top(x + 1, north), top(x, north), bytes);
    }
  }

 private:
  Point top(int x, int y) const { return corner(terrain_, x, y); }
  Point below(Point point) const { return {point[0], point[1], floor_}; }

  /// Two triangles below the edge from `left` to `right`, as seen from outside.
  void wall(Point left, Point right, std::string& bytes) const {
    triangle(below(left), below(right), right, bytes);
    triangle(below(left), right, left, bytes);
  }

  static void triangle(Point a, Point b, Point c, std::string& bytes) {
    const float ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
    const float vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
    Point normal{uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
    const float length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    for (float& part : normal) part = length > 0 ? part / length : 0;
    for (const Point& point : {normal, a, b, c}) append_raw(bytes, point);
    append_raw(bytes, std::uint16_t{0});
  }

  const Terrain& terrain_;
  float floor_ = 0;
};

}  // namespace

void write_obj(const std::filesystem::path& path, const Terrain& terrain, const Provenance& provenance,
               const WriteProgress& progress) {
  check_extent(path, terrain);
  const MetadataEntries source = metadata_of_file(path, provenance);
  write_file_atomically(path, [&](const ByteSink& sink) {
    sink(comments("# ", source));
    RowWriter rows(sink, progress, 2 * terrain.ny() - 1);
    for (int y = 0; y < terrain.ny(); ++y, rows.end_row()) {
      for (int x = 0; x < terrain.nx(); ++x) {
        rows.text() += 'v';
        for (const float part : corner(terrain, x, y)) append_number(rows.text(), part);
        rows.text() += '\n';
      }
    }
    for (int y = 0; y + 1 < terrain.ny(); ++y, rows.end_row()) {
      for (int x = 0; x + 1 < terrain.nx(); ++x) {
        for (const Corners& triangle : square(terrain, x, y)) {
          rows.text() += 'f';
          for (const std::uint32_t index : triangle) rows.text().append(" ").append(std::to_string(index + 1));
          rows.text() += '\n';
        }
      }
    }
  });
}

void write_ply(const std::filesystem::path& path, const Terrain& terrain, const Provenance& provenance,
               const WriteProgress& progress) {
  check_extent(path, terrain);
  const std::size_t triangles =
      2 * static_cast<std::size_t>(terrain.nx() - 1) * static_cast<std::size_t>(terrain.ny() - 1);
  const MetadataEntries source = metadata_of_file(path, provenance);
  write_file_atomically(path, [&](const ByteSink& sink) {
    sink("ply\nformat binary_little_endian 1.0\n" + comments("comment ", source) + "element vertex " +
         std::to_string(terrain.extent().cells()) +
         "\nproperty float x\nproperty float y\nproperty float z\nproperty float thickness\nelement face " +
         std::to_string(triangles) + "\nproperty list uchar int vertex_indices\nend_header\n");
    RowWriter rows(sink, progress, 2 * terrain.ny() - 1);
    for (int y = 0; y < terrain.ny(); ++y, rows.end_row()) {
      for (int x = 0; x < terrain.nx(); ++x) {
        append_raw(rows.text(), corner(terrain, x, y));
        append_raw(rows.text(), static_cast<float>(terrain.metres(terrain.mobile()(x, y))));
      }
    }
    for (int y = 0; y + 1 < terrain.ny(); ++y, rows.end_row()) {
      for (int x = 0; x + 1 < terrain.nx(); ++x) {
        for (const Corners& triangle : square(terrain, x, y)) {
          append_raw(rows.text(), std::uint8_t{3});
          append_raw(rows.text(), triangle);
        }
      }
    }
  });
}

void write_stl(const std::filesystem::path& path, const Terrain& terrain, const Provenance& provenance,
               const WriteProgress& progress) {
  check_extent(path, terrain);
  const Solid solid(terrain);
  write_file_atomically(path, [&](const ByteSink& sink) {
    // A header that begins with "solid" would be taken for the text form.
    std::string header = "erg " + provenance.version + ", " + provenance.model + ", seed " +
                         std::to_string(provenance.seed) + ", step " + std::to_string(provenance.step);
    header.resize(80, '\0');
    append_raw(header, solid.triangles());
    sink(header);
    RowWriter rows(sink, progress, terrain.ny());
    for (int y = 0; y + 1 < terrain.ny(); ++y, rows.end_row()) solid.append_row(y, rows.text());
    solid.append_ends(rows.text());
    rows.end_row();
  });
}

}  // namespace erg::io
