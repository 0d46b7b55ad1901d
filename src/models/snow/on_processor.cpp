#include "models/snow/on_processor.h"

#include <algorithm>
#include <limits>

#include "models/snow/snow_one_by_one.h"

namespace erg::models {

using forcing::Forcing;

StepReport SnowOnProcessor::step(Terrain& terrain, const SnowStep& snow, const Forcing& wind, StepKey key,
                                 compute::Executor& executor) {
  executor_ = &executor;
  begin(terrain, snow, wind, key);
  measure_heights();
  find_shadow(snow.shadow_fall);
  find_rates(snow.radii);
  if (executor.sub_sweeps() == 0) {
    report_ = fly_one_by_one(planes_, ground_, frame_, key);
  } else {
    fly_in_sweeps();
  }
  report_.polls = static_cast<std::int64_t>(terrain.extent().cells());
  report_.travel /= frame_.cosine;
  slide();
  let_snow_fall();
  for_rows([this](int y) { kernels_.rest(planes_, y); });
  if (snow.shows_strength) {
    Grid<float>& strength = snow_layer(terrain.edit_fields(), SnowLayer::strength);
    for_rows([&](int y) { kernels_.strength(planes_, y, &strength[strength.index(0, y)]); });
  }
  terrain.ledger().in += report_.slabs_in;
  terrain.ledger().out += report_.slabs_out;
  return report_;
}

void SnowOnProcessor::load(const Terrain& terrain, const forcing::WindFrame&) {
  const Grid<float>& bonded = snow_layer(terrain.fields(), SnowLayer::bonded);
  loose_.resize(terrain.extent().cells());
  for (std::size_t cell = 0; cell < loose_.size(); ++cell) {
    loose_[cell] = loose_slabs(terrain.mobile()[cell], bonded[cell]);
  }
}

/// Makes everything ready for a step: where it lies, how it is turned, and memory.
void SnowOnProcessor::begin(Terrain& terrain, const SnowStep& snow, const Forcing& wind, StepKey key) {
  frame_ = forcing::wind_frame(terrain.extent(), wind.bearing);
  key_ = key;
  report_ = {};
  planes_ = {};
  planes_.law = &snow.law;
  planes_.rests = snow_rests(snow.law);
  planes_.bonding_key = bonding_key(key);
  point_at_layers(terrain);
  turn_into_wind(snow.law);
  make_room(terrain.extent().cells());
  ground_ = {frame_.width,  frame_.length,   planes_.torus,  frame_.origin, frame_.step_u,
             frame_.step_v, planes_.bedrock, planes_.mobile, planes_.loose, planes_.landed};
}

/// Where the layers of the terrain lie.
void SnowOnProcessor::point_at_layers(Terrain& terrain) {
  constexpr int line_of_cells = static_cast<int>(compute::cache_line / sizeof(FlightCell));
  std::vector<Field>& fields = terrain.edit_fields();
  const auto layer = [&fields](SnowLayer which) { return snow_layer(fields, which).cells().data(); };
  SnowPlanes& planes = planes_;
  planes.nx = terrain.nx();
  planes.ny = terrain.ny();
  planes.pitch = ((planes.nx + line_of_cells - 1) / line_of_cells | 1) * line_of_cells;  // odd, or rows would compete
  planes.torus = terrain.boundary() == Boundary::torus;
  planes.inflow = planes.torus ? 0 : terrain.inflow();
  planes.bedrock = terrain.bedrock().cells().data();
  planes.mobile = terrain.edit_mobile().cells().data();
  planes.loose = loose_.data();
  planes.age = layer(SnowLayer::age);
  planes.landed = layer(SnowLayer::landed);
  planes.shown_loose = layer(SnowLayer::loose);
  planes.shown_bonded = layer(SnowLayer::bonded);
  Grid<std::int32_t>* const lift_counts = executor_->lift_counts();
  planes.lift_counts = lift_counts != nullptr ? lift_counts->cells().data() : nullptr;
}

/// How lines and rows of the wind's frame lie in these layers, and what a slope is along them.
void SnowOnProcessor::turn_into_wind(const SnowLaw& law) {
  SnowPlanes& planes = planes_;
  planes.width = frame_.width;
  planes.length = frame_.length;
  // In a grid of one column the steps alone do not tell.
  planes.along_x = (frame_.step_v == 1 || frame_.step_v == -1) && frame_.length == planes.nx;
  const int sign_u = frame_.step_u > 0 ? 1 : -1;
  const int sign_v = frame_.step_v > 0 ? 1 : -1;
  const auto origin = static_cast<int>(frame_.origin);
  planes.origin = origin / planes.nx * planes.pitch + origin % planes.nx;
  planes.step_u = sign_u * (planes.along_x ? planes.pitch : 1);
  planes.step_v = sign_v * (planes.along_x ? 1 : planes.pitch);
  planes.rows = static_cast<float>(frame_.cosine);

  const SnowSlopes slopes = snow_slopes(law, frame_.tangent, frame_.cosine);
  const auto along = static_cast<float>(slopes.along * sign_v);
  const auto across = static_cast<float>(slopes.across * sign_u);
  planes.slope_by_x = planes.along_x ? along : across;
  planes.slope_by_y = planes.along_x ? across : along;

  const auto next_by_u = static_cast<std::uint32_t>(sign_u * frame_.length);
  const auto next_by_v = static_cast<std::uint32_t>(sign_v);
  planes.number =
      (sign_u > 0 ? 0 : static_cast<std::uint32_t>(frame_.width - 1) * static_cast<std::uint32_t>(frame_.length)) +
      (sign_v > 0 ? 0 : static_cast<std::uint32_t>(frame_.length - 1));
  planes.number_by_x = planes.along_x ? next_by_v : next_by_u;
  planes.number_by_y = planes.along_x ? next_by_u : next_by_v;
}

/// The planes that a step needs besides the terrain's layers.
void SnowOnProcessor::make_room(std::size_t cells) {
  const std::size_t places = planes_.place(0, planes_.ny);
  const auto make = [](auto& vector, std::size_t count) {
    if (vector.size() < count) vector.resize(count);
    return vector.data();
  };
  planes_.height = make(height_, cells);
  planes_.dark = make(dark_, cells);
  planes_.cells = make(cells_, places);
  planes_.chances = make(chances_, places);
  planes_.powers = make(powers_, places);
  planes_.over = make(over_, places);
}

/// Calls work(y) for each row of the terrain, on all threads.
void SnowOnProcessor::for_rows(const std::function<void(int y)>& work) {
  executor_->parallel_for(planes_.ny, [&work](std::int64_t begin, std::int64_t end) {
    for (auto y = static_cast<int>(begin); y < end; ++y) work(y);
  });
}

void SnowOnProcessor::measure_heights() {
  const std::int32_t* const bedrock = planes_.bedrock;
  const std::int32_t* const mobile = planes_.mobile;
  const auto cells = static_cast<std::int64_t>(planes_.cell(0, planes_.ny));
  std::int32_t lowest = std::numeric_limits<std::int32_t>::max();
  std::int32_t highest = std::numeric_limits<std::int32_t>::min();
  std::int32_t most_snow = 0;
  executor_->parallel_for(cells, [&](std::int64_t begin, std::int64_t end) {
    std::int32_t low = std::numeric_limits<std::int32_t>::max();
    std::int32_t high = std::numeric_limits<std::int32_t>::min();
    std::int32_t most = 0;
    std::int32_t uneven = 0;
    for (std::int64_t cell = begin; cell < end; ++cell) {
      low = std::min(low, bedrock[cell] + mobile[cell]);
      high = std::max(high, bedrock[cell] + mobile[cell]);
      most = std::max(most, mobile[cell]);
      uneven |= bedrock[cell] ^ bedrock[0];
    }
    const std::lock_guard lock(mutex_);
    lowest = std::min(lowest, low);
    highest = std::max(highest, high);
    most_snow = std::max(most_snow, most);
    planes_.relief |= uneven != 0;
  });
  relief_ = highest - lowest;
  check_snow_height(most_snow, relief_);
  executor_->parallel_for(cells, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t cell = begin; cell < end; ++cell) {
      height_[static_cast<std::size_t>(cell)] = static_cast<std::uint16_t>(bedrock[cell] + mobile[cell] - lowest);
    }
  });
}

/// Snow falls at random and comes to lie on the lowest of nine cells.
void SnowOnProcessor::let_snow_fall() {
  const SnowLaw& law = *planes_.law;
  if (law.snowfall <= 0) return;
  const std::uint64_t base = snowfall_word(key_);
  std::vector<std::uint32_t> all;
  executor_->parallel_for(frame_.width, [&](std::int64_t begin, std::int64_t end) {
    std::vector<std::uint32_t> fallen;
    for (int u = static_cast<int>(begin); u < end; ++u) {
      for (int v = 0; v < frame_.length; ++v) {
        const std::uint64_t word = snow_cell_word(base, ground_.number(u, v));
        const int slabs = falling_slabs(law, word);
        if (slabs == 0) continue;
        const std::size_t lowest = lowest_of_nine(ground_, u, v, word);
        fallen.insert(fallen.end(), static_cast<std::size_t>(slabs), static_cast<std::uint32_t>(lowest));
      }
    }
    const std::lock_guard lock(mutex_);
    all.insert(all.end(), fallen.begin(), fallen.end());
  });
  report_.slabs_in += static_cast<std::int64_t>(all.size());
  for (const std::uint32_t here : all) {
    ++planes_.mobile[here];
    ++planes_.loose[here];
    planes_.landed[here] = law.now;
  }
}

}  // namespace erg::models
