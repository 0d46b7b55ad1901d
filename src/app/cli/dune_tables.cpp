#include "app/cli/dune_tables.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/text_table.h"
#include "core/number_text.h"
#include "io/config/config_file.h"
#include "io/formats/table.h"

namespace erg::app {

using io::dune_numbers;
using io::dune_row;
using io::field_numbers;
using io::field_row;
using io::MeasuredDune;
using io::MeasuredDunes;
using io::Provenance;
using io::RunNumber;
using io::table_text;

namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys_of(const std::vector<RunNumber>& numbers) {
  std::vector<std::string> keys;
  for (const RunNumber& number : numbers) keys.push_back(number.key);
  return keys;
}

/// As many digits as a person needs to read.
std::string shown(double value, const std::string& unit) {
  if (!std::isfinite(value)) return "-";
  if (value == std::round(value) && unit.empty()) return fixed_text(value, 0);
  const bool whole = unit == "deg" || unit == "days" || std::abs(value) >= 1000;
  return fixed_text(value, whole ? 0 : unit == "cells/step" || unit.empty() ? 3 : 1);
}

std::string with_unit(const RunNumber& number) {
  if (number.unit.empty()) return number.label;
  return number.label + ", " + unit_text(number.unit);
}

/// Columns `first` and on of some rows.
std::string aligned(const std::vector<RunNumber>& numbers, const std::vector<std::vector<double>>& rows,
                    std::size_t first) {
  TextTable table;
  for (std::size_t column = first; column < numbers.size(); ++column) {
    table.heading.push_back(with_unit(numbers[column]));
  }
  for (const std::vector<double>& row : rows) {
    std::vector<std::string> cells;
    for (std::size_t column = first; column < row.size(); ++column) {
      cells.push_back(shown(row[column], numbers[column].unit));
    }
    table.rows.push_back(std::move(cells));
  }
  return table.aligned();
}

std::string rule_text(const analysis::DuneRule& rule) {
  return "Dunes: at least " + std::to_string(rule.smallest) + " cells of sand of " + std::to_string(rule.least) +
         " slabs or more; between them lie " + std::to_string(rule.base) + ".";
}

std::vector<std::vector<double>> dune_rows(const std::vector<MeasuredDunes>& moments) {
  std::vector<std::vector<double>> rows;
  for (const MeasuredDunes& moment : moments) {
    for (const MeasuredDune& dune : moment.dunes) rows.push_back(dune_row(moment, dune));
  }
  return rows;
}

std::vector<std::vector<double>> field_rows(const std::vector<MeasuredDunes>& moments) {
  std::vector<std::vector<double>> rows;
  for (const MeasuredDunes& moment : moments) rows.push_back(field_row(moment));
  return rows;
}

Json object_of(const std::vector<RunNumber>& numbers, const std::vector<double>& row, std::size_t first) {
  Json object;
  for (std::size_t column = first; column < numbers.size(); ++column) {
    object[numbers[column].key] = std::isfinite(row[column]) ? Json(row[column]) : Json(nullptr);
  }
  return object;
}

Json units_of(const std::vector<RunNumber>& numbers) {
  Json units;
  for (const RunNumber& number : numbers) units[number.key] = number.unit.empty() ? "1" : number.unit;
  return units;
}

}  // namespace

std::string dunes_text(const MeasuredDunes& moment) {
  std::string text = "Step " + std::to_string(moment.step) + ", along a wind from " + fixed_text(moment.bearing, 0) +
                     "°. " + rule_text(moment.outlines.rule) + "\n\n";
  constexpr std::size_t from_number_on = 2;
  if (!moment.dunes.empty()) text += aligned(dune_numbers(), dune_rows({moment}), from_number_on) + "\n";
  TextTable together;
  together.heading = {"together", ""};
  const std::vector<double> row = field_row(moment);
  for (std::size_t column = from_number_on; column < row.size(); ++column) {
    const RunNumber& number = field_numbers()[column];
    together.rows.push_back({with_unit(number), shown(row[column], number.unit)});
  }
  return text + together.aligned();
}

std::string fields_text(const std::vector<MeasuredDunes>& moments) {
  return aligned(field_numbers(), field_rows(moments), 0);
}

std::string dunes_csv(const std::vector<MeasuredDunes>& moments, const Provenance& source) {
  return table_text(keys_of(dune_numbers()), dune_rows(moments), source);
}

std::string fields_csv(const std::vector<MeasuredDunes>& moments, const Provenance& source) {
  return table_text(keys_of(field_numbers()), field_rows(moments), source);
}

std::string dunes_json(const std::vector<MeasuredDunes>& moments, const sim::Config& config) {
  Json all;
  all["version"] = io::program_version();
  all["model"] = config.model;
  Json list = Json::array();
  for (const MeasuredDunes& moment : moments) {
    Json one = object_of(field_numbers(), field_row(moment), 0);
    one["bearing"] = moment.bearing;
    one["rule"] = {{"base", moment.outlines.rule.base},
                   {"least", moment.outlines.rule.least},
                   {"smallest", moment.outlines.rule.smallest}};
    Json& dunes = one["each"] = Json::array();
    constexpr std::size_t from_number_on = 2;
    for (const MeasuredDune& dune : moment.dunes) {
      dunes.push_back(object_of(dune_numbers(), dune_row(moment, dune), from_number_on));
    }
    list.push_back(std::move(one));
  }
  all["moments"] = std::move(list);
  Json units = units_of(field_numbers());
  units["bearing"] = "deg";
  all["units"] = std::move(units);
  all["units_of_each"] = units_of(dune_numbers());
  all["config"] = Json::parse(io::config_text(config));
  return all.dump(2) + "\n";
}

}  // namespace erg::app
