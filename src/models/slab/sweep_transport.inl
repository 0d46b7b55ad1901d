// Part of sweep_kernels.inl: one strip of lines in one sub-sweep. Which slabs lift, and which stay where
// they come down.

template <typename Lane>
class TransportPass {
 public:
  TransportPass(const SweepPlan<Lane>& plan, Strip<Lane>& strip)
      : plan_(plan),
        strip_(strip),
        lanes_((strip.lines + 63) / 64 * 64),
        walk_(plan.layout, plan.drift, plan.phase, strip.first, strip.lines),
        draws_(strip.first, lanes_),
        shadow_(plan, strip),
        flight_(plan, strip, draws_, lanes_) {
    std::memset(&row_, 0, sizeof row_);
    std::memset(polls_, 0, sizeof polls_);
  }

  void transport_pass() {
    strip_.counts = SweepCounters{};
    strip_.last_arrival = -1;
    std::memset(strip_.line, 0, sizeof strip_.line);
    std::memset(strip_.upwind, 0, sizeof strip_.upwind);
    if (!plan_.open) warm_up();
    walk_.start(0);
    const int block = poll_rows(plan_);
    int row_in_block = 0;
    for (int y = 0; y < plan_.layout.length; ++y) {
      if (row_in_block == 0) draw_polls(y, block);
      read_row(y);
      if (plan_.open) cross_open_edges(y);
      shadow_.cast(row_, lanes_);
      decide(y, static_cast<Lane>(row_in_block));
      if (strip_.counts.overflow) return;
      write_row();
      if (plan_.lifted) write_lifted();
      walk_.go_on();
      if (++row_in_block == block) row_in_block = 0;
    }
    flush_polls();
    if (plan_.open) flight_.drop_all(plan_.layout.length);
  }

  void wrap_pass() {
    if (strip_.last_arrival < plan_.layout.length) return;
    walk_.start(plan_.layout.length);
    flight_.round_hops(plan_.layout.length);
    const std::int64_t last_free_row = static_cast<std::int64_t>(longest_flight + 1) * plan_.layout.length;
    std::memset(strip_.target, 0xff, sizeof strip_.target);
    for (std::int64_t flown = plan_.layout.length; flown <= strip_.last_arrival; ++flown) {
      read_row(flown);
      shadow_.cast(row_, lanes_);
      if (flown > last_free_row) std::memset(row_.shaded, 0xff, sizeof row_.shaded);
      decide(flown, 0);
      if (strip_.counts.overflow) return;
      add_row();
      walk_.go_on();
    }
  }

 private:
  static constexpr Lane all_ones = static_cast<Lane>(~Lane{0});

  // --- lines and rows ---

  /// Reads the frozen surface. `flown` is the row counted on over the torus edge: it keys the random numbers.
  void read_row(std::int64_t flown) {
    read_heights(flown);
    if (plan_.bedrock) walk_.copy_in(row_.bedrock, plan_.bedrock);
    if (plan_.cover) walk_.copy_in(row_.cover, plan_.cover);
    row_.word = row_word(plan_.sweep_word, static_cast<std::uint32_t>(flown));
  }

  void read_heights(std::int64_t flown) {
    if (strip_.next_block < 0 || flown >= plan_.layout.length) {
      walk_.copy_in(row_.height, plan_.before);
      return;
    }
    const int own = own_lanes();
    walk_.copy_in(row_.height, plan_.before, own);
    const std::size_t row =
        static_cast<std::size_t>(strip_.next_block) * static_cast<std::size_t>(plan_.layout.length) +
        static_cast<std::size_t>(walk_.y());
    // The last lanes stand in the next strip's places.
    const Lane* beyond = plan_.before_ghosts + row * ghost_places + own + walk_.offset() - strip_.lines;
    for (int lane = own; lane < strip_.lines; ++lane) row_.height[lane] = beyond[lane - own];
  }

  void write_row() {
    const Lane* __restrict landed = row_.landed;
    const Lane* __restrict lifted = row_.lifted;
    Lane* __restrict height = row_.height;
    Lane highest = 0;
    ERG_EACH(i, lanes_) {
      const Lane now = static_cast<Lane>(height[i] + landed[i] - lifted[i]);
      height[i] = now;
      highest = now > highest ? now : highest;
    }
    if (highest > strip_.counts.highest) strip_.counts.highest = highest;
    walk_.for_runs(own_lanes(), [&](int lane, std::size_t cell, int count, int room) {
      copy_lanes(plan_.after + cell, height + lane, count, strip_lines - lane, room);
    });
    if (strip_.halo) keep_halo();
    if (most_landed_ > strip_.counts.most_landed) strip_.counts.most_landed = most_landed_;
  }

  /// Lanes that stand in the strip's own places, or all where nothing is handed over.
  int own_lanes() const {
    if (!strip_.halo) return strip_.lines;
    return strip_.lines > walk_.offset() ? strip_.lines - walk_.offset() : 0;
  }

  void keep_halo() {
    Halo<Lane>& halo = strip_.halo[walk_.y()];
    halo.offset = static_cast<Lane>(walk_.offset());
    const int own = own_lanes();
    for (int lane = own; lane < strip_.lines; ++lane) halo.heights[lane - own] = row_.height[lane];
  }

  /// Which cells of the row have given a slab, for those who want to know.
  void write_lifted() const {
    walk_.for_runs(strip_.lines, [&](int lane, std::size_t cell, int count, int) {
      std::uint8_t* __restrict out = plan_.lifted + cell;
      const Lane* __restrict lifted = row_.lifted + lane;
      ERG_EACH(i, count) out[i] = static_cast<std::uint8_t>(lifted[i]);
    });
  }

  void add_row() {
    if (most_landed_ == 0) return;
    walk_.for_runs(strip_.lines, [&](int lane, std::size_t cell, int count, int) {
      Lane* __restrict out = plan_.after + cell;
      const Lane* __restrict landed = row_.landed + lane;
      ERG_EACH(i, count) out[i] = static_cast<Lane>(out[i] + landed[i]);
    });
    if (most_landed_ > strip_.counts.most_carried) strip_.counts.most_carried = most_landed_;
  }

  // --- shadow ---

  void warm_up() {
    walk_.start(-static_cast<std::int64_t>(plan_.warm_up));
    for (int left = plan_.warm_up; left > 0; --left) {
      walk_.copy_in(row_.height, plan_.before);
      shadow_.cast(row_, lanes_);
      walk_.go_on();
    }
  }

  // --- polls ---

  /// Each line is polled in at most one row of each block (engine: K / 2 rows with probability 1/2, or a permutation of
  /// K rows over K sub-sweeps).
  void draw_polls(int y, int block) {
    const std::uint64_t word = row_word(plan_.poll_word, static_cast<std::uint32_t>(y / block));
    const std::uint32_t key = draw_key(word, Draw::poll);
    draws_.fill(strip_.target, key);
    Lane* __restrict target = strip_.target;
    const Lane mask = static_cast<Lane>(plan_.sweeps - 1);
    if (plan_.permuted) {
      for (int i = 0; i < strip_.lines; ++i) target[i] = plan_.polled_row[target[i]];
    } else {
      ERG_EACH(i, lanes_) target[i] = static_cast<Lane>(target[i] & mask);
    }
    for (int i = strip_.lines; i < lanes_; ++i) target[i] = all_ones;
    thin_polls(word);
    const Lane rows = static_cast<Lane>(plan_.layout.length - y < block ? plan_.layout.length - y : block);
    Lane* __restrict polls = polls_;
    ERG_EACH(i, lanes_) polls[i] = static_cast<Lane>(polls[i] + (target[i] < rows ? 1 : 0));
    if (++blocks_polled_ == static_cast<Lane>(~Lane{0})) flush_polls();
  }

  /// Carries out only such a share of the polls as the sub-sweep wants.
  void thin_polls(std::uint64_t word) {
    if (plan_.poll_share_16 >= whole_share_16) return;
    const std::uint32_t chance = byte_chance(plan_.poll_share_16, word);
    if (chance > 255) return;
    draws_.fill(row_.random, draw_key(word, Draw::share));
    const Lane* __restrict random = row_.random;
    Lane* __restrict target = strip_.target;
    ERG_EACH(i, lanes_) target[i] = static_cast<Lane>(target[i] | (random[i] < chance ? Lane{0} : all_ones));
  }

  // --- lifting and landing ---

  /// Everything that happens in one row: which slabs lift, which stay, and where the others come down next.
  void decide(std::int64_t flown, Lane row_in_block) {
    Lane* arrivals = flight_.arrivals(flown);
    if (flown % hop_rows_alike(plan_.hop_table[0]) == 0) flight_.round_hops(flown);
    judge_ground();
    draws_.fill_landing(row_);
    const Lane most = lift_and_land(arrivals, row_in_block);
    if (sizeof(Lane) == 1 && most > narrow_arrivals) {
      strip_.counts.overflow = true;
      return;
    }
    most_landed_ = most > 0 ? 1 : 0;
    if (most > 1) land_second(arrivals);
    if (most > 2) land_others(arrivals);
    if (most > 0) std::memset(arrivals, 0, static_cast<std::size_t>(lanes_) * sizeof(Lane));
    if (plan_.wall_rows) meet_walls(flown);
    if (any_leaving_ && flight_.launch(row_, flown)) ++most_landed_;
    count(flown);
  }

  /// Where slabs may lift, and how likely they stay.
  void judge_ground() {
    const std::uint32_t on_sand = byte_chance(plan_.p_sand_16, row_.word);
    const std::uint32_t on_bare = byte_chance(plan_.p_bare_16, row_.word);
    const Lane sand_limit = static_cast<Lane>(on_sand > 255 ? 255 : on_sand);
    const Lane bare_limit = static_cast<Lane>(on_bare > 255 ? 255 : on_bare);
    const Lane sand_sure = on_sand > 255 ? all_ones : Lane{0};
    const Lane bare_sure = on_bare > 255 ? all_ones : Lane{0};
    const Lane dark_holds = plan_.lift_in_shadow ? Lane{0} : all_ones;
    const Lane* __restrict height = row_.height;
    const Lane* __restrict bedrock = row_.bedrock;
    const Lane* __restrict shaded = row_.shaded;
    Lane* __restrict no_lift = row_.no_lift;
    Lane* __restrict threshold = row_.threshold;
    Lane* __restrict always_deposit = row_.always_deposit;
    ERG_EACH(i, lanes_) {
      const Lane sand = height[i] != bedrock[i] ? all_ones : Lane{0};
      no_lift[i] = static_cast<Lane>(static_cast<Lane>(~sand) | (shaded[i] & dark_holds));
      threshold[i] = sand ? sand_limit : bare_limit;
      always_deposit[i] = static_cast<Lane>(shaded[i] | (sand ? sand_sure : bare_sure));
    }
    if (plan_.cover) judge_cover();
  }

  void judge_cover() {
    draws_.fill(row_.random, draw_key(row_.word, Draw::cover));
    const std::uint8_t* __restrict cover = row_.cover;
    const Lane* __restrict random = row_.random;
    Lane* __restrict no_lift = row_.no_lift;
    Lane* __restrict threshold = row_.threshold;
    Lane* __restrict always_deposit = row_.always_deposit;
    ERG_EACH(i, lanes_) {
      const Lane closed = cover[i] == 255 ? all_ones : Lane{0};
      no_lift[i] = static_cast<Lane>(no_lift[i] | closed | (random[i] < cover[i] ? all_ones : Lane{0}));
      always_deposit[i] = static_cast<Lane>(always_deposit[i] | closed);
      // covered_chance of a chance below 256 stays below 256 while the cover is below 255.
      const std::uint16_t chance = threshold[i];
      threshold[i] = static_cast<Lane>(
          chance + static_cast<std::uint16_t>(static_cast<std::uint16_t>(cover[i] * (256 - chance)) >> 8));
    }
  }

  /// Lifts from polled lanes and lands the first slab of each arrival; returns the most arrivals at one lane.
  Lane lift_and_land(const Lane* __restrict arrivals, Lane row_in_block) {
    const Lane* __restrict random = row_.random;
    const Lane* __restrict no_lift = row_.no_lift;
    const Lane* __restrict threshold = row_.threshold;
    const Lane* __restrict always_deposit = row_.always_deposit;
    const Lane* __restrict target = strip_.target;
    Lane* __restrict lifted = row_.lifted;
    Lane* __restrict landed = row_.landed;
    Lane* __restrict leaving = row_.leaving;
    Lane most = 0;
    Lane any_leaving = 0;
    ERG_EACH(i, lanes_) {
      const Lane arriving = arrivals[i];
      const Lane polled = target[i] == row_in_block ? all_ones : Lane{0};
      const Lane lift = static_cast<Lane>(polled & static_cast<Lane>(~no_lift[i]) & 1);
      const Lane stays = static_cast<Lane>((random[i] < threshold[i] ? all_ones : Lane{0}) | always_deposit[i]);
      const Lane land = static_cast<Lane>((arriving != 0 ? all_ones : Lane{0}) & stays & 1);
      const Lane leave = static_cast<Lane>(arriving - land + lift);
      lifted[i] = lift;
      landed[i] = land;
      leaving[i] = leave;
      most = arriving > most ? arriving : most;
      any_leaving = static_cast<Lane>(any_leaving | leave);
    }
    any_leaving_ = any_leaving != 0;
    return most;
  }

  /// The second slab that comes down at a lane: common enough that branches on it would not be foreseen.
  void land_second(const Lane* __restrict arrivals) {
    draws_.template fill_next<Draw::second_landing>(row_);
    const Lane* __restrict random = row_.random;
    const Lane* __restrict threshold = row_.threshold;
    const Lane* __restrict always_deposit = row_.always_deposit;
    Lane* __restrict landed = row_.landed;
    Lane* __restrict leaving = row_.leaving;
    ERG_EACH(i, lanes_) {
      const Lane stays = static_cast<Lane>((random[i] < threshold[i] ? all_ones : Lane{0}) | always_deposit[i]);
      const Lane land = static_cast<Lane>((arrivals[i] > 1 ? all_ones : Lane{0}) & stays & 1);
      landed[i] = static_cast<Lane>(landed[i] + land);
      leaving[i] = static_cast<Lane>(leaving[i] - land);
    }
    most_landed_ = 2;
  }

  /// The third, fourth ... slab. Rare, so one lane at a time.
  void land_others(const Lane* arrivals) {
    for (int first = 0; first < lanes_; first += 64) {
      for (std::uint64_t mask = lanes_above<2>(arrivals + first); mask != 0; mask &= mask - 1) {
        const int lane = first + __builtin_ctzll(mask);
        land_more(lane, arrivals[lane]);
      }
    }
  }

  void land_more(int lane, std::uint32_t arriving) {
    const std::uint32_t before = row_.landed[lane];
    std::uint32_t landed = before;
    for (std::uint32_t slab = 2; slab < arriving; ++slab) {
      const std::uint32_t key = draw_key(row_.word, static_cast<std::uint32_t>(Draw::first_landing) + slab);
      const std::uint32_t byte = line_byte(key, static_cast<std::uint32_t>(strip_.first + lane));
      landed += (row_.always_deposit[lane] != 0 || byte < row_.threshold[lane]) ? 1 : 0;
    }
    row_.leaving[lane] = static_cast<Lane>(row_.leaving[lane] + before - landed);
    row_.landed[lane] = static_cast<Lane>(landed);
    most_landed_ = landed > most_landed_ ? landed : most_landed_;
  }

  /// Algorithm 7 of Cimbura 2022: where bedrock stands too steeply in the next row, all that flies over here drops
  /// here.
  void meet_walls(std::int64_t flown) {
    LineWalk next_row = walk_;
    next_row.go_on();
    if (!plan_.wall_rows[next_row.y()] || (plan_.open && next_row.y() == 0)) return;
    next_row.copy_in(row_.next_bedrock, plan_.bedrock);
    const bool leaves_sideways = plan_.open && next_row.stepped();
    for (int i = 0; i < strip_.lines; ++i) {
      if (row_.next_bedrock[i] <= row_.height[i] + plan_.wall_step) continue;
      if (leaves_sideways && (walk_.column() + i) % plan_.layout.width == plan_.layout.width - 1) continue;
      drop_here(i, flown);
    }
  }

  void drop_here(int lane, std::int64_t flown) {
    const std::int64_t landed = row_.landed[lane] + row_.leaving[lane] + flight_.drop(lane, flown);
    row_.leaving[lane] = 0;
    if (sizeof(Lane) == 1 && landed > narrow_arrivals) {
      strip_.counts.overflow = true;
      return;
    }
    row_.landed[lane] = static_cast<Lane>(landed);
    if (static_cast<std::uint32_t>(landed) > most_landed_) most_landed_ = static_cast<std::uint32_t>(landed);
  }

  // --- open edges ---

  /// Lines that enter the grid at this row: what flew in them has left on the other side, and new slabs come in.
  void cross_open_edges(int y) {
    if (y == 0) {
      for (int i = 0; i < strip_.lines; ++i) flight_.enter(row_, i, y);
      return;
    }
    if (!walk_.stepped()) return;
    const int lane = walk_.column() == 0 ? 0 : plan_.layout.width - walk_.column();
    if (lane >= strip_.lines) return;
    flight_.drop_out(lane, y);
    strip_.line[lane] = 0;
    strip_.upwind[0][lane] = strip_.upwind[1][lane] = 0;
    flight_.enter(row_, lane, y);
  }

  // --- counts ---

  /// Books what the row has given and taken. A slab that is lifted in one row and comes to rest in another has flown
  /// the rows between, however often it has touched the ground.
  void count(std::int64_t flown) {
    const Lane* __restrict lifted = row_.lifted;
    const Lane* __restrict landed = row_.landed;
    const Lane* __restrict none = row_.none;
    int lifts = 0;
    int landings = 0;
    // Sums of differences from nothing: those of bytes are one instruction.
    ERG_EACH(i, lanes_) lifts += __builtin_abs(lifted[i] - none[i]);
    if (most_landed_ > 0) {
      ERG_EACH(i, lanes_) landings += __builtin_abs(landed[i] - none[i]);
    }
    strip_.counts.lifts += lifts;
    strip_.counts.rows_flown += flown * (landings - lifts);
  }

  void flush_polls() {
    for (int i = 0; i < lanes_; ++i) strip_.counts.polls += polls_[i];
    std::memset(polls_, 0, sizeof polls_);
    blocks_polled_ = 0;
  }

  const SweepPlan<Lane>& plan_;
  Strip<Lane>& strip_;
  const int lanes_;  // strip_.lines rounded up to whole vectors; the lanes beyond hold no sand and are never polled
  LineWalk walk_;
  const LineDraws<Lane> draws_;
  ShadowLine<Lane> shadow_;
  Flight<Lane> flight_;
  std::uint32_t most_landed_ = 0;
  bool any_leaving_ = false;
  Row<Lane> row_;
  alignas(64) Lane polls_[strip_lines];  // of each lane since they were last summed up
  Lane blocks_polled_ = 0;
};
