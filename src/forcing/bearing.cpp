#include "forcing/bearing.h"

#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "core/errors.h"
#include "core/units.h"

namespace erg::forcing {
namespace {

constexpr double compass_point = 22.5;
constexpr std::array<std::string_view, 16> compass{"n", "nne", "ne", "ene", "e", "ese", "se", "sse",
                                                   "s", "ssw", "sw", "wsw", "w", "wnw", "nw", "nnw"};

/// (sin, cos) of 0 to 90 degrees, the same numbers swapped at 90 - angle, so that wind from any octant sees the same
/// geometry to the bit.
Direction sine_cosine(double angle) {
  if (angle == 45) return {std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2};
  if (angle < 45) return {std::sin(radians(angle)), std::cos(radians(angle))};
  return {std::cos(radians(90 - angle)), std::sin(radians(90 - angle))};
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// "South-West" -> "sw".
std::string point_name(std::string_view text) {
  std::string name;
  for (const char c : text) {
    if (c == '-' || c == ' ' || c == '_') continue;
    name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  replace_all(name, "north", "n");
  replace_all(name, "east", "e");
  replace_all(name, "south", "s");
  replace_all(name, "west", "w");
  return name;
}

}  // namespace

Direction downwind(double bearing) {
  const double folded = fold_bearing(bearing);
  const int quadrant = static_cast<int>(folded / 90);
  const auto [sine, cosine] = sine_cosine(folded - 90 * quadrant);
  switch (quadrant) {
    case 0:
      return {0 - sine, 0 - cosine};
    case 1:
      return {0 - cosine, sine};
    case 2:
      return {sine, cosine};
    default:
      return {cosine, 0 - sine};
  }
}

double bearing_of(Direction toward) { return fold_bearing(degrees(std::atan2(0 - toward.x, 0 - toward.y))); }

std::string compass_name(double bearing) {
  const auto point = static_cast<std::size_t>(std::lround(fold_bearing(bearing) / compass_point)) % compass.size();
  std::string name(compass[point]);
  for (char& letter : name) letter = static_cast<char>(letter - 'a' + 'A');
  return name;
}

double parse_bearing(std::string_view text, const std::string& place) {
  const std::string name = point_name(text);
  for (std::size_t point = 0; point < compass.size(); ++point) {
    if (name == compass[point]) return compass_point * static_cast<double>(point);
  }
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc{} && end == text.data() + text.size();
  if (is_number && std::abs(number) <= largest_bearing) return fold_bearing(number);
  throw InputError(place, "bearing is " + quote(text), std::string("expected ") + accepted_bearings);
}

}  // namespace erg::forcing
