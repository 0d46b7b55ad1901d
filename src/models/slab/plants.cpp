#include "models/slab/plants.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace erg::models {
namespace {

// Fields, in their order on the terrain.
enum PlantField : std::size_t { vegetation, first_species, balance = first_species + 3, last_year };

constexpr std::uint64_t before_the_first_step = std::numeric_limits<std::uint64_t>::max();
enum PlantDraw : std::uint64_t { draw_scatter = 40, draw_lateral, draw_establishment };

struct SpeciesInfo {
  const char* key;
  const char* label;
  bool grows;
  double low;
  double high;
  std::vector<CurvePoint> growth;
  const char* source;
};

const std::array<SpeciesInfo, 3>& species_infos() {
  static const std::array<SpeciesInfo, 3> infos{
      {{"grass",
        "grass",
        true,
        0,
        1,
        {{-1.4, -1}, {0.1, 0}, {0.45, 0.4}, {0.85, 0}, {1.4, -1}},
        "Nield & Baas 2008; vertices as in published code of the DECAL family"},
       {"mesquite",
        "mesquite",
        true,
        -1,
        3,
        {{-1.3, -1}, {0.1, 0}, {0.6, 0.5}, {1.5, 0}, {2.2, -1}},
        "estimated: fitted to published pictures, no table found; range: Cimbura 2022, eq. 4.6"},
       {"shrub",
        "shrub",
        false,
        -0.5,
        1.5,
        {{-1.3, -1}, {-0.65, 0}, {0, 0.1}, {0.2, 0}, {2.2, -1}},
        "Nield & Baas 2008; vertices as in published code of the DECAL family"}}};
  return infos;
}

// A rectangle in shares of the grid.
struct Rectangle {
  double west, south, east, north;
};
constexpr std::array<Rectangle, 3> vegetated_islands = {
    {{0.12, 0.62, 0.32, 0.84}, {0.40, 0.16, 0.60, 0.38}, {0.66, 0.52, 0.86, 0.74}}};

// Bare patches: middles in shares of the grid, and their size in m along x and y.
constexpr std::array<CurvePoint, 3> blowout_middles = {{{0.20, 0.20}, {0.30, 0.50}, {0.20, 0.80}}};
constexpr double blowout_length = 6;
constexpr double blowout_width = 5;

Binding<PlantValues>::Entries plant_parameters() {
  Binding<PlantValues>::Entries parameters{
      {&PlantValues::steps_per_year,
       {.key = "steps_per_year",
        .label = "Steps a year",
        .default_value = 80,
        .minimum = 1,
        .maximum = 100000,
        .meaning = "Plants change after so many time steps.",
        .source = "Cimbura 2022, table 6.4"}},
      {&PlantValues::vegetation,
       {.key = "vegetation",
        .label = "Plants at the start",
        .default_value = "natural",
        .choices = {"natural", "blowouts", "islands", "random", "painted", "image"},
        .meaning = "natural, painted: none, they come up where the balance suits them or are painted in; blowouts: "
                   "all over but for three bare patches of 6 m by 5 m; islands: in three rectangles; random: each "
                   "cell at random from 0 to twice the start values; image: where a picture is bright.",
        .source = "Cimbura 2022, section 6.4",
        .at_start = true}}};
  parameters.push_back(
      {&PlantValues::vegetation_image,
       {.key = "vegetation_image",
        .label = "Picture of plants",
        .default_value = "",
        .meaning = "Grey picture (PNG): white has the start values, black none; relative to the config file.",
        .active_if = {"vegetation", "image"},
        .at_start = true}});
  parameters.push_back({&PlantValues::scatter,
                        {.key = "scatter",
                         .label = "Scattered start",
                         .default_value = false,
                         .meaning = "Each cell starts at random from 0 to twice the start values.",
                         .source = "Cimbura 2022, table 6.6",
                         .active_if = {"vegetation", "blowouts", "islands", "image"},
                         .at_start = true}});
  for (std::size_t k = 0; k < species_count; ++k) {
    const SpeciesInfo& info = species_infos()[k];
    const auto member = [k](auto PlantSpecies::*of_it) {
      return [ k, of_it ](PlantValues & values) -> auto& { return values.species[k].*of_it; };
    };
    const std::string key = info.key;
    const std::string name = info.label;
    parameters.push_back({member(&PlantSpecies::grows),
                          {.key = key,
                           .label = "With " + name,
                           .default_value = info.grows,
                           .meaning = "Whether there is " + name + "."}});
    parameters.push_back({member(&PlantSpecies::start),
                          {.key = key + "_start",
                           .label = "Start of " + name,
                           .default_value = 0.0,
                           .minimum = -1,
                           .maximum = 3,
                           .meaning = "Effectiveness rho of " + name + " where there are plants at first.",
                           .active_if = {"vegetation", "blowouts", "islands", "random", "image"},
                           .at_start = true}});
    parameters.push_back({member(&PlantSpecies::low),
                          {.key = key + "_low",
                           .label = "Least " + name,
                           .default_value = info.low,
                           .minimum = -10,
                           .maximum = 0,
                           .meaning = "Lowest rho of " + name + ": how far the ground may be spoilt for it.",
                           .source = "Cimbura 2022, eq. 4.6"}});
    parameters.push_back({member(&PlantSpecies::high),
                          {.key = key + "_high",
                           .label = "Most " + name,
                           .default_value = info.high,
                           .minimum = 0,
                           .maximum = 10,
                           .meaning = "Highest rho of " + name + ": how much of it may die before it holds less.",
                           .source = "Cimbura 2022, eq. 4.6"}});
    parameters.push_back({member(&PlantSpecies::growth),
                          {.key = key + "_growth",
                           .label = "Growth of " + name,
                           .unit = "1/yr",
                           .default_value = PiecewiseLinear{info.growth},
                           .minimum = -10,
                           .maximum = 10,
                           .x_label = "balance, m/yr",
                           .x_minimum = -10,
                           .x_maximum = 10,
                           .meaning = "Change of rho in a year by the cell's balance of sand.",
                           .source = info.source}});
  }
  parameters.push_back({&PlantValues::spreading,
                        {.key = "spreading",
                         .label = "Spreading",
                         .default_value = false,
                         .meaning = "Off: plants come up in every cell that suits them; on: only beside others or "
                                    "from seeds, by the two chances below.",
                         .source = "Nield & Baas 2008"}});
  parameters.push_back({&PlantValues::lateral_chance,
                        {.key = "lateral_chance",
                         .label = "Lateral spread",
                         .unit = "1/yr",
                         .default_value = 0.2,
                         .minimum = 0,
                         .maximum = 1,
                         .meaning = "With spreading: chance that a bare cell beside plants gets some in a year."}});
  parameters.push_back({&PlantValues::establishment_chance,
                        {.key = "establishment_chance",
                         .label = "Establishment",
                         .unit = "1/yr",
                         .default_value = 0.05,
                         .minimum = 0,
                         .maximum = 1,
                         .meaning = "With spreading: chance that any bare cell gets plants in a year."}});
  return parameters;
}

}  // namespace

const Binding<PlantValues>& plant_binding() {
  static const Binding<PlantValues> binding(plant_parameters());
  return binding;
}

std::vector<FieldInfo> plant_fields() {
  std::vector<FieldInfo> fields{{"vegetation", "vegetation", "", 0, 1, "vegetation",
                                 "Effectiveness of all plants: the sum over the species, within 0 to 1."}};
  for (const SpeciesInfo& info : species_infos()) {
    fields.push_back({info.key, info.label, "", info.low, info.high, "vegetation",
                      std::string("Effectiveness rho of ") + info.label + "."});
  }
  fields.push_back({"balance", "yearly balance", "m/yr", -2, 2, "RdYlGn", "Sand gained in the last year."});
  fields.push_back({"last_year", "thickness last year", "slabs", 0, 100, "batlow",
                    "Thickness of the sand when the plants last changed."});
  return fields;
}

std::vector<std::string> painted_plants() {
  std::vector<std::string> keys;
  for (const SpeciesInfo& info : species_infos()) keys.emplace_back(info.key);
  return keys;
}

Plants::Plants(const PlantValues& values, std::uint64_t seed)
    : values_(values), planting_{seed, before_the_first_step} {
  values_.scatter = values_.scatter || values_.vegetation == "random";
}

void Plants::begin(Terrain& terrain, const Grid<float>* picture) {
  if (!terrain.fields().empty()) return;
  std::vector<Field>& fields = terrain.edit_fields();
  for (FieldInfo& info : plant_fields()) fields.push_back({std::move(info), Grid<float>(terrain.extent())});
  std::size_t cell = 0;
  for (int y = 0; y < terrain.ny(); ++y) {
    for (int x = 0; x < terrain.nx(); ++x, ++cell) {
      const float share = start_share(x, y, terrain, picture);
      for (std::size_t k = 0; k < species_count; ++k) {
        const PlantSpecies& species = values_.species[k];
        if (!species.grows) continue;
        fields[first_species + k].values[cell] = std::clamp(share * species.start, species.low, species.high);
      }
      fields[vegetation].values[cell] = std::clamp(total(terrain, cell), 0.0f, 1.0f);
      fields[last_year].values[cell] = static_cast<float>(terrain.mobile()[cell]);
    }
  }
}

float Plants::start_share(int x, int y, const Terrain& terrain, const Grid<float>* picture) const {
  const Extent extent = terrain.extent();
  const std::size_t cell = terrain.mobile().index(x, y);
  const double east = x + 0.5;
  const double north = y + 0.5;
  float share = 0;
  if (values_.vegetation == "random") share = 1;
  if (values_.vegetation == "blowouts") {
    share = 1;
    for (const CurvePoint& middle : blowout_middles) {
      const bool bare = std::abs(east - middle.x * extent.nx) * terrain.cell_size() < 0.5 * blowout_length &&
                        std::abs(north - middle.y * extent.ny) * terrain.cell_size() < 0.5 * blowout_width;
      if (bare) share = 0;
    }
  }
  if (values_.vegetation == "islands") {
    for (const Rectangle& island : vegetated_islands) {
      const bool inside = east >= island.west * extent.nx && east < island.east * extent.nx &&
                          north >= island.south * extent.ny && north < island.north * extent.ny;
      if (inside) share = 1;
    }
  }
  if (values_.vegetation == "image" && picture != nullptr) share = (*picture)[cell];
  return values_.scatter ? share * static_cast<float>(2 * random_unit(planting_, 0, cell, draw_scatter)) : share;
}

float Plants::total(const Terrain& terrain, std::size_t cell) {
  float sum = 0;
  for (std::size_t k = 0; k < species_count; ++k) sum += terrain.fields()[first_species + k].values[cell];
  return sum;
}

const Cover& Plants::cover(Terrain& terrain) {
  if (fields_stamp_ == terrain.fields_stamp()) return cover_;
  CoverField& made = cover_.edit();
  made = CoverField(terrain.extent());
  Grid<float>& shown = terrain.edit_fields()[vegetation].values;
  for (std::size_t cell = 0; cell < made.size(); ++cell) {
    shown[cell] = std::clamp(total(terrain, cell), 0.0f, 1.0f);
    made[cell] = cover_of(shown[cell]);
  }
  fields_stamp_ = terrain.fields_stamp();
  return cover_;
}

bool Plants::comes_up(const Grid<std::uint8_t>& stood, std::size_t cell, std::size_t species, StepKey key) const {
  if (!values_.spreading || stood[cell] != 0) return true;
  const std::uint64_t number = species << 8;
  if (random_unit(key, number, cell, draw_establishment) < values_.establishment_chance) return true;
  const int x = static_cast<int>(cell % static_cast<std::size_t>(stood.nx()));
  const int y = static_cast<int>(cell / static_cast<std::size_t>(stood.nx()));
  const bool beside = stood.wrapped(x - 1, y) != 0 || stood.wrapped(x + 1, y) != 0 || stood.wrapped(x, y - 1) != 0 ||
                      stood.wrapped(x, y + 1) != 0;
  return beside && random_unit(key, number, cell, draw_lateral) < values_.lateral_chance;
}

bool Plants::grow(Terrain& terrain, StepKey key, compute::Executor& executor) {
  std::vector<Field>& fields = terrain.edit_fields();
  std::array<Grid<std::uint8_t>, species_count> stood;  // 1 where a species held sand before, while plants spread
  for (std::size_t k = 0; values_.spreading && k < species_count; ++k) {
    stood[k] = Grid<std::uint8_t>(terrain.extent());
    std::ranges::transform(fields[first_species + k].values.cells(), stood[k].cells().begin(),
                           [](float rho) { return static_cast<std::uint8_t>(rho > 0); });
  }
  std::atomic<bool> alive{terrain.boundary() == Boundary::open && terrain.inflow() > 0};
  const Grid<std::int32_t>& mobile = terrain.mobile();
  executor.parallel_for(static_cast<std::int64_t>(mobile.size()), [&](std::int64_t begin, std::int64_t end) {
    bool changes = false;
    for (auto cell = static_cast<std::size_t>(begin); cell < static_cast<std::size_t>(end); ++cell) {
      const float slabs = static_cast<float>(mobile[cell]);
      const double gained = (mobile[cell] - static_cast<double>(fields[last_year].values[cell])) * terrain.quantum();
      fields[balance].values[cell] = static_cast<float>(gained);
      fields[last_year].values[cell] = slabs;
      for (std::size_t k = 0; k < species_count; ++k) {
        const PlantSpecies& species = values_.species[k];
        if (!species.grows) continue;
        float& rho = fields[first_species + k].values[cell];
        const double change = species.growth.at(gained);
        if (change > 0 && !comes_up(stood[k], cell, k, key)) continue;
        const float grown = std::clamp(static_cast<float>(rho + change), species.low, species.high);
        changes = changes || grown != rho;
        rho = grown;
      }
      const float acting = std::clamp(total(terrain, cell), 0.0f, 1.0f);
      fields[vegetation].values[cell] = acting;
      changes = changes || gained != 0 || (slabs > 0 && cover_of(acting) < 255);
    }
    if (changes) alive.store(true, std::memory_order_relaxed);
  });
  return !alive.load();
}

}  // namespace erg::models
