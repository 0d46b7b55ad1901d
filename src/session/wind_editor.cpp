#include "session/wind_editor.h"

#include <algorithm>
#include <utility>

#include "forcing/bearing.h"

namespace erg::session {
namespace {

using Place = std::ptrdiff_t;

std::string season_place(std::size_t index) { return "season " + std::to_string(index + 1); }

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

void WindEditor::replace(std::vector<Season> seasons) {
  if (!seasons.empty()) regime_->seasons = std::move(seasons);
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

std::optional<Mistake> WindEditor::set(std::size_t index, std::string_view key, const ParameterValue& value) {
  try {
    set_in_season(regime_->seasons.at(index), key, value);
  } catch (const InputError& error) {
    Mistake mistake = error.mistakes().front();
    mistake.place = season_place(index);
    return mistake;
  }
  return std::nullopt;
}

ParameterValue WindEditor::value(std::size_t index, std::string_view key) const {
  return row_of(season(index), season_columns()).value(key);
}

std::optional<Mistake> WindEditor::set_bearing(std::size_t index, std::string_view text) {
  try {
    regime_->seasons.at(index).bearing = parse_bearing(text, season_place(index));
  } catch (const InputError& error) {
    return error.mistakes().front();
  }
  return std::nullopt;
}

}  // namespace erg::session
