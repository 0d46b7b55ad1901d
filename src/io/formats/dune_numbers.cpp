#include "io/formats/dune_numbers.h"

#include <cmath>
#include <limits>

#include "core/units.h"
#include "forcing/bearing.h"

namespace erg::io {

using analysis::DuneWay;
using analysis::Horns;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double days_a_year = seconds_a_year / seconds_a_day;

/// Cells a step.
double speed(const MeasuredDunes& moment, const MeasuredDune& dune) {
  if (dune.steps == 0) return unknown;
  return std::hypot(dune.way.east, dune.way.north) / moment.cell_size / static_cast<double>(dune.steps);
}

/// m a year, of a speed in cells a step.
double speed_a_year(const MeasuredDunes& moment, double cells_a_step) {
  return cells_a_step * moment.cell_size / moment.days_a_step * days_a_year;
}

/// The bearing toward which something has gone.
double toward(const DuneWay& way) {
  return way.east == 0 && way.north == 0 ? unknown : forcing::bearing_of({-way.east, -way.north});
}

/// Mean and spread of those numbers that are known.
class Mean {
 public:
  void add(double value) {
    if (!std::isfinite(value)) return;
    ++count_;
    sum_ += value;
    squares_ += value * value;
  }
  double count() const { return count_; }
  double mean() const { return count_ > 0 ? sum_ / count_ : unknown; }
  double spread() const {
    return count_ > 1 ? std::sqrt(std::max(0.0, squares_ - sum_ * sum_ / count_) / (count_ - 1)) : unknown;
  }

 private:
  double count_ = 0;
  double sum_ = 0;
  double squares_ = 0;
};

template <typename Number>
Mean mean_of(const MeasuredDunes& moment, Number number) {
  Mean mean;
  for (const MeasuredDune& dune : moment.dunes) mean.add(number(dune));
  return mean;
}

/// The bearing toward which the dunes move: of the sum of their velocities.
double mean_toward(const MeasuredDunes& moment) {
  DuneWay all;
  for (const MeasuredDune& dune : moment.dunes) {
    if (dune.steps == 0) continue;
    all.east += dune.way.east / static_cast<double>(dune.steps);
    all.north += dune.way.north / static_cast<double>(dune.steps);
  }
  return toward(all);
}

}  // namespace

const std::vector<RunNumber>& dune_numbers() {
  static const std::vector<RunNumber> numbers{
      {"step", "Step", "", "Steps done."},
      {"days", "Time", "days", "Time since the start, by what a step of the model stands for."},
      {"dune", "Dune", "", "Its number, which stays with it."},
      {"x", "East", "m", "Middle of its sand, from the grid's south-west corner."},
      {"y", "North", "m", "Likewise."},
      {"height", "Height", "m", "Of its thickest column over the sand between dunes."},
      {"width", "Width", "m", "Of its outline across the wind."},
      {"length", "Length", "m", "Of its outline along the wind, horns and all."},
      {"volume", "Volume", "m³", "Sand within its outline over the sand between dunes."},
      {"horn_left", "Left horn", "m", "How far it reaches beyond the bay, looking downwind; none without two horns."},
      {"horn_right", "Right horn", "m", "Likewise."},
      {"slip_face", "Slip face", "deg", "Its slope: the median over lee cells steeper than 20°."},
      {"speed", "Speed", "cells/step", "Of the middle of its sand, over the steps that follow."},
      {"speed_a_year", "Speed", "m/year", "The same by what a step of the model stands for."},
      {"toward", "Toward", "deg", "Bearing toward which it moves, clockwise from north."}};
  return numbers;
}

std::vector<double> dune_row(const MeasuredDunes& moment, const MeasuredDune& dune) {
  const analysis::Dune& shape = dune.dune;
  return {static_cast<double>(moment.step),
          moment.days,
          static_cast<double>(dune.number),
          shape.x,
          shape.y,
          shape.height,
          shape.width,
          shape.length,
          shape.volume,
          shape.horns ? shape.horns->left : unknown,
          shape.horns ? shape.horns->right : unknown,
          shape.slip_face.value_or(unknown),
          speed(moment, dune),
          speed_a_year(moment, speed(moment, dune)),
          dune.steps > 0 ? toward(dune.way) : unknown};
}

const std::vector<RunNumber>& field_numbers() {
  static const std::vector<RunNumber> numbers{
      {"step", "Step", "", "Steps done."},
      {"days", "Time", "days", "Time since the start, by what a step of the model stands for."},
      {"dunes", "Dunes", "", "How many."},
      {"endless", "Endless ridges", "", "Ridges that reach around the torus: not among the dunes."},
      {"cut", "Cut off", "", "Dunes that an open edge cuts off: not among the dunes."},
      {"sand_share", "Sand in dunes", "", "Share of all sand that lies in the dunes."},
      {"height", "Height", "m", "Mean."},
      {"height_sd", "Spread of heights", "m", "Standard deviation, as the others."},
      {"width", "Width", "m", "Mean."},
      {"width_sd", "Spread of widths", "m", ""},
      {"length", "Length", "m", "Mean."},
      {"length_sd", "Spread of lengths", "m", ""},
      {"volume", "Volume", "m³", "Mean."},
      {"volume_sd", "Spread of volumes", "m³", ""},
      {"horned", "With two horns", "", "How many of the dunes."},
      {"horn_left", "Left horn", "m", "Mean of those with two."},
      {"horn_right", "Right horn", "m", "Likewise."},
      {"slip_face", "Slip face", "deg", "Mean of those that have one."},
      {"speed", "Speed", "cells/step", "Mean."},
      {"speed_sd", "Spread of speeds", "cells/step", ""},
      {"speed_a_year", "Speed", "m/year", "Mean."},
      {"toward", "Toward", "deg", "Bearing toward which they move together."},
      {"crest_spacing", "Spacing of crests", "m", "From crest to crest along the wind, counted; endless ridges too."},
      {"crest_bearing", "Crests run", "deg", "Axis along which crests run; none where alignment is low."},
      {"alignment", "Alignment", "", "How far all crests run one way: 1 all, 0 none."}};
  return numbers;
}

std::vector<double> field_row(const MeasuredDunes& moment) {
  const Mean height = mean_of(moment, [](const MeasuredDune& dune) { return dune.dune.height; });
  const Mean width = mean_of(moment, [](const MeasuredDune& dune) { return dune.dune.width; });
  const Mean length = mean_of(moment, [](const MeasuredDune& dune) { return dune.dune.length; });
  const Mean volume = mean_of(moment, [](const MeasuredDune& dune) { return dune.dune.volume; });
  const auto horn = [](const MeasuredDune& dune, double Horns::*side) {
    return dune.dune.horns ? (*dune.dune.horns).*side : unknown;
  };
  const Mean left = mean_of(moment, [&](const MeasuredDune& dune) { return horn(dune, &Horns::left); });
  const Mean right = mean_of(moment, [&](const MeasuredDune& dune) { return horn(dune, &Horns::right); });
  const Mean slip = mean_of(moment, [](const MeasuredDune& dune) { return dune.dune.slip_face.value_or(unknown); });
  const Mean speeds = mean_of(moment, [&](const MeasuredDune& dune) { return speed(moment, dune); });
  return {static_cast<double>(moment.step),
          moment.days,
          static_cast<double>(moment.dunes.size()),
          static_cast<double>(moment.outlines.endless),
          static_cast<double>(moment.outlines.cut),
          moment.sand_share,
          height.mean(),
          height.spread(),
          width.mean(),
          width.spread(),
          length.mean(),
          length.spread(),
          volume.mean(),
          volume.spread(),
          left.count(),
          left.mean(),
          right.mean(),
          slip.mean(),
          speeds.mean(),
          speeds.spread(),
          speed_a_year(moment, speeds.mean()),
          mean_toward(moment),
          moment.crest_spacing > 0 ? moment.crest_spacing : unknown,
          moment.spectrum.crest_bearing.value_or(unknown),
          moment.spectrum.alignment};
}

}  // namespace erg::io
