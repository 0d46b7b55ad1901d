// The section of laws of nature: which there are, and what their rows share.
#include "app/validate/validation_nature.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/join.h"

namespace erg::app {

using sim::Config;
using sim::set_from_text;
using sim::Simulation;

namespace {

struct NatureLaw {
  const char* name;
  std::string (*measure)(const ValidationOptions&);
};

constexpr NatureLaw nature_laws[] = {
    {"crests", crests_under_two_winds}, {"speed", speed_against_height},
    {"barchans", barchan_shape},        {"collision", barchan_collision},
    {"stars", star_dune_arms},          {"growth", growth_of_crests},
    {"ripples", ripples_against_wind},  {"sintering", sintering_slows_mounds},
    {"plants", plants_make_shapes},
};

}  // namespace

std::vector<std::string> nature_law_names() {
  std::vector<std::string> names;
  for (const NatureLaw& law : nature_laws) names.emplace_back(law.name);
  return names;
}

std::string nature_section(const ValidationOptions& options) {
  std::string section =
      "## Laws of nature\n\nWhat dunes, ripples and snow do outside, beside what these models do: on `cpu` with K 16, "
      "spread over the seeds in brackets. *holds*: within the bound that is stated; *partly*: within twice that; "
      "**fails**: neither. A law that fails is a limit of the published rules or of ours; where it was found out "
      "which, "
      "the text beside the table says so. `erg validate --section nature --law NAME` measures one of them: " +
      join(nature_law_names(), ", ") + ".\n";
  for (const NatureLaw& law : nature_laws) {
    if (options.law == law.name) return law.measure(options);
    if (options.law.empty()) section += "\n" + law.measure(options);
  }
  return section;
}

std::string verdict(double error, double bound) {
  if (std::abs(error) <= bound) return "holds";
  return std::abs(error) <= 2 * bound ? "partly" : "**fails**";
}

double power_law(const std::vector<double>& x, const std::vector<double>& y) {
  double sum_a = 0;
  double sum_b = 0;
  double sum_aa = 0;
  double sum_ab = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double a = std::log(x[i]);
    const double b = std::log(y[i]);
    sum_a += a;
    sum_b += b;
    sum_aa += a * a;
    sum_ab += a * b;
  }
  const auto n = static_cast<double>(x.size());
  return (n * sum_ab - sum_a * sum_b) / (n * sum_aa - sum_a * sum_a);
}

Config nature_config(const std::string& model, const std::vector<std::string>& settings) {
  Config config(model);
  for (const std::string& setting : settings) set_from_text(config, setting);
  set_from_text(config, "run.executor=cpu");
  set_from_text(config, "run.threads=1");
  return config;
}

Simulation lone_cones(const Config& config, const std::vector<Cone>& cones) {
  Simulation simulation(config);
  Grid<std::int32_t>& sand = simulation.edit_terrain().edit_mobile();
  for (const Cone& cone : cones) {
    const double radius = cone.height * cells_wide_a_slab / 2;
    const auto reach = static_cast<int>(std::ceil(radius));
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        const double thick = cone.height * (1 - std::hypot(dx, dy) / radius);
        std::int32_t& cell = sand(wrap(cone.x + dx, sand.nx()), wrap(cone.y + dy, sand.ny()));
        cell = std::max(cell, static_cast<std::int32_t>(std::lround(thick)));
      }
    }
  }
  simulation.book_edit();
  return simulation;
}

void say_measuring(const std::string& law, int runs) {
  std::fprintf(stderr, "validate: nature, %s, %s\n", law.c_str(), count_text(runs, "run").c_str());
}

}  // namespace erg::app
