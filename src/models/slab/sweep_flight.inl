// Part of sweep_kernels.inl: the slabs of one strip that are in the air.

/// They wait in a ring of rows (Strip::ring) for the row where they come down next.
template <typename Lane>
class Flight {
 public:
  Flight(const SweepPlan<Lane>& plan, Strip<Lane>& strip, const LineDraws<Lane>& draws, int lanes)
      : plan_(plan), strip_(strip), draws_(draws), lanes_(lanes) {}

  /// How many slabs come down at each lane of a row.
  Lane* arrivals(std::int64_t flown) { return strip_.ring + ring_start(flown); }

  /// Sends the slabs that leave this row to the row where they come down next. Whether some that were lifted make a hop
  /// of no row: they have landed in this one.
  bool launch(Row<Lane>& row, std::int64_t flown) {
    if (plan_.hop_by_height) return launch_by_height(row, flown);
    const std::uint32_t rows_256 = plan_.hop_table[0];
    const std::uint32_t near_rows = rows_256 >> kernels::fixed_point_bits;
    if (near_rows == 0) return launch_short(row, flown);
    const Lane far_below = static_cast<Lane>(rows_256 & 0xff);  // of 256: how often a hop is one row longer
    const Lane* __restrict leaving = row.leaving;
    Lane* __restrict near_ring = strip_.ring + ring_start(flown + near_rows);
    if (far_below == 0) {
      ERG_EACH(i, lanes_) near_ring[i] = static_cast<Lane>(near_ring[i] + leaving[i]);
      expect(flown + near_rows);
      return false;
    }
    const Lane* __restrict one_further = one_further_;
    Lane* __restrict far_ring = strip_.ring + ring_start(flown + near_rows + 1);
    ERG_EACH(i, lanes_) {
      const Lane far = static_cast<Lane>(leaving[i] & one_further[i]);
      const Lane near = static_cast<Lane>(leaving[i] - far);
      near_ring[i] = static_cast<Lane>(near_ring[i] + near);
      far_ring[i] = static_cast<Lane>(far_ring[i] + far);
    }
    expect(flown + near_rows + 1);
    return false;
  }

  /// For the rows from this one on where hops are rounded alike: which lines' hops are one row longer.
  void round_hops(std::int64_t flown) {
    const std::uint32_t rows_256 = plan_.hop_table[0];
    const Lane far_below = static_cast<Lane>(rows_256 & 0xff);
    if (plan_.hop_by_height || far_below == 0) return;
    Lane* __restrict one_further = one_further_;
    draws_.fill(one_further, hop_key(plan_.sweep_word, static_cast<std::uint32_t>(flown), rows_256));
    // As hop_rows: one row more where the random byte carries the fraction over.
    const Lane near_below = static_cast<Lane>(256 - far_below);
    ERG_EACH(i, lanes_) one_further[i] = one_further[i] >= near_below ? static_cast<Lane>(~Lane{0}) : Lane{0};
  }

  /// New slabs over an open edge.
  void enter(const Row<Lane>& row, int lane, int y) {
    if (plan_.inflow <= 0) return;
    const std::uint32_t key = draw_key(row.word, Draw::inflow);
    const std::uint32_t line = static_cast<std::uint32_t>(strip_.first + lane);
    const std::uint32_t random = mix32(key ^ line * 0x9e3779b9u);
    const int slabs = static_cast<int>(plan_.inflow + (random >> 16) * (1.0 / 65536));
    const std::uint32_t rows_256 = plan_.hop_table[plan_.hop_by_height ? row.height[lane] : 0];
    for (int slab = 0; slab < slabs; ++slab) {
      // Where in its hop a slab crosses the edge is random: it comes down up to one hop further on.
      const std::uint32_t part = mix32(random + static_cast<std::uint32_t>(slab)) >> 16;
      const std::int64_t down = y + static_cast<std::int64_t>((static_cast<std::uint64_t>(rows_256) * part) >> 24);
      Lane& there = strip_.ring[ring_start(down) + static_cast<std::size_t>(lane)];
      there = static_cast<Lane>(there + 1);
      if (sizeof(Lane) == 1 && there > narrow_arrivals) strip_.counts.overflow = true;
      strip_.counts.rows_flown -= down;  // its way begins where it first comes down
      expect(down);
    }
    strip_.counts.slabs_in += slabs;
  }

  /// Takes all slabs out of the air over a lane of this row; how many.
  std::int64_t drop(int lane, std::int64_t flown) {
    std::int64_t dropped = 0;
    for (int rows = 1; rows < plan_.ring_rows; ++rows) {
      Lane& flying = arrivals(flown + rows)[lane];
      dropped += flying;
      flying = 0;
    }
    return dropped;
  }

  /// The slabs of a lane from this row on have left over an open edge.
  void drop_out(int lane, std::int64_t from_row) {
    for (int rows = 0; rows < plan_.ring_rows; ++rows) {
      Lane& flying = strip_.ring[ring_start(from_row + rows) + static_cast<std::size_t>(lane)];
      strip_.counts.rows_flown += from_row * flying;
      strip_.counts.slabs_out += flying;
      flying = 0;
    }
  }

  void drop_all(std::int64_t from_row) {
    if (strip_.last_arrival >= from_row) {
      for (int lane = 0; lane < strip_.lines; ++lane) drop_out(lane, from_row);
    }
    strip_.last_arrival = -1;
  }

 private:
  std::size_t ring_start(std::int64_t flown) const {
    return static_cast<std::size_t>(flown & (plan_.ring_rows - 1)) * strip_lines;
  }

  /// Where hops are shorter than a row.
  bool launch_short(Row<Lane>& row, std::int64_t flown) {
    const Lane* __restrict one_further = one_further_;
    const Lane* __restrict lifted = row.lifted;
    Lane* __restrict landed = row.landed;
    Lane* __restrict leaving = row.leaving;
    Lane* __restrict ring = strip_.ring + ring_start(flown + 1);
    ERG_EACH(i, lanes_) {
      // At a wall nothing leaves any more.
      const Lane back = static_cast<Lane>(leaving[i] != 0 ? lifted[i] & static_cast<Lane>(~one_further[i]) : 0);
      landed[i] = static_cast<Lane>(landed[i] + back);
      leaving[i] = static_cast<Lane>(leaving[i] - back);
      ring[i] = static_cast<Lane>(ring[i] + leaving[i]);
    }
    expect(flown + 1);
    return true;
  }

  bool launch_by_height(Row<Lane>& row, std::int64_t flown) {
    draws_.template fill_next<Draw::hop>(row);
    bool some_back = false;
    std::uint32_t longest = 0;
    std::uint32_t fullest = 0;
    for (int first = 0; first < lanes_; first += 64) {
      for (std::uint64_t mask = lanes_above<0>(row.leaving + first); mask != 0; mask &= mask - 1) {
        const int lane = first + __builtin_ctzll(mask);
        std::uint32_t leaving = row.leaving[lane];
        std::uint32_t rows = hop_rows(plan_.hop_table[row.height[lane]], row.random[lane]);
        if (rows == 0) {
          row.landed[lane] = static_cast<Lane>(row.landed[lane] + row.lifted[lane]);
          leaving -= row.lifted[lane];
          some_back = some_back || row.lifted[lane] != 0;
          rows = rows_on(rows);
        }
        Lane& there = strip_.ring[ring_start(flown + rows) + static_cast<std::size_t>(lane)];
        const std::uint32_t now = there + leaving;
        there = static_cast<Lane>(now);
        fullest = now > fullest ? now : fullest;
        longest = rows > longest ? rows : longest;
      }
    }
    if (sizeof(Lane) == 1 && fullest > narrow_arrivals) strip_.counts.overflow = true;
    expect(flown + longest);
    return some_back;
  }

  void expect(std::int64_t row) {
    if (row > strip_.last_arrival) strip_.last_arrival = row;
  }

  const SweepPlan<Lane>& plan_;
  Strip<Lane>& strip_;
  const LineDraws<Lane>& draws_;
  const int lanes_;
  alignas(64) Lane one_further_[strip_lines];  // mask: hops of these lines are a row longer than the others'
};
