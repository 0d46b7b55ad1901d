#include "session/wind_editor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "forcing/bearing.h"
#include "sim/config.h"

namespace erg::session {
namespace {

using Place = std::ptrdiff_t;

std::string season_place(std::size_t index) { return "season " + std::to_string(index + 1); }

bool in_unit_square(const CurvePoint& point) { return point.x >= 0 && point.x <= 1 && point.y >= 0 && point.y <= 1; }

std::optional<Mistake> set_strength(double& held, double strength, const std::string& place) {
  if (auto mistake = check_value(sim::strength_parameter(), strength, place)) return mistake;
  held = strength;
  return std::nullopt;
}

}  // namespace

std::size_t WindEditor::duplicate(std::size_t index) {
  const Season copy = regime_->seasons.at(index);
  regime_->seasons.insert(regime_->seasons.begin() + static_cast<Place>(index + 1), copy);
  return index + 1;
}

std::size_t WindEditor::add() {
  regime_->seasons.push_back(standard());
  return regime_->seasons.size() - 1;
}

bool WindEditor::remove(std::size_t index) {
  if (seasons() < 2 || index >= seasons()) return false;
  regime_->seasons.erase(regime_->seasons.begin() + static_cast<Place>(index));
  return true;
}

bool WindEditor::move_up(std::size_t index) {
  if (index == 0 || index >= seasons()) return false;
  std::swap(regime_->seasons[index - 1], regime_->seasons[index]);
  return true;
}

bool WindEditor::move_down(std::size_t index) { return index + 1 < seasons() && move_up(index + 1); }

void WindEditor::reset() { *regime_ = standard_; }

std::optional<Mistake> WindEditor::set_bearing(std::size_t index, double degrees) {
  if (!(std::abs(degrees) <= largest_bearing)) {
    return Mistake{season_place(index), "this is no bearing", std::string("expected ") + accepted_bearings};
  }
  regime_->seasons.at(index).bearing = fold_bearing(degrees);
  return std::nullopt;
}

std::optional<Mistake> WindEditor::set_bearing(std::size_t index, std::string_view text) {
  try {
    regime_->seasons.at(index).bearing = parse_bearing(text, season_place(index));
  } catch (const InputError& error) {
    return error.mistakes().front();
  }
  return std::nullopt;
}

std::optional<Mistake> WindEditor::set_first(std::size_t index, double strength) {
  return set_strength(regime_->seasons.at(index).first, strength, season_place(index));
}

std::optional<Mistake> WindEditor::set_last(std::size_t index, double strength) {
  return set_strength(regime_->seasons.at(index).last, strength, season_place(index));
}

std::optional<Mistake> WindEditor::set_steps(std::size_t index, std::int64_t steps) {
  if (auto mistake = check_value(sim::season_steps_parameter(), steps, season_place(index))) return mistake;
  regime_->seasons.at(index).steps = steps;
  return std::nullopt;
}

std::optional<Mistake> WindEditor::set_spread(std::size_t index, double degrees) {
  if (auto mistake = check_value(sim::season_spread_parameter(), degrees, season_place(index))) return mistake;
  regime_->seasons.at(index).spread = degrees;
  return std::nullopt;
}

std::optional<Mistake> WindEditor::set_hold(std::size_t index, std::int64_t steps) {
  if (auto mistake = check_value(sim::season_hold_parameter(), steps, season_place(index))) return mistake;
  regime_->seasons.at(index).hold = steps;
  return std::nullopt;
}

std::optional<Mistake> WindEditor::set_snowfall(std::size_t index, double snowfall) {
  if (auto mistake = check_value(sim::season_snowfall_parameter(), snowfall, season_place(index))) return mistake;
  regime_->seasons.at(index).snowfall = snowfall;
  return std::nullopt;
}

std::optional<Mistake> check_curve(const BezierCurve& curve, const std::string& place) {
  if (in_unit_square(curve.first) && in_unit_square(curve.second)) return std::nullopt;
  return Mistake{place, "a control point lies outside the curve's square", "expected x and y in 0 to 1"};
}

std::optional<Mistake> WindEditor::set_curve(std::size_t index, const BezierCurve& curve) {
  if (auto mistake = check_curve(curve, season_place(index))) return mistake;
  regime_->seasons.at(index).curve = curve;
  return std::nullopt;
}

}  // namespace erg::session
