// The two executors beside each other.
#include <algorithm>
#include <cmath>

#include "app/cli/text_table.h"
#include "app/validate/sample.h"
#include "app/validate/validation.h"

namespace erg::app {

using sim::Config;
using sim::set_from_text;

namespace {

/// A column of the executors' table.
struct Column {
  std::string heading;
  int digits;
  std::function<double(const SeedRun&)> number;
};

double sd_at(const SeedRun& run, std::int64_t step) {
  for (const auto& [at, sd] : run.sd_at) {
    if (at == step) return sd;
  }
  return 0;
}

double speed(const SeedRun& run) { return std::hypot(run.end.migration.x, run.end.migration.y); }

std::vector<Column> statistics_columns(const std::vector<std::int64_t>& watch) {
  std::vector<Column> columns;
  columns.reserve(watch.size() + 5);
  for (const std::int64_t step : watch) {
    columns.push_back({"sd at " + std::to_string(step), 2, [step](const SeedRun& run) { return sd_at(run, step); }});
  }
  columns.push_back({"max", 1, [](const SeedRun& run) { return run.end.shape.max_slabs; }});
  columns.push_back({"bare", 3, [](const SeedRun& run) { return run.end.shape.bare_fraction; }});
  columns.push_back({"shadow", 3, [](const SeedRun& run) { return run.end.shadow_fraction; }});
  columns.push_back({"wavelength", 1, [](const SeedRun& run) { return run.end.spectrum.wavelength; }});
  columns.push_back({"migration", 3, speed});
  return columns;
}

/// The difference of two means in percent, marked where neither 5% nor the seeds' spread covers it; "0" where it does
/// not show in so many digits.
std::string difference_text(const Sample& reference, const Sample& other, int digits) {
  const double difference = other.mean() - reference.mean();
  if (std::abs(difference) < 0.5 * std::pow(10.0, -digits)) return "0";
  const bool covered = std::abs(difference) <= 0.05 * std::abs(reference.mean()) ||
                       std::abs(difference) <= std::max(reference.spread(), other.spread());
  const std::string text = fixed_text(difference / reference.mean() * 100, 1) + "%";
  return covered ? text : "**" + text + "**";
}

struct NamedConfig {
  std::string name;
  Config config;
};

std::vector<NamedConfig> statistics_configs(std::int64_t steps) {
  std::vector<NamedConfig> configs{{"Werner barchans", thesis_config("werner_barchans")},
                                   {"Werner transverse", thesis_config("werner_transverse")},
                                   {"Werner barchans, non-repeated polling", thesis_config("werner_barchans")},
                                   {"Momiji barchans", thesis_config("momiji_barchans")}};
  set_from_text(configs[2].config, "parameters.polling=nonrepeated");
  for (NamedConfig& named : configs) {
    set_from_text(named.config, "run.steps=" + std::to_string(steps));
    named.config.title = named.name;
  }
  return configs;
}

/// Sample of every column for one executor.
std::vector<Sample> measure_columns(const Config& config, const char* executor, int seeds,
                                    const std::vector<std::int64_t>& watch, const std::vector<Column>& columns) {
  const std::vector<SeedRun> runs = run_seeds(config, executor, seeds, watch);
  std::vector<Sample> samples;
  samples.reserve(columns.size());
  for (const Column& column : columns) samples.push_back(sample_of(runs, column.number));
  return samples;
}

}  // namespace

std::string executors_section(const ValidationOptions& options) {
  const int seeds = options.quick ? 2 : 12;
  const std::vector<std::int64_t> watch =
      options.quick ? std::vector<std::int64_t>{100, 200} : std::vector<std::int64_t>{200, 400, 1000};
  const std::vector<Column> columns = statistics_columns(watch);
  TextTable table;
  table.heading = {"scene", "executor"};
  for (const Column& column : columns) table.heading.push_back(column.heading);

  for (const NamedConfig& named : statistics_configs(watch.back())) {
    const std::vector<Sample> serial = measure_columns(named.config, "serial", seeds, watch, columns);
    const std::vector<Sample> cpu = measure_columns(named.config, "cpu", seeds, watch, columns);
    std::vector<std::string> serial_row{named.name, "serial"};
    std::vector<std::string> cpu_row{"", "cpu"};
    std::vector<std::string> difference_row{"", "difference"};
    for (std::size_t i = 0; i < columns.size(); ++i) {
      serial_row.push_back(serial[i].text(columns[i].digits));
      cpu_row.push_back(cpu[i].text(columns[i].digits));
      difference_row.push_back(difference_text(serial[i], cpu[i], columns[i].digits));
    }
    table.rows.insert(table.rows.end(), {serial_row, cpu_row, difference_row});
  }
  return "## `serial` and `cpu`\n\nAfter " + std::to_string(watch.back()) + " steps, mean over " +
         count_text(seeds, "seed") +
         ", spread over the seeds in brackets; `cpu` with K 16. sd: standard deviation of height, slabs; max: thickest "
         "column, slabs; bare, shadow: share of cells; wavelength: cells; migration: cells a step. Bold: a difference "
         "above 5% that the larger of the two spreads does not cover.\n\n" +
         table.markdown();
}

}  // namespace erg::app
