#include "studio/wind_editor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/config.h"
#include "wind/bearing.h"

namespace erg {
namespace {

using Place = std::ptrdiff_t;

std::string season_place(std::size_t index) { return "season " + std::to_string(index + 1); }

bool in_unit_square(const CurvePoint& point) { return point.x >= 0 && point.x <= 1 && point.y >= 0 && point.y <= 1; }

std::optional<Mistake> set_strength(double& held, double strength, const std::string& place) {
  if (auto mistake = check_value(strength_parameter(), strength, place)) return mistake;
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
  regime_->seasons.emplace_back();
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

void WindEditor::reset() { *regime_ = Regime{}; }

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
  if (auto mistake = check_value(season_steps_parameter(), steps, season_place(index))) return mistake;
  regime_->seasons.at(index).steps = steps;
  return std::nullopt;
}

std::optional<Mistake> WindEditor::set_snowfall(std::size_t index, double snowfall) {
  if (auto mistake = check_value(season_snowfall_parameter(), snowfall, season_place(index))) return mistake;
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

std::size_t WindCycle::season_at(std::int64_t step) const {
  const auto after = std::ranges::upper_bound(season_starts, position(step));
  return static_cast<std::size_t>(after - season_starts.begin()) - 1;
}

WindCycle sample_cycle(const Regime& regime, std::size_t samples) {
  WindCycle cycle;
  cycle.length = regime.cycle();
  std::int64_t start = 0;
  for (const Season& season : regime.seasons) {
    cycle.season_starts.push_back(start);
    start += season.steps;
  }
  samples = std::max<std::size_t>(samples, 2);
  for (std::size_t i = 0; i < samples; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(samples - 1);
    const auto step = static_cast<std::int64_t>(std::llround(part * static_cast<double>(cycle.length - 1)));
    const WindNow wind = regime.at(step);
    cycle.steps.push_back(step);
    cycle.bearings.push_back(wind.bearing);
    cycle.strengths.push_back(wind.strength);
  }
  return cycle;
}

namespace {

/// The summed strength of a season's steps [first, last); exact up to `most_samples` steps, sampled evenly beyond.
double summed_strength(const Season& season, std::int64_t first, std::int64_t last) {
  constexpr std::int64_t most_samples = 512;
  const std::int64_t steps = last - first;
  if (steps <= 0) return 0;
  const Regime alone{{season}};
  const std::int64_t samples = std::min(steps, most_samples);
  double sum = 0;
  for (std::int64_t i = 0; i < samples; ++i) sum += alone.at(first + (2 * i + 1) * steps / (2 * samples)).strength;
  return sum * static_cast<double>(steps) / static_cast<double>(samples);
}

/// Adds what blows in steps [0, until) of one cycle.
void add_part(const Regime& regime, std::int64_t until, double weight, std::vector<double>& sums) {
  const double width = 360.0 / static_cast<double>(sums.size());
  for (const Season& season : regime.seasons) {
    const std::int64_t last = std::clamp<std::int64_t>(until, 0, season.steps);
    const auto sector = static_cast<std::size_t>(std::floor(fold_bearing(season.bearing) / width + 0.5)) % sums.size();
    sums[sector] += weight * summed_strength(season, 0, last);
    until -= last;
  }
}

/// The sums over steps [0, until) of the run.
std::vector<double> sums_until(const Regime& regime, std::int64_t until, std::size_t sectors) {
  std::vector<double> sums(sectors, 0.0);
  const std::int64_t cycle = regime.cycle();
  if (until >= cycle) add_part(regime, cycle, static_cast<double>(until / cycle), sums);
  add_part(regime, until % cycle, 1, sums);
  return sums;
}

}  // namespace

double WindRose::largest() const {
  double most = 0;
  for (std::size_t i = 0; i < blown.size(); ++i) most = std::max(most, blown[i] + to_blow[i]);
  return most;
}

WindRose wind_rose(const Regime& regime, std::int64_t now, std::int64_t end, std::size_t sectors) {
  sectors = std::max<std::size_t>(sectors, 4);
  now = std::max<std::int64_t>(now, 0);
  WindRose rose{sums_until(regime, now, sectors), sums_until(regime, std::max(now, end), sectors)};
  for (std::size_t i = 0; i < sectors; ++i) rose.to_blow[i] = std::max(0.0, rose.to_blow[i] - rose.blown[i]);
  return rose;
}

}  // namespace erg
