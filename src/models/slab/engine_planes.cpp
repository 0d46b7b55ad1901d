// The engine's planes: the terrain in the wind's frame, and what the law means on it before a step.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "kernels/fixed_point.h"
#include "models/slab/engine.h"
#include "models/slab/terrain_heights.h"

namespace erg::models {

using compute::AlignedVector;
using forcing::WindFrame;

void SlabEngine::load(const Terrain& terrain, const WindFrame& frame) {
  const TerrainHeights heights = check_height(terrain);
  frame_ = frame;
  open_ = terrain.boundary() == Boundary::open;
  layout_ = plane_layout(frame, open_);
  base_ = heights.lowest;
  relief_ = heights.relief;
  highest_ = heights.highest;
  bedrock_total_ = heights.bedrock_total;
  mobile_total_ = heights.mobile_total;
  narrow_ = narrow_fits(highest_);
  if (narrow_) {
    load_heights<std::uint8_t>(terrain);
  } else {
    load_heights<std::uint16_t>(terrain);
  }
  cover_source_ = {};
}

/// Whether the planes already lie as this frame wants them.
bool SlabEngine::lies_ready_for(const WindFrame& frame) const {
  return frame_.same_axes(frame) && layout_.skew == plane_layout(frame, open_).skew;
}

/// Lays the planes as this frame wants them where it has the same rows: then each is turned round the torus or
/// mirrored, which costs a swinging wind little. False, and nothing done, where rows become columns or run the other
/// way.
bool SlabEngine::turn_rows(const WindFrame& frame) {
  const bool mirrored = frame.step_u != frame_.step_u;
  const bool same_rows = frame.step_v == frame_.step_v && frame.width == frame_.width && frame.length == frame_.length;
  if (!same_rows) return false;
  const PlaneLayout wanted = plane_layout(frame, open_);
  const auto turn = [&](auto& planes) {
    turn_rows_of(planes.before, wanted, mirrored);
    if (relief_) turn_rows_of(planes.bedrock, wanted, mirrored);
  };
  if (narrow_) {
    turn(narrow_planes_);
  } else {
    turn(wide_planes_);
  }
  layout_ = wanted;
  frame_ = frame;
  cover_source_ = {};
  return true;
}

template <typename Lane>
void SlabEngine::turn_rows_of(AlignedVector<Lane>& plane, const PlaneLayout& wanted, bool mirrored) {
  pool_.run([&](int member) {
    std::vector<Lane> places(static_cast<std::size_t>(layout_.width));
    std::vector<Lane> columns(places.size());
    const auto [first, end] = share(layout_.length, member, pool_.size());
    for (int row = first; row < end; ++row) {
      const auto each_block = [&](const auto& copy) {
        for (int block = 0; block < layout_.blocks; ++block) {
          copy(plane.data() + layout_.at(block, 0, row), places.data() + block * layout_.block_columns,
               layout_.columns_of(block));
        }
      };
      each_block([](const Lane* in_plane, Lane* place, int count) { std::copy_n(in_plane, count, place); });
      std::rotate_copy(places.begin(), places.begin() + layout_.wrapped(-layout_.shift(row)), places.end(),
                       columns.begin());
      if (mirrored) std::reverse(columns.begin(), columns.end());
      std::rotate_copy(columns.begin(), columns.begin() + wanted.wrapped(wanted.shift(row)), columns.end(),
                       places.begin());
      each_block([](Lane* in_plane, const Lane* place, int count) { std::copy_n(place, count, in_plane); });
    }
  });
}

/// Calls visit(cell of the frame's plane, cell of the terrain) for all cells, in blocks that suit both orders of
/// memory.
template <typename Visit>
void SlabEngine::visit_cells(const Visit& visit) {
  std::vector<std::size_t> start(static_cast<std::size_t>(frame_.width));  // of each place in row 0
  for (int place = 0; place < frame_.width; ++place) {
    start[static_cast<std::size_t>(place)] = layout_.at_place(place, 0);
  }
  constexpr int block_rows = 16;
  const int blocks = (frame_.length + block_rows - 1) / block_rows;
  pool_.run([&](int member) {
    for (int block = member; block < blocks; block += pool_.size()) {
      const int first = block * block_rows;
      const int end = std::min(frame_.length, first + block_rows);
      std::array<int, block_rows> places{};  // of the column in each row
      for (int v = first; v < end; ++v)
        places[static_cast<std::size_t>(v - first)] = layout_.wrapped(-layout_.shift(v));
      for (int u = 0; u < frame_.width; ++u) {
        for (int v = first; v < end; ++v) {
          int& place = places[static_cast<std::size_t>(v - first)];
          const std::size_t row = static_cast<std::size_t>(v) * static_cast<std::size_t>(layout_.pitch);
          visit(start[static_cast<std::size_t>(place)] + row, frame_.cell(u, v));
          if (++place == frame_.width) place = 0;
        }
      }
    }
  });
}

template <typename Lane>
void SlabEngine::load_heights(const Terrain& terrain) {
  Planes<Lane>& mine = planes<Lane>();
  mine.rings.clear();  // of a step that failed
  mine.before.resize(layout_.block_size * static_cast<std::size_t>(layout_.blocks));
  mine.after.resize(layout_.block_size * static_cast<std::size_t>(layout_.blocks));
  mine.bedrock.resize(relief_ ? layout_.block_size * static_cast<std::size_t>(layout_.blocks) : 0);
  const auto bedrock = terrain.bedrock().cells();
  const auto mobile = terrain.mobile().cells();
  visit_cells([&](std::size_t here, std::size_t there) {
    mine.before[here] = static_cast<Lane>(bedrock[there] + mobile[there] - base_);
    if (relief_) mine.bedrock[here] = static_cast<Lane>(bedrock[there] - base_);
  });
}

void SlabEngine::sync_to_host(Terrain& terrain) {
  Grid<std::int32_t>& mobile = terrain.edit_mobile();
  const auto write = [&](const auto& mine) {
    visit_cells([&](std::size_t here, std::size_t there) {
      mobile[there] = mine.before[here] - (relief_ ? mine.bedrock[here] : 0);
    });
  };
  if (narrow_) {
    write(narrow_planes_);
  } else {
    write(wide_planes_);
  }
}

void SlabEngine::change_lanes(bool narrow) {
  const auto convert = [](const auto& from, auto& to) {
    to.before.assign(from.before.begin(), from.before.end());
    to.after.resize(from.after.size());
    to.bedrock.assign(from.bedrock.begin(), from.bedrock.end());
  };
  if (narrow) {
    convert(wide_planes_, narrow_planes_);
    wide_planes_ = {};
  } else {
    convert(narrow_planes_, wide_planes_);
    narrow_planes_ = {};
  }
  narrow_ = narrow;
  cover_source_ = {};
}

// --- what the law means on this grid ---

template <typename Lane>
void SlabEngine::load_cover(const SlabLaw& law) {
  if (law.cover == nullptr) {
    cover_.clear();
    cover_source_ = {};
    planes<Lane>().steps.clear();
    planes<Lane>().diagonal_steps.clear();
    return;
  }
  const CoverSource source{law.cover->stamp(), law.bare, law.covered, law.covered_from};
  if (cover_source_ == source) return;
  cover_source_ = {};
  const auto cover = (*law.cover)->cells();
  cover_.resize(layout_.block_size * static_cast<std::size_t>(layout_.blocks));
  visit_cells([&](std::size_t here, std::size_t there) { cover_[here] = cover[there]; });

  Planes<Lane>& mine = planes<Lane>();
  const auto lay_steps = [&](AlignedVector<Lane>& steps, int bare, int covered) {
    bare = std::min(bare, longest_step);
    covered = std::min(covered, longest_step);
    steps.resize(bare == covered ? 0 : cover_.size());
    for (std::size_t cell = 0; cell < steps.size(); ++cell) {
      steps[cell] = static_cast<Lane>(cover_[cell] >= law.covered_from ? covered : bare);
    }
  };
  lay_steps(mine.steps, law.bare.straight, law.covered.straight);
  lay_steps(mine.diagonal_steps, law.bare.diagonal, law.covered.diagonal);
  cover_source_ = source;
}

/// Marks the rows whose bedrock may stop a slab: only where it stands higher than a step over the lowest ground.
void SlabEngine::prepare_walls(const SlabLaw& law) {
  if (!law.obstacles || !relief_) {
    wall_rows_.clear();
    return;
  }
  wall_rows_.assign(static_cast<std::size_t>(frame_.length), 0);
  const auto mark = [&](const auto& bedrock) {
    for (int block = 0; block < layout_.blocks; ++block) {
      for (int v = 0; v < frame_.length; ++v) {
        const auto row = bedrock.begin() + static_cast<std::ptrdiff_t>(layout_.at(block, 0, v));
        if (*std::max_element(row, row + layout_.columns_of(block)) > law.bare.straight) {
          wall_rows_[static_cast<std::size_t>(v)] = 1;
        }
      }
    }
  };
  if (narrow_) {
    mark(narrow_planes_.bedrock);
  } else {
    mark(wide_planes_.bedrock);
  }
}

/// Fills the table of hops in rows * 256, one entry for each height over the base (or one for all).
template <typename Lane>
void SlabEngine::prepare_hops(const SlabLaw& law, double strength, StepKey key) {
  const HopCurve hop{strength,      law.hop.linear,    law.hop.quadratic,
                     frame_.cosine, hop_rounding(key), most_hop_rows(strength, frame_.cosine, frame_.length)};
  const auto rows_256 = [&](double above_reference) { return hop_rows_256(hop, above_reference); };
  if (!law.hop.depends_on_height()) {
    hop_table_.assign(1, rows_256(0));
    return;
  }
  const double mean = static_cast<double>(bedrock_total_ + mobile_total_) / static_cast<double>(cells()) - base_;
  const double deviation = law.hop.deviation_weight != 0 ? mean_deviation<Lane>(mean) : 0;
  const double reference = mean - law.hop.deviation_weight * deviation;
  hop_table_.resize(std::size_t{1} << (8 * sizeof(Lane)));
  for (std::size_t height = 0; height < hop_table_.size(); ++height) {
    hop_table_[height] = rows_256(static_cast<double>(height) - reference);
  }
}

/// Mean of |h - mean| over the cells, from counts of heights: the same sum on any number of threads.
template <typename Lane>
double SlabEngine::mean_deviation(double mean) {
  const AlignedVector<Lane>& heights = planes<Lane>().before;
  std::vector<std::vector<std::int64_t>> counts(static_cast<std::size_t>(pool_.size()));
  pool_.run([&](int member) {
    std::vector<std::int64_t>& mine = counts[static_cast<std::size_t>(member)];
    mine.assign(static_cast<std::size_t>(highest_) + 1, 0);
    const auto [first, end] = share(frame_.length, member, pool_.size());
    for (int block = 0; block < layout_.blocks; ++block) {
      for (int v = first; v < end; ++v) {
        const Lane* row = heights.data() + layout_.at(block, 0, v);
        for (int u = 0; u < layout_.columns_of(block); ++u) ++mine[row[u]];
      }
    }
  });
  double sum = 0;
  for (std::size_t height = 0; height <= static_cast<std::size_t>(highest_); ++height) {
    std::int64_t count = 0;
    for (const auto& mine : counts) count += mine[height];
    sum += static_cast<double>(count) * std::abs(static_cast<double>(height) - mean);
  }
  return sum / static_cast<double>(cells());
}

/// Cuts the lines into strips, one or more for each member, with rings of this many rows.
template <typename Lane>
void SlabEngine::prepare_strips(int ring_rows) {
  Planes<Lane>& mine = planes<Lane>();
  // As many for each member, so that none has more to do.
  const int members = sweepers();
  const int strips_each = (frame_.width + members * strip_lines - 1) / (members * strip_lines);
  const int lines_each = (frame_.width + members * strips_each - 1) / (members * strips_each);
  const int lines = std::min(strip_lines, (lines_each + 63) / 64 * 64);
  const auto count = static_cast<std::size_t>((frame_.width + lines - 1) / lines);
  const std::size_t ring = static_cast<std::size_t>(ring_rows) * strip_lines + fetched_ahead;
  if (mine.strips.size() != count) mine.strips = std::vector<Strip<Lane>>(count);
  if (mine.rings.size() != ring * count) mine.rings.assign(ring * count, 0);
  const std::size_t rows = layout_.skew != 0 ? static_cast<std::size_t>(layout_.length) : 0;
  mine.halos.resize(rows * count);
  mine.ghosts.resize(rows * static_cast<std::size_t>(layout_.blocks) * ghost_places);
  const auto length = static_cast<std::size_t>(layout_.length);
  mine.edges.resize(2 * 4 * static_cast<std::size_t>(layout_.blocks) * length);
  mine.borders.resize(static_cast<std::size_t>(members) * (border_columns * length + fetched_ahead));
  for (std::size_t k = 0; k < count; ++k) {
    Strip<Lane>& strip = mine.strips[k];
    strip.first = static_cast<int>(k) * lines;
    strip.lines = std::min(lines, frame_.width - strip.first);
    strip.ring = mine.rings.data() + ring * k;
    strip.halo = layout_.skew != 0 ? mine.halos.data() + rows * k : nullptr;
    const int next = layout_.wrapped(strip.first + strip.lines);
    const int next_block = layout_.block_of(next);
    strip.next_block = layout_.skew != 0 && next == next_block * layout_.block_columns ? next_block : -1;
  }
}

/// Whether each member's lines stay in blocks of its own, from the first row to the last and over the torus edge. Then
/// nothing but the borders between blocks is any concern of another member.
template <typename Lane>
bool SlabEngine::lines_stay_apart() const {
  const std::vector<Strip<Lane>>& strips = planes<Lane>().strips;
  bool apart = frame_.tangent <= 0 && layout_.blocks % sweepers() == 0;
  for (int member = 0; member < sweepers() && apart; ++member) {
    const auto first_strip = static_cast<std::size_t>(share(static_cast<int>(strips.size()), member, sweepers()).first);
    const int first_block = share(layout_.blocks, member, sweepers()).first;
    apart = first_strip < strips.size() && strips[first_strip].first == first_block * layout_.block_columns;
  }
  return apart;
}

// --- counting where slabs are lifted ---

void SlabEngine::prepare_lift_counts(bool wanted) {
  const std::size_t places = wanted ? layout_.block_size * static_cast<std::size_t>(layout_.blocks) : 0;
  lifted_.assign(places, 0);
  step_lifts_.assign(places, 0);
}

/// Adds what a sub-sweep has lifted, once it is known that it stands. A member's share of the plane, whoever wrote it.
void SlabEngine::add_lifted(int member) {
  const auto places = static_cast<std::int64_t>(lifted_.size());
  const std::int64_t end = places * (member + 1) / sweepers();
  for (std::int64_t place = places * member / sweepers(); place < end; ++place) {
    step_lifts_[static_cast<std::size_t>(place)] += lifted_[static_cast<std::size_t>(place)];
  }
}

void SlabEngine::add_lift_counts_to(Grid<std::int32_t>* lift_counts) {
  if (lift_counts == nullptr) return;
  Grid<std::int32_t>& counts = *lift_counts;
  visit_cells(
      [&](std::size_t here, std::size_t there) { counts[there] += static_cast<std::int32_t>(step_lifts_[here]); });
}

/// Rows of ring that hold the longest hop from ground up to `highest`: a power of two.
int SlabEngine::ring_rows(int highest) const {
  const std::size_t heights = std::min(hop_table_.size(), static_cast<std::size_t>(highest) + 1);
  const std::uint32_t longest =
      *std::max_element(hop_table_.begin(), hop_table_.begin() + static_cast<std::ptrdiff_t>(heights));
  return static_cast<int>(std::bit_ceil((longest >> kernels::fixed_point_bits) + 2));
}

template void SlabEngine::load_cover<std::uint8_t>(const SlabLaw&);
template void SlabEngine::load_cover<std::uint16_t>(const SlabLaw&);
template void SlabEngine::prepare_hops<std::uint8_t>(const SlabLaw&, double, StepKey);
template void SlabEngine::prepare_hops<std::uint16_t>(const SlabLaw&, double, StepKey);
template void SlabEngine::prepare_strips<std::uint8_t>(int);
template void SlabEngine::prepare_strips<std::uint16_t>(int);
template bool SlabEngine::lines_stay_apart<std::uint8_t>() const;
template bool SlabEngine::lines_stay_apart<std::uint16_t>() const;

}  // namespace erg::models
