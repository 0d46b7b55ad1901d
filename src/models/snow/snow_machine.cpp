#include "models/snow/snow_machine.h"

#include <algorithm>
#include <utility>

#include "models/snow/snow_draws.h"

namespace erg {
namespace {

constexpr std::int64_t most_at_once = 2048;  // cells whose heights are looked at together: they stay in the cache

}  // namespace

StepReport SnowMachine::step(Terrain& terrain, SnowLayers& layers, const SnowLaw& law, SnowRadii radii,
                             double shadow_fall, const WindNow& wind, StepKey key, Executor& executor) {
  law_ = &law;
  executor_ = &executor;
  layers_ = &layers;
  extent_ = terrain.extent();
  boundary_ = terrain.boundary();
  inflow_ = boundary_ == Boundary::open ? terrain.inflow() : 0;
  radii_ = radii;
  frame_ = wind_frame(extent_, wind.bearing);
  key_ = key;
  report_ = {};
  bedrock_ = terrain.bedrock().cells().data();
  mobile_ = terrain.edit_mobile().cells().data();
  ground_ = {
      frame_.width, frame_.length, boundary_ == Boundary::torus, frame_.origin,       frame_.step_u, frame_.step_v,
      bedrock_,     mobile_,       layers.loose.data(),          layers.landed.data()};
  measure_heights();
  measure_weather(shadow_fall);
  if (executor.sub_sweeps() == 0) {
    fly_one_by_one();
  } else {
    fly_in_sweeps();
  }
  report_.polls = static_cast<std::int64_t>(extent_.cells());
  report_.travel /= frame_.cosine;
  slide();
  let_snow_fall();
  rest();
  terrain.ledger().in += report_.slabs_in;
  terrain.ledger().out += report_.slabs_out;
  return report_;
}

// --- heights ---

/// Heights over the lowest surface, which is mostly that of the last step: then they are right at once.
void SnowMachine::measure_heights() {
  const std::size_t cells = extent_.cells();
  const SnowKernels& kernels = snow_kernels(instructions_);
  const std::int32_t expected = low_;
  height_.resize(cells);
  SnowHeights all;
  all.level = bedrock_[0];
  executor_->parallel_for(static_cast<std::int64_t>(cells), [&](std::int64_t begin, std::int64_t end) {
    SnowHeights heights;
    heights.level = bedrock_[0];
    for (std::int64_t at = begin; at < end; at += most_at_once) {
      const int count = static_cast<int>(std::min(most_at_once, end - at));
      kernels.survey(bedrock_ + at, mobile_ + at, count, heights);
      kernels.raise(bedrock_ + at, mobile_ + at, expected, height_.data() + at, count);
    }
    const std::lock_guard lock(mutex_);
    all.lowest = std::min(all.lowest, heights.lowest);
    all.highest = std::max(all.highest, heights.highest);
    all.most_snow = std::max(all.most_snow, heights.most_snow);
    all.uneven |= heights.uneven;
  });
  low_ = all.lowest;
  high_ = all.highest;
  relief_ = all.uneven != 0;
  check_snow_height(all.most_snow, high_ - low_);
  if (low_ == expected) return;
  executor_->parallel_for(static_cast<std::int64_t>(cells), [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t at = begin; at < end; at += most_at_once) {
      kernels.raise(bedrock_ + at, mobile_ + at, low_, height_.data() + at,
                    static_cast<int>(std::min(most_at_once, end - at)));
    }
  });
}

// --- flights ---

void SnowMachine::fly_in_sweeps() {
  SnowFlightPlan plan;
  plan.law = law_;
  plan.frame = frame_;
  plan.extent = extent_;
  plan.boundary = boundary_;
  plan.inflow = inflow_;
  plan.key = key_;
  plan.sweeps = executor_->sub_sweeps();
  plan.bedrock = bedrock_;
  plan.mobile = mobile_;
  plan.loose = layers_->loose.data();
  plan.landed = layers_->landed.data();
  plan.chances = chances_.data();
  plan.hops = hops_.data();
  plan.over = over_.data();
  plan.longest_mean_hop = longest_mean_hop_;
  plan.relief = relief_;
  plan.lift_counts = executor_->lift_counts();
  report_ = flights_.fly(plan, instructions_, *executor_);
}

// --- rest ---

/// Snow falls at random and comes to lie on the lowest of nine cells.
void SnowMachine::let_snow_fall() {
  if (law_->snowfall <= 0) return;
  const std::uint64_t base = snowfall_word(key_);
  fallen_.clear();
  executor_->parallel_for(frame_.width, [&](std::int64_t begin, std::int64_t end) {
    std::vector<std::uint32_t> fallen;
    for (int u = static_cast<int>(begin); u < end; ++u) {
      for (int v = 0; v < frame_.length; ++v) {
        const std::uint64_t word = snow_cell_word(base, ground_.number(u, v));
        const int slabs = falling_slabs(*law_, word);
        if (slabs == 0) continue;
        const std::size_t lowest = lowest_of_nine(ground_, u, v, word);
        fallen.insert(fallen.end(), static_cast<std::size_t>(slabs), static_cast<std::uint32_t>(lowest));
      }
    }
    const std::lock_guard lock(mutex_);
    fallen_.push_back(std::move(fallen));
  });
  for (const std::vector<std::uint32_t>& fallen : fallen_) {
    report_.slabs_in += static_cast<std::int64_t>(fallen.size());
    for (const std::uint32_t here : fallen) {
      ++mobile_[here];
      ++layers_->loose[here];
      layers_->landed[here] = law_->now;
    }
  }
}

/// Loose snow bonds from below; bonded snow grows older.
void SnowMachine::rest() {
  const std::uint32_t key = bonding_key(key_);
  const auto nx = static_cast<std::size_t>(extent_.nx);
  const std::int64_t next_by_v = frame_.step_v > 0 ? 1 : -1;
  const std::int64_t next_by_u = frame_.step_u > 0 ? frame_.length : -frame_.length;
  const std::int64_t by_x = along_x() ? next_by_v : next_by_u;
  const std::int64_t by_y = along_x() ? next_by_u : next_by_v;
  const std::int64_t first = (frame_.step_v > 0 ? 0 : frame_.length - 1) +
                             (frame_.step_u > 0 ? 0 : std::int64_t{frame_.width - 1} * frame_.length);
  executor_->parallel_for(extent_.ny, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t y = begin; y < end; ++y) {
      const std::size_t start = static_cast<std::size_t>(y) * nx;
      SnowRestRow row;
      row.count = extent_.nx;
      row.key = key;
      row.number = static_cast<std::uint32_t>(first + y * by_y);
      row.next_number = static_cast<std::uint32_t>(by_x);
      row.mobile = mobile_ + start;
      row.landed = layers_->landed.data() + start;
      row.loose = layers_->loose.data() + start;
      row.age = layers_->age.data() + start;
      row.shown_loose = layers_->shown_loose.data() + start;
      row.shown_bonded = layers_->shown_bonded.data() + start;
      snow_kernels(instructions_).rest(*law_, row);
    }
  });
}

}  // namespace erg
