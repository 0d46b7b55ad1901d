// What programs that link the library may do wrong is an InputError, not a crash, and no wrong mass.
#include "sim/run_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "analysis/bedforms.h"
#include "analysis/dune_outlines.h"
#include "analysis/fourier.h"
#include "analysis/morphometry.h"
#include "analysis/star_arms.h"
#include "core/surface_range.h"
#include "io/checkpoint/checkpoint.h"
#include "io/formats/heightmap.h"
#include "io/formats/mesh.h"
#include "io/formats/picture.h"
#include "io/formats/vti.h"
#include "message.h"
#include "models/model.h"
#include "temporary_folder.h"

namespace erg {

using analysis::find_dunes;
using models::catalogue;
using models::ModelType;
using sim::Config;
using sim::HeightPicture;
using sim::RunState;
using sim::Simulation;

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Config small_config(const std::string& model) {
  Config config(model);
  config.grid.set("nx", std::int64_t{24});
  config.grid.set("ny", std::int64_t{16});
  config.run.set("executor", std::string("cpu"));
  config.run.set("threads", std::int64_t{1});
  return config;
}

using Edit = std::function<void(Terrain&)>;
struct NamedEdit {
  std::string name;
  Edit edit;
};

/// Edits from which no run can go on.
std::vector<NamedEdit> bad_edits(bool has_fields) {
  std::vector<NamedEdit> edits{
      {"a negative cell", [](Terrain& terrain) { terrain.edit_mobile()(3, 4) = -1; }},
      {"the most negative cell",
       [](Terrain& terrain) { terrain.edit_mobile()(3, 4) = std::numeric_limits<std::int32_t>::min(); }},
      {"a huge cell", [](Terrain& terrain) { terrain.edit_mobile()(3, 4) = std::numeric_limits<std::int32_t>::max(); }},
      {"huge bedrock", [](Terrain& terrain) { terrain.edit_bedrock().fill(std::int32_t{1} << 30); }},
      {"deep bedrock",
       [](Terrain& terrain) { terrain.edit_bedrock()(0, 0) = std::numeric_limits<std::int32_t>::min(); }},
      {"a smaller layer",
       [](Terrain& terrain) {
         terrain.edit_mobile() = Grid<std::int32_t>({8, 8}, 3);
       }},
      {"a larger bedrock",
       [](Terrain& terrain) {
         terrain.edit_bedrock() = Grid<std::int32_t>({64, 64});
       }},
      {"turned layers",
       [](Terrain& terrain) {
         terrain.edit_mobile() = Grid<std::int32_t>({16, 24}, 3);
         terrain.edit_bedrock() = Grid<std::int32_t>({16, 24});
       }},
      {"no layers", [](Terrain& terrain) { terrain = Terrain(); }},
      {"another terrain",
       [](Terrain& terrain) {
         terrain = Terrain({24, 16}, 3.5, 7.5);
       }},
      {"an account out of range",
       [](Terrain& terrain) { terrain.ledger().start = std::numeric_limits<std::int64_t>::min(); }}};
  if (!has_fields) return edits;
  edits.push_back({"fields that are gone", [](Terrain& terrain) { terrain.edit_fields().clear(); }});
  edits.push_back({"a field that is gone", [](Terrain& terrain) { terrain.edit_fields().pop_back(); }});
  edits.push_back({"fields in another order",
                   [](Terrain& terrain) { std::swap(terrain.edit_fields().front(), terrain.edit_fields().back()); }});
  edits.push_back({"a field of another extent", [](Terrain& terrain) {
                     terrain.edit_fields().front().values = Grid<float>({3, 3});
                   }});
  edits.push_back(
      {"a value that is no number", [](Terrain& terrain) { terrain.edit_fields().front().values(2, 2) = nan; }});
  edits.push_back(
      {"an endless value", [](Terrain& terrain) { terrain.edit_fields().back().values(2, 2) = HUGE_VALF; }});
  return edits;
}

TEST(LibraryUse, EditsThatNoRunCanGoOnFromAreRefusedAndMended) {
  for (const ModelType& type : catalogue()) {
    for (const auto& [name, edit] : bad_edits(type.fields.size() > 1)) {
      SCOPED_TRACE(type.info.key + ", " + name);
      Simulation simulation(small_config(type.info.key));
      simulation.step();
      const Terrain whole = simulation.terrain();
      edit(simulation.edit_terrain());
      EXPECT_THROW(simulation.book_edit(), InputError);
      EXPECT_THROW(simulation.step(), InputError) << "booked or not, it does not go on";
      Terrain& mended = simulation.edit_terrain();
      mended.edit_bedrock() = whole.bedrock();
      mended = whole;
      mended.edit_mobile() = whole.mobile();  // writes that executors see
      mended.edit_fields() = whole.fields();
      simulation.book_edit();
      simulation.step();
      EXPECT_EQ(simulation.terrain().total_mobile(), simulation.terrain().ledger().expected());
    }
  }
}

TEST(LibraryUse, AnEditThatIsNotBookedIsToldAtTheNextStep) {
  Simulation simulation(small_config("momiji"));
  simulation.edit_terrain().edit_mobile()(1, 1) += 5;
  EXPECT_EQ(message([&] { simulation.step(); }),
            "terrain: it was edited, and the edit was not booked; call book_edit after edit_terrain");
  simulation.book_edit();
  simulation.step();
  EXPECT_EQ(simulation.terrain().ledger().in, 5);
  simulation.edit_terrain();  // to look at, without a change
  EXPECT_EQ(message([&] { simulation.step(); }), "no error");
}

TEST(LibraryUse, AStateOfAnotherRunIsRefused) {
  for (const ModelType& type : catalogue()) {
    SCOPED_TRACE(type.info.key);
    const Config config = small_config(type.info.key);
    EXPECT_THROW(Simulation(config, RunState{}), InputError);
    Simulation run(config);
    const RunState good = run.state();
    EXPECT_EQ(message([&] { Simulation(config, good).step(); }), "no error");
    for (const auto& [name, edit] : bad_edits(type.fields.size() > 1)) {
      if (name == "fields that are gone") continue;  // a model makes them
      RunState bad = good;
      edit(bad.terrain);
      EXPECT_THROW(Simulation(config, bad), InputError) << name;
    }
    RunState short_of_sand = good;
    ++short_of_sand.terrain.ledger().start;
    EXPECT_THROW(Simulation(config, short_of_sand), InputError);
    RunState before_the_start = good;
    before_the_start.step = -1;
    EXPECT_THROW(Simulation(config, before_the_start), InputError);
    Config open = config;
    open.grid.set("boundary", std::string("open"));
    EXPECT_THROW(Simulation(open, good), InputError);
  }
}

TEST(LibraryUse, AConfigWhoseModelWasSwappedByHandIsRefused) {
  for (const ModelType& from : catalogue()) {
    for (const ModelType& to : catalogue()) {
      Config config = small_config(from.info.key);
      config.model = to.info.key;
      const std::string said = message([&] { Simulation(config).step(); });
      bool same_values = from.parameters.all().size() == to.parameters.all().size();
      for (std::size_t k = 0; same_values && k < from.parameters.all().size(); ++k) {
        same_values = from.parameters.all()[k].key == to.parameters.all()[k].key;
      }
      EXPECT_EQ(said == "no error", same_values) << from.info.key << " to " << to.info.key << ": " << said;
    }
  }
  Config unknown;
  unknown.model = "mojimi";
  EXPECT_EQ(message([&] { Simulation{unknown}; }), "model: unknown model \"mojimi\"; did you mean \"momiji\"?");
  Simulation running(small_config("momiji"));
  Config swapped = small_config("momiji");
  swapped.parameters = Config("grains").parameters;
  EXPECT_THROW(running.change(swapped), InputError);
  EXPECT_EQ(message([&] { running.step(); }), "no error") << "it stands as it was";
}

TEST(LibraryUse, WeatherThatCannotBeIsRefused) {
  const std::vector<std::function<void(Config&)>> faults{
      [](Config& config) { config.wind.intervals.clear(); },
      [](Config& config) { config.wind.intervals.front().steps = 0; },
      [](Config& config) { config.wind.intervals.front().steps = -7; },
      [](Config& config) { config.wind.intervals.front().first = nan; },
      [](Config& config) { config.wind.intervals.front().last = 1e300; },
      [](Config& config) { config.wind.intervals.front().bearing = nan; },
      [](Config& config) { config.wind.intervals.front().spread = nan; },
      [](Config& config) { config.wind.intervals.front().hold = 0; },
      [](Config& config) { config.wind.intervals.front().snowfall = -1; },
      [](Config& config) { config.wind.intervals.front().curve.first.x = nan; },
      [](Config& config) { config.weather.temperature.first = nan; },
      [](Config& config) { config.weather.temperature.curve.second.y = 5; }};
  for (std::size_t fault = 0; fault < faults.size(); ++fault) {
    Config config = small_config("snow_sintering");
    faults[fault](config);
    EXPECT_THROW(Simulation(config).step(), InputError) << fault;
    Simulation running(small_config("snow_sintering"));
    EXPECT_THROW(running.change(config), InputError) << fault;
  }
}

TEST(LibraryUse, NothingIsMeasuredOrWrittenOfATerrainWithoutCells) {
  const TemporaryFolder folder;
  Terrain torn({6, 5}, 1, 1);
  torn.edit_mobile() = Grid<std::int32_t>({2, 2});
  for (const Terrain& terrain : {Terrain(), torn}) {
    EXPECT_THROW(state_hash(terrain), InputError);
    EXPECT_THROW(surface_range(terrain), InputError);
    EXPECT_THROW(analysis::measure(terrain), InputError);
    EXPECT_THROW(analysis::measure_bedforms(terrain, 270), InputError);
    EXPECT_THROW(find_dunes(terrain, 270), InputError);
    EXPECT_THROW(analysis::find_stars(terrain, 3), InputError);
    EXPECT_THROW(find_dunes(terrain, 270, analysis::DuneRule{}), InputError);
    EXPECT_THROW(analysis::coarse_surface(terrain, analysis::Layer::surface), InputError);
    EXPECT_THROW(io::write_heightmap(folder / "a.png", terrain, {}), InputError);
    EXPECT_THROW(io::write_obj(folder / "a.obj", terrain, {}), InputError);
    EXPECT_THROW(io::write_ply(folder / "a.ply", terrain, {}), InputError);
    EXPECT_THROW(io::write_stl(folder / "a.stl", terrain, {}), InputError);
    EXPECT_THROW(io::write_vti(folder / "a.vti", terrain, nullptr, {}), InputError);
    EXPECT_THROW(io::draw_picture(terrain, {}), InputError);
    EXPECT_THROW(io::write_checkpoint(folder / "a.checkpoint", Config(), RunState{terrain, 0, {}}), InputError);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(LibraryUse, APictureHasValuesFromBlackToWhite) {
  Config plants = small_config("nield_baas");
  plants.parameters.set("vegetation", std::string("image"));
  Config ground = small_config("werner");
  ground.scene.set("kind", std::string("image"));
  for (const Extent extent : {Extent{24, 16}, Extent{3, 2}}) {
    HeightPicture picture(extent, 0.5f);
    EXPECT_EQ(message([&] { Simulation(plants, nullptr, &picture).step(); }), "no error");
    EXPECT_EQ(message([&] { Simulation(ground, &picture).step(); }), "no error");
    for (const float value : {nan, HUGE_VALF, -0.1f, 1e9f}) {
      picture(1, 1) = value;
      EXPECT_THROW(Simulation(plants, nullptr, &picture), InputError) << value;
      EXPECT_THROW(Simulation(ground, &picture), InputError) << value;
    }
  }
  const HeightPicture empty;
  EXPECT_THROW(Simulation(plants, nullptr, &empty), InputError);
  EXPECT_THROW(Simulation(ground, &empty), InputError);
}

TEST(LibraryUse, ATerrainHasSidesAndLengths) {
  for (const Extent extent : {Extent{0, 0}, Extent{0, 5}, Extent{-1, 5}, Extent{5, largest_side + 1}}) {
    EXPECT_THROW(Terrain(extent, 1, 1), InputError) << extent.nx << " x " << extent.ny;
  }
  for (const double length : {0.0, -1.0, static_cast<double>(nan), HUGE_VAL}) {
    EXPECT_THROW(Terrain({4, 4}, length, 1), InputError) << length;
    EXPECT_THROW(Terrain({4, 4}, 1, length), InputError) << length;
  }
  EXPECT_EQ(Terrain({1, 1}, 1, 1).extent().cells(), 1u);
}

}  // namespace
}  // namespace erg
