// Kernels of snow in flight, part of snow_kernels.inl: slabs lift, fly and come down, and a strip takes the snow of its
// lines from the terrain and gives it back. What slabs do is random, so no branch of the inner loops hangs on it where
// a choice between two numbers will do.

constexpr int side_by_side = 16;  // lanes that are worked on together; those too many do no harm

// --- terrain in and out ---

/// `step` is a constant, so that both directions become vectors.
template <int step>
[[gnu::always_inline]] inline void take_in_order(const SnowStretch& stretch) {
  const std::int32_t* __restrict mobile = stretch.mobile;
  const std::int32_t* __restrict loose = stretch.loose;
  const std::uint32_t* __restrict chances = stretch.chances;
  const std::uint32_t* __restrict hops = stretch.hops;
  const std::int16_t* __restrict over = stretch.over;
  SnowCell* __restrict cells = stretch.cells;
  std::int16_t* __restrict heights = stretch.heights;
  ERG_EACH(i, stretch.count) {
    cells[i].snow = snow_word(loose[i * step], mobile[i * step]);
    cells[i].chances = chances[i * step];
    cells[i].hops = hops[i * step];
    cells[i].run = 0;
    cells[i].landed = 0;
  }
  ERG_EACH(i, stretch.count) heights[i] = over[i * step];
}

void take_snow(const SnowStretch& stretch) {
  if (stretch.step == 1) {
    take_in_order<1>(stretch);
  } else {
    take_in_order<-1>(stretch);
  }
}

template <int step>
[[gnu::always_inline]] inline void give_in_order(const SnowStretch& stretch) {
  std::int32_t* __restrict mobile = stretch.mobile;
  std::int32_t* __restrict loose = stretch.loose;
  float* __restrict landed = stretch.landed;
  const SnowCell* __restrict cells = stretch.cells;
  const float now = stretch.law->now;
  ERG_EACH(i, stretch.count) {
    const std::uint32_t snow = cells[i].snow;
    mobile[i * step] = mobile_of(snow);
    loose[i * step] = loose_of(snow);
    landed[i * step] = cells[i].landed != 0 ? now : landed[i * step];
  }
}

void give_snow(const SnowStretch& stretch) {
  if (stretch.step == 1) {
    give_in_order<1>(stretch);
  } else {
    give_in_order<-1>(stretch);
  }
}

// --- lifting ---

void draw_rows(std::uint32_t sweep_key, int first_row, std::uint64_t* __restrict row_words) {
  ERG_EACH(i, snow_window) row_words[i] = flight_row_word(sweep_key, first_row + i);
}

/// Which lines lift a slab, and from which row of the block; those beyond the last line never do.
void poll(const SnowPolls& polls, const SnowLines& lines, std::int32_t* __restrict row,
          std::uint32_t* __restrict lifted) {
  const std::uint32_t* __restrict polled_row = polls.polled_row;
  // A cell's words, of which the first two are asked for.
  const auto* __restrict words =
      reinterpret_cast<const std::uint32_t*>(lines.cells + std::ptrdiff_t{polls.first_row} * lines.next_row);
  const std::uint32_t key = polls.key;
  const auto first_line = static_cast<std::uint32_t>(lines.first_line);
  const std::uint32_t chance_key = polls.chance_key;
  const std::int32_t rows = polls.rows;
  const std::int32_t count_lines = lines.lines;
  const std::int32_t next_row = lines.next_row;
  const std::int32_t next_line = lines.next_line;
  ERG_EACH(i, snow_lines) {
    const std::uint32_t word = snow_poll_word(key, first_line + static_cast<std::uint32_t>(i));
    const auto polled = static_cast<std::int32_t>(polled_row[static_cast<std::int32_t>(word >> 24)]);
    const std::int32_t at = polled < rows ? polled : 0;
    const std::int32_t cell = (at * next_row + i * next_line) * 4;
    const std::uint32_t lets_go = snow_lifts(word, chance_key, words[cell], words[cell + 1]) ? 1 : 0;
    row[i] = at;
    lifted[i] = (polled < rows ? 1 : 0) & (i < count_lines ? 1 : 0) & lets_go;
  }
}

/// Slabs that lift and hop: snow_line_word and snow_hop in lanes of 32 bits.
void lift(const SnowPolls& polls, const SnowLines& lines, const SnowAir& air, SnowLifts& lifts) {
  alignas(64) std::int32_t row[snow_lines];
  alignas(64) std::uint32_t lifted[snow_lines];
  alignas(64) std::uint32_t hops[snow_lines];
  alignas(64) std::int32_t run[snow_lines];
  poll(polls, lines, row, lifted);
  int count = 0;
  for (int i = 0; i < snow_lines; ++i) {
    lifts.line[count] = i;
    count += static_cast<int>(lifted[i]);
  }
  SnowCell* const cells = lines.cells + std::ptrdiff_t{polls.first_row} * lines.next_row;
  for (int k = 0; k < count; ++k) {
    const int line = lifts.line[k];
    SnowCell& cell = cells[row[line] * lines.next_row + line * lines.next_line];
    cell.snow = without_slab(cell.snow);
    lifts.row[k] = row[line];
    hops[k] = cell.hops;
    run[k] = cell.run;
  }
  for (int k = count; (k & (side_by_side - 1)) != 0; ++k) lifts.row[k] = 0, hops[k] = 0, run[k] = 0, lifts.line[k] = 0;
  lifts.count = count;
  std::int32_t rows_flown = 0;
  const std::uint64_t* __restrict row_words = polls.row_words;
  const auto first_line = static_cast<std::uint64_t>(lines.first_line);
  const std::int32_t first_row = polls.first_row;
  const std::int32_t next_line = air.next_line;
  const std::int32_t windows = air.windows - 1;
  for (int first = 0; first < count; first += side_by_side) {
    const std::int32_t* __restrict line = lifts.line + first;
    std::int32_t* __restrict from = lifts.row + first;
    std::int32_t* __restrict fall = lifts.fall + first;
    std::int32_t* __restrict place = lifts.place + first;
    std::int32_t* __restrict window = lifts.window + first;
    std::uint64_t* __restrict load = lifts.load + first;
    std::uint64_t* __restrict bit = lifts.bit + first;
    const std::uint32_t* __restrict hop = hops + first;
    const std::int32_t* __restrict most = run + first;
    alignas(64) std::uint64_t word[side_by_side];
    alignas(64) std::uint32_t share[side_by_side];
    alignas(64) std::uint32_t shift[side_by_side];
    ERG_EACH(k, side_by_side) word[k] = mix64(row_words[from[k]] + first_line + static_cast<std::uint64_t>(line[k]));
    ERG_EACH(k, side_by_side) {
      const std::int32_t whole = snow_hop_rows(hop[k], static_cast<std::uint32_t>(word[k]));
      const std::int32_t flown = whole < most[k] ? whole : most[k];
      from[k] += first_row;
      const std::int32_t to = from[k] + flown;
      const std::int32_t to_window = to / snow_window & windows;
      fall[k] = to;
      share[k] = share_of_hop(flown, whole);
      shift[k] = static_cast<std::uint32_t>(to & (snow_window - 1));
      place[k] = line[k] * next_line + to_window * snow_window + (to & (snow_window - 1));
      window[k] = to_window * snow_lines + line[k];
      rows_flown += flown;
    }
    ERG_EACH(k, side_by_side) {
      load[k] = one_slab + share[k];
      bit[k] = std::uint64_t{1} << shift[k];
    }
  }
  lifts.rows_flown = rows_flown;
}

/// Puts a slab into the air with what it adds to a load, or where `flies` is 0 does nothing.
[[gnu::always_inline]] inline void send(const SnowAir& air, std::uint64_t flies, int line, int row,
                                        std::uint64_t load) {
  const int window = row / snow_window & (air.windows - 1);
  const int place = row & (air.windows * snow_window - 1);
  air.loads[line * air.next_line + place] += -flies & load;
  air.falls[window * snow_lines + line] |= flies << (row & (snow_window - 1));
}

void launch(const SnowLifts& lifts, SnowAir& air) {
  std::uint64_t* const loads = air.loads;
  std::uint64_t* const falls = air.falls;
  for (int k = 0; k < lifts.count; ++k) {
    loads[lifts.place[k]] += lifts.load[k];
    falls[lifts.window[k]] |= lifts.bit[k];
  }
  air.rows_flown += lifts.rows_flown;
}

// --- coming down ---

/// Slabs that come down at the same time, each load in another line. Beyond `count` stand numbers of earlier ones.
struct Arrivals {
  int count = 0;
  int hards = 0;
  int crowds = 0;
  alignas(64) std::int32_t line[snow_lines] = {};
  alignas(64) std::int32_t row[snow_lines] = {};  // of the window
  alignas(64) std::int32_t cell[snow_lines];      // of the strip
  alignas(64) std::uint64_t load[snow_lines];
  alignas(64) std::uint64_t word[snow_lines];
  alignas(64) SnowCell found[snow_lines];  // the cells before
  alignas(64) std::uint32_t snow[snow_lines];
  alignas(64) std::uint32_t rest[snow_lines];   // chance of 65536 to stay
  alignas(64) std::uint32_t stays[snow_lines];  // slabs
  // Where the first slab flies on: its next load, and which bit says so. Both 0 where it does not.
  alignas(64) std::int32_t place[snow_lines];
  alignas(64) std::int32_t window[snow_lines];
  alignas(64) std::uint64_t push[snow_lines];
  alignas(64) std::uint64_t fall[snow_lines];
  std::int32_t hard[snow_lines];   // those of them that strike bonded snow
  std::int32_t crowd[snow_lines];  // those of more than one slab
};

/// Takes the first load out of the air over each of some lines.
void take_first(const SnowLines& lines, int first_row, std::uint64_t within, const SnowAir& air,
                const std::int32_t* active, Arrivals& all) {
  const int first_place = first_row & (air.windows * snow_window - 1);
  std::uint64_t* const falls = air.falls + (first_row / snow_window & (air.windows - 1)) * snow_lines;
  int hards = 0;
  int crowds = 0;
  for (int k = 0; k < all.count; ++k) {
    const int line = active[k];
    const int row = __builtin_ctzll(falls[line] & within);
    falls[line] ^= std::uint64_t{1} << row;
    std::uint64_t& waiting = air.loads[line * air.next_line + first_place + row];
    const std::uint64_t load = waiting;
    waiting = 0;
    const int cell = (first_row + row) * lines.next_row + line * lines.next_line;
    const SnowCell& here = lines.cells[cell];
    all.line[k] = line;
    all.row[k] = row;
    all.cell[k] = cell;
    all.load[k] = load;
    all.found[k] = here;
    all.hard[hards] = k;
    hards += (here.snow & 0xffff) == 0 && here.snow != 0 ? 1 : 0;
    all.crowd[crowds] = k;
    crowds += slabs_of(load) > 1 ? 1 : 0;
  }
  all.hards = hards;
  all.crowds = crowds;
}

/// What becomes of the first slab of each load. It decides on the snow as it finds it: snow_line_word, chance_to_stay,
/// snow_stays, snow_carried_off and snow_hop in lanes of 32 bits.
void decide(const SnowLandings& landings, const std::uint64_t* __restrict row_words, int first_row, Arrivals& all,
            SnowAir& air) {
  const std::uint32_t rest_loose = landings.rests.loose;
  const std::uint32_t rest_hard = landings.rests.hard;
  const std::uint32_t rest_ground = landings.rests.ground;
  const std::uint32_t suspension = landings.rests.suspension;
  const std::uint32_t least_rest = landings.last ? certain : 0;
  const auto first_line = static_cast<std::uint64_t>(landings.lines.first_line);
  const std::int32_t windows = air.windows - 1;
  const std::int32_t next_line = air.next_line;
  const std::int32_t count = all.count;
  std::int32_t rows_flown = 0;
  std::int32_t carried_off = 0;
  for (int first = 0; first < count; first += side_by_side) {
    std::uint64_t* __restrict word = all.word + first;
    const std::int32_t* __restrict line = all.line + first;
    const std::int32_t* __restrict row = all.row + first;
    // A cell's four words: snow, chances, hops, and rows that are free with what has landed.
    const auto* __restrict found = reinterpret_cast<const std::uint32_t*>(all.found + first);
    std::uint32_t* __restrict snow_kept = all.snow + first;
    std::uint32_t* __restrict chance = all.rest + first;
    std::uint32_t* __restrict stays = all.stays + first;
    std::int32_t* __restrict place = all.place + first;
    std::int32_t* __restrict window = all.window + first;
    std::uint64_t* __restrict push = all.push + first;
    std::uint64_t* __restrict fall = all.fall + first;
    alignas(64) std::uint32_t flies[side_by_side];
    alignas(64) std::uint32_t share[side_by_side];
    alignas(64) std::uint32_t bit[side_by_side];
    const std::int32_t left = count - first;
    ERG_EACH(k, side_by_side) word[k] = mix64(~row_words[row[k]] + first_line + static_cast<std::uint64_t>(line[k]));
    ERG_EACH(k, side_by_side) {
      const auto low = static_cast<std::uint32_t>(word[k]);
      const auto high = static_cast<std::uint32_t>(word[k] >> 32);
      const std::uint32_t snow = found[4 * k];
      const std::uint32_t hops = found[4 * k + 2];
      const auto run = static_cast<std::int32_t>(found[4 * k + 3] & 0x7fff);
      const std::uint32_t on_bare = snow >> 16 != 0 ? rest_hard : rest_ground;
      const std::uint32_t on_snow = (snow & 0xffff) != 0 ? rest_loose : on_bare;
      const std::uint32_t in_light = on_snow > least_rest ? on_snow : least_rest;
      const std::uint32_t rest = mean_hop_64(hops) == 0 ? certain : in_light;
      const std::uint32_t stay = (low & 0xffff) < rest ? 1 : 0;
      const std::uint32_t off = (low >> 16) < suspension ? 1 : 0;
      const std::uint32_t fly = (stay | off) ^ 1;
      const std::int32_t whole = snow_hop_rows(hops, high);
      const std::int32_t flown = whole < run ? whole : run;
      const std::int32_t to = first_row + row[k] + flown;
      const std::int32_t to_window = to / snow_window & windows;
      snow_kept[k] = snow;
      chance[k] = rest;
      stays[k] = stay;
      flies[k] = fly;
      share[k] = share_of_hop(flown, whole);
      bit[k] = static_cast<std::uint32_t>(to & (snow_window - 1));
      place[k] = line[k] * next_line + to_window * snow_window + (to & (snow_window - 1));
      window[k] = to_window * snow_lines + line[k];
      rows_flown += k < left ? flown & -static_cast<std::int32_t>(fly) : 0;
      carried_off += k < left ? static_cast<std::int32_t>((stay | fly) ^ 1) : 0;
    }
    ERG_EACH(k, side_by_side) {
      const std::uint64_t fly = flies[k];
      push[k] = fly * one_slab + (-fly & share[k]);
      fall[k] = fly << bit[k];
    }
  }
  air.rows_flown += rows_flown;
  air.carried_off += carried_off;
}

/// The slabs of a load that are not the first.
void decide_others(const SnowLandings& landings, int first_row, Arrivals& all, int k, SnowAir& air) {
  std::uint64_t word = all.word[k];
  for (std::uint32_t slabs = slabs_of(all.load[k]); slabs > 1; --slabs) {
    word = mix64(word);
    const std::uint32_t stay = snow_stays(word, all.rest[k]) ? 1 : 0;
    const std::uint32_t off = snow_carried_off(word, landings.rests) ? 1 : 0;
    const std::uint32_t flies = (stay | off) ^ 1;
    const SnowHop hop = snow_hop(all.found[k], static_cast<std::uint32_t>(word >> 32));
    send(air, flies, all.line[k], first_row + all.row[k] + hop.rows, hop.load);
    all.stays[k] += stay;
    air.rows_flown += hop.rows & -static_cast<int>(flies);
    air.carried_off += off & (stay ^ 1);
  }
}

/// Strength of the uppermost bonded snow under a cell of the strip.
float strength_at(const SnowLandings& landings, int row, int line, std::uint32_t snow) {
  int u = landings.offsets[row] + landings.lines.first_line + line;
  u = u < landings.width ? u : u - landings.width;
  const std::int64_t cell = landings.origin + u * landings.step_u + row * landings.step_v;
  return snow_strength(*landings.law, static_cast<int>(cell % landings.nx), static_cast<int>(cell / landings.nx),
                       mobile_of(snow));
}

/// The impacts of a load on bonded snow free slabs of it in place.
void strike(const SnowLandings& landings, int first_row, Arrivals& all, int k) {
  const SnowLines& lines = landings.lines;
  const std::int32_t* const ground = landings.ground;
  const int row = first_row + all.row[k];
  const int here = all.cell[k];
  const std::uint32_t snow = all.snow[k];
  std::int32_t upwind = landings.upwind[all.line[k]];
  if (row > 0) {
    const int before = here - lines.next_row;
    upwind = mobile_of(lines.cells[before].snow) + (ground != nullptr ? ground[before] : 0);
  }
  const std::int32_t surface = mobile_of(snow) + (ground != nullptr ? ground[here] : 0);
  const float rise = upwind == no_surface ? 0.0f : static_cast<float>(surface - upwind);
  const float power = strike_power(*landings.law, all.found[k].hops, all.load[k], rise);
  const std::int32_t freed = freed_slabs(*landings.law, all.load[k], all.word[k], power,
                                         [&] { return strength_at(landings, row, all.line[k], snow); });
  const std::int32_t most = mobile_of(snow);
  all.snow[k] += static_cast<std::uint32_t>(freed < most ? freed : most);
}

void land(const SnowLandings& landings, const std::uint64_t* row_words, int first_row, int end, std::uint64_t among,
          SnowAir& air) {
  const SnowLines lines = landings.lines;
  const SnowAir here = air;
  const std::uint64_t* const falls = here.falls + (first_row / snow_window & (here.windows - 1)) * snow_lines;
  const int rows = end - first_row;
  const std::uint64_t within = rows < snow_window ? (std::uint64_t{1} << rows) - 1 : ~std::uint64_t{0};
  std::int32_t active[snow_lines];
  Arrivals all;
  for (int line = 0; line < lines.lines; ++line) {
    active[all.count] = line;
    all.count += (falls[line] & within) != 0 && (among >> line & 1) != 0 ? 1 : 0;
  }
  while (all.count > 0) {
    take_first(lines, first_row, within, here, active, all);
    decide(landings, row_words, first_row, all, air);
    for (int k = 0; k < all.hards; ++k) strike(landings, first_row, all, all.hard[k]);
    for (int k = 0; k < all.crowds; ++k) decide_others(landings, first_row, all, all.crowd[k], air);
    int count = 0;
    for (int k = 0; k < all.count; ++k) {
      const int line = all.line[k];
      const std::uint32_t stays = all.stays[k];
      SnowCell& cell = lines.cells[all.cell[k]];
      cell.snow = all.snow[k] + snow_word(1, 1) * stays;
      cell.landed = static_cast<std::int16_t>(cell.landed | (stays != 0 ? 1 : 0));
      here.loads[all.place[k]] += all.push[k];
      here.falls[all.window[k]] |= all.fall[k];
      active[count] = line;
      count += (falls[line] & within) != 0 ? 1 : 0;
    }
    all.count = count;
  }
}
