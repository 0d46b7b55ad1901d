#include "session/wind_editor.h"

#include <algorithm>
#include <utility>

#include "forcing/bearing.h"

namespace erg::session {

using forcing::WindInterval;

namespace {

using Place = std::ptrdiff_t;

std::string season_place(std::size_t index) { return "season " + std::to_string(index + 1); }

}  // namespace

std::size_t WindEditor::duplicate(std::size_t index) {
  const WindInterval copy = schedule_->intervals.at(index);
  schedule_->intervals.insert(schedule_->intervals.begin() + static_cast<Place>(index + 1), copy);
  return index + 1;
}

std::size_t WindEditor::add() {
  schedule_->intervals.push_back(standard());
  return schedule_->intervals.size() - 1;
}

void WindEditor::replace(std::vector<WindInterval> seasons) {
  if (!seasons.empty()) schedule_->intervals = std::move(seasons);
}

bool WindEditor::remove(std::size_t index) {
  if (seasons() < 2 || index >= seasons()) return false;
  schedule_->intervals.erase(schedule_->intervals.begin() + static_cast<Place>(index));
  return true;
}

bool WindEditor::move_up(std::size_t index) {
  if (index == 0 || index >= seasons()) return false;
  std::swap(schedule_->intervals[index - 1], schedule_->intervals[index]);
  return true;
}

bool WindEditor::move_down(std::size_t index) { return index + 1 < seasons() && move_up(index + 1); }

void WindEditor::reset() { *schedule_ = standard_; }

std::optional<Mistake> WindEditor::set(std::size_t index, std::string_view key, const ParameterValue& value) {
  try {
    forcing::set_in_interval(schedule_->intervals.at(index), key, value);
  } catch (const InputError& error) {
    Mistake mistake = error.mistakes().front();
    mistake.place = season_place(index);
    return mistake;
  }
  return std::nullopt;
}

ParameterValue WindEditor::value(std::size_t index, std::string_view key) const {
  return forcing::row_of(season(index), forcing::interval_columns()).value(key);
}

std::optional<Mistake> WindEditor::set_bearing(std::size_t index, std::string_view text) {
  try {
    schedule_->intervals.at(index).bearing = forcing::parse_bearing(text, season_place(index));
  } catch (const InputError& error) {
    return error.mistakes().front();
  }
  return std::nullopt;
}

}  // namespace erg::session
