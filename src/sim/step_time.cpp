#include "sim/step_time.h"

#include <cstdio>
#include <limits>

#include "core/units.h"
#include "forcing/mean_wind.h"

namespace erg::sim {

using models::find_model;
using models::ModelType;
using models::StepScale;

namespace {

constexpr double seconds_an_hour = 3600;

std::string words(const char* form, double amount) {
  char text[48];
  std::snprintf(text, sizeof text, form, amount);
  return text;
}

std::string volume_text(double square_metres) {
  return words(square_metres < 100 ? "%.3g m²" : "%.0f m²", square_metres);
}

std::string step_text(const StepScale& scale, Material material) {
  const char* sand = material == Material::snow ? "snow" : "sand";
  std::string text = "a step is " + world_time_text(scale.seconds);
  if (scale.seconds < seconds_an_hour) text += words(": an hour is %.0f steps", seconds_an_hour / scale.seconds);
  if (scale.seconds >= seconds_a_day) text += words(" (%.1f a year)", seconds_a_year / scale.seconds);
  if (!(scale.flux > 0)) return text;
  return text + "; in it " + volume_text(scale.flux) + " pass over flat " + sand + ", " +
         volume_text(scale.flux * seconds_a_year / scale.seconds) + " a year";
}

}  // namespace

StepScale step_scale(const Config& config) {
  const ModelType& type = find_model(config.model);
  if (!type.step_scale) return {};
  return type.step_scale(config.parameters, config.grid.real("cell_size"), forcing::mean_strength(config.wind));
}

double days_after(const Config& config, std::int64_t steps) {
  const double seconds = step_scale(config).seconds;
  if (!(seconds > 0)) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(steps) * seconds / seconds_a_day;
}

std::string world_time_text(double seconds) {
  if (seconds < seconds_an_hour) return words("%.4g s", seconds);
  if (seconds < seconds_a_day) return words("%.1f h", seconds / seconds_an_hour);
  if (seconds < seconds_a_year) return words("%.1f days", seconds / seconds_a_day);
  return words("%.1f years", seconds / seconds_a_year);
}

std::vector<std::string> explain(const Config& config) {
  const ModelType& type = find_model(config.model);
  std::vector<std::string> lines = type.explain(config.parameters, config.grid.real("cell_size"));
  const StepScale scale = step_scale(config);
  if (scale.seconds > 0) lines.push_back(step_text(scale, type.info.material));
  return lines;
}

}  // namespace erg::sim
