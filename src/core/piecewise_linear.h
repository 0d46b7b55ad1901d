// A function given by its vertices, as people draw it by hand: straight between them, level beyond the outer two.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/bezier.h"

namespace erg {

/// Vertices with x growing from each to the next; at least two.
struct PiecewiseLinear {
  std::vector<CurvePoint> vertices;

  /// y at x. Beyond the outer vertices it is theirs.
  double at(double x) const;
  bool operator==(const PiecewiseLinear&) const = default;
};

/// The most vertices that a curve may have.
inline constexpr std::size_t most_vertices = 64;

/// "-1.4:-1, 0.1:0, 0.85:0": x and y of each vertex.
std::string vertices_text(const PiecewiseLinear& curve);
/// The way back; nothing where `text` has another form.
std::optional<PiecewiseLinear> parse_vertices(std::string_view text);

}  // namespace erg
