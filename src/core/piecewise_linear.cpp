#include "core/piecewise_linear.h"

#include <charconv>

#include "core/number_text.h"

namespace erg {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::optional<double> number_from(std::string_view text) {
  text = trimmed(text);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number + 0.0;  // turns -0 into 0
}

}  // namespace

double PiecewiseLinear::at(double x) const {
  if (vertices.empty()) return 0;
  if (x <= vertices.front().x) return vertices.front().y;
  for (std::size_t k = 1; k < vertices.size(); ++k) {
    const CurvePoint& from = vertices[k - 1];
    const CurvePoint& to = vertices[k];
    if (x < to.x) return from.y + (to.y - from.y) * ((x - from.x) / (to.x - from.x));
  }
  return vertices.back().y;
}

std::string vertices_text(const PiecewiseLinear& curve) {
  std::string text;
  for (const CurvePoint& vertex : curve.vertices) {
    if (!text.empty()) text += ", ";
    text += format_shortest(vertex.x) + ":" + format_shortest(vertex.y);
  }
  return text;
}

std::optional<PiecewiseLinear> parse_vertices(std::string_view text) {
  PiecewiseLinear curve;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::string_view vertex = text.substr(0, comma);
    const std::size_t colon = vertex.find(':');
    if (colon == std::string_view::npos) return std::nullopt;
    const auto x = number_from(vertex.substr(0, colon));
    const auto y = number_from(vertex.substr(colon + 1));
    if (!x || !y) return std::nullopt;
    curve.vertices.push_back({*x, *y});
    if (comma == std::string_view::npos) return curve;
    text.remove_prefix(comma + 1);
  }
}

}  // namespace erg
