// Kernels of snow in flight, part of snow_kernels.inl: slabs lift, fly and come down. What slabs do is random, so no
// branch of the inner loops hangs on it where a choice between two numbers will do.

constexpr int side_by_side = 16;  // lanes that are worked on together; those too many do no harm

// --- lifting ---

void draw_rows(std::uint32_t sweep_key, int first_row, std::uint64_t* __restrict row_words) {
  ERG_EACH(i, snow_window) row_words[i] = flight_row_word(sweep_key, first_row + i);
}

/// Slabs that lift and hop: lift_chance_of, without_slab, snow_line_word and snow_hop in lanes of 32 bits. Which cells
/// let one go was drawn before; here is seen what snow they have.
void lift(const SnowPolls& polls, const SnowLines& lines, const SnowAir& air, SnowLifts& lifts) {
  alignas(64) std::int32_t cell[snow_lines];
  alignas(64) std::uint32_t snow_left[snow_lines];
  // A cell's two words.
  auto* const words = reinterpret_cast<std::uint32_t*>(lines.cells);
  const int* __restrict places = lines.places + polls.first_row;
  const std::uint64_t* __restrict row_words = polls.row_words;
  const auto first_line = static_cast<std::uint64_t>(lines.first_line);
  const std::int32_t first_row = polls.first_row;
  const std::int32_t next_line = lines.next_line;
  const std::int32_t windows = air.windows - 1;
  const std::int32_t count = polls.count;
  std::int32_t lifted = 0;
  std::int32_t rows_flown = 0;
  for (int first = 0; first < count; first += side_by_side) {
    const std::uint16_t* __restrict poll = polls.polls + first;
    const std::uint32_t* __restrict found = words;
    std::int32_t* __restrict at = cell + first;
    std::uint32_t* __restrict left = snow_left + first;
    std::int32_t* __restrict line = lifts.line + first;
    std::int32_t* __restrict from = lifts.row + first;
    std::int32_t* __restrict fall = lifts.fall + first;
    std::int32_t* __restrict place = lifts.place + first;
    std::int32_t* __restrict window = lifts.window + first;
    std::uint32_t* __restrict load = lifts.load + first;
    std::uint32_t* __restrict bit = lifts.bit + first;
    alignas(64) std::int32_t row[side_by_side];
    alignas(64) std::uint64_t word[side_by_side];
    alignas(64) std::uint32_t way[side_by_side];
    alignas(64) std::uint32_t goes[side_by_side];
    const std::int32_t lanes = count - first;
    ERG_EACH(k, side_by_side) {
      const std::int32_t polled = poll[k];
      line[k] = polled & (snow_lines - 1);
      row[k] = polled >> polled_row_bit & (snow_window - 1);
      at[k] = places[row[k]] + line[k] * next_line;
      const std::uint32_t snow = found[2 * at[k]];
      const std::uint32_t loose = (snow & 0xffff) != 0 ? 1 : 0;
      const std::uint32_t hard = snow != 0 ? 1 : 0;
      const auto lifts_loose = static_cast<std::uint32_t>(polled >> lifts_loose_bit & 1);
      const auto lifts_hard = static_cast<std::uint32_t>(polled >> lifts_hard_bit & 1);
      const std::uint32_t lets_go = ((loose & lifts_loose) | ((loose ^ 1) & hard & lifts_hard)) & (k < lanes ? 1 : 0);
      left[k] = snow - lets_go * 0x10000u - (lets_go & loose);
      way[k] = found[2 * at[k] + 1];
      goes[k] = lets_go;
    }
    ERG_EACH(k, side_by_side) word[k] = mix64(row_words[row[k]] + first_line + static_cast<std::uint64_t>(line[k]));
    ERG_EACH(k, side_by_side) {
      const std::int32_t run = run_of(way[k]);
      const std::int32_t whole = snow_hop_rows(way[k], static_cast<std::uint32_t>(word[k]));
      const std::int32_t flown = whole < run ? whole : run;
      from[k] = first_row + row[k];
      const std::int32_t to = from[k] + flown;
      const std::int32_t to_window = to / snow_window & windows;
      fall[k] = to;
      window[k] = to_window * snow_lines + line[k];
      place[k] = window[k] * snow_window + (to & (snow_window - 1));
      load[k] = -goes[k] & (short_slab + share_of_hop(flown, whole));
      bit[k] = goes[k] << (to & (snow_window - 1));
      rows_flown += flown & -static_cast<std::int32_t>(goes[k]);
      lifted += static_cast<std::int32_t>(goes[k]);
    }
  }
  for (int k = 0; k < count; ++k) words[2 * cell[k]] = snow_left[k];
  lifts.count = count;
  lifts.lifted = lifted;
  lifts.rows_flown = rows_flown;
}

void launch(const SnowLifts& lifts, SnowAir& air) {
  const SnowAir here = air;
  for (int k = 0; k < lifts.count; ++k) {
    here.put(lifts.place[k], lifts.load[k]);
    here.falls[lifts.window[k]] |= lifts.bit[k];
  }
  air.rows_flown += lifts.rows_flown;
}

// --- coming down ---

/// Slabs that come down at the same time, each load in another line: in each round the first of a window that is in
/// the air over its line.
struct Arrivals {
  int count = 0;
  alignas(64) std::int32_t line[snow_lines + side_by_side];
  alignas(64) std::uint32_t waiting[snow_lines + side_by_side];  // rows in which something comes down, as bits
  alignas(64) std::int32_t row[snow_lines];                      // of the window
  alignas(64) std::int32_t from[snow_lines];                     // the load's place in the air
  alignas(64) std::int32_t cell[snow_lines];                     // of the strip
  alignas(64) std::uint32_t load[snow_lines];
  alignas(64) std::uint64_t word[snow_lines];
  alignas(64) std::uint32_t snow[snow_lines];  // of the cells before
  alignas(64) std::uint32_t way[snow_lines];
  alignas(64) std::uint32_t snow_left[snow_lines];  // of the cells afterwards
  alignas(64) std::uint32_t way_left[snow_lines];
  alignas(64) std::uint32_t rest[snow_lines];     // chance of 65536 to stay
  alignas(64) std::uint32_t further[snow_lines];  // what is not yet decided: `strikes_bonded`, `is_crowd`
  // Where the first slab flies on: its next load, and which bit says so. Both 0 where it does not.
  alignas(64) std::int32_t place[snow_lines];
  alignas(64) std::int32_t window[snow_lines];
  alignas(64) std::uint32_t push[snow_lines];
  alignas(64) std::uint32_t fall[snow_lines];
};
constexpr std::uint32_t strikes_bonded = 1;
constexpr std::uint32_t is_crowd = 2;  // more than one slab

/// The number of a word's lowest bit.
[[gnu::always_inline]] inline std::int32_t lowest_bit(std::uint32_t word) {
  const auto alone = static_cast<float>(word & -word);
  return static_cast<std::int32_t>(__builtin_bit_cast(std::uint32_t, alone) >> 23) - 127;
}

/// Takes the first load out of the air over each line, and looks at the cells there.
void take_first(const SnowLines& lines, int first_row, const SnowAir& air, Arrivals& all) {
  const std::int32_t air_place = (first_row / snow_window & (air.windows - 1)) * snow_lines * snow_window;
  const int* __restrict places = lines.places + first_row;
  const std::uint32_t* __restrict loads = air.loads;
  // A cell's two words.
  const auto* __restrict words = reinterpret_cast<const std::uint32_t*>(lines.cells);
  const std::int32_t next_line = lines.next_line;
  for (int first = 0; first < all.count; first += side_by_side) {
    const std::int32_t* __restrict line = all.line + first;
    std::uint32_t* __restrict waiting = all.waiting + first;
    std::int32_t* __restrict row = all.row + first;
    std::int32_t* __restrict from = all.from + first;
    std::int32_t* __restrict cell = all.cell + first;
    std::uint32_t* __restrict load = all.load + first;
    std::uint32_t* __restrict snow = all.snow + first;
    std::uint32_t* __restrict way = all.way + first;
    ERG_EACH(k, side_by_side) {
      const std::int32_t there = lowest_bit(waiting[k]);
      const std::int32_t place = air_place + line[k] * snow_window + there;
      const std::int32_t here = places[there] + line[k] * next_line;
      row[k] = there;
      from[k] = place;
      cell[k] = here;
      waiting[k] &= waiting[k] - 1;
      load[k] = loads[place];
      snow[k] = words[2 * here];
      way[k] = words[2 * here + 1];
    }
  }
}

/// What becomes of the first slab of each load. It decides on the snow as it finds it: snow_line_word, chance_to_stay,
/// snow_stays, snow_carried_off and snow_hop in lanes of 32 bits. What flies on to a row before `end` waits for its
/// turn here.
void decide(const SnowLandings& landings, const std::uint64_t* __restrict row_words, int first_row, int end,
            Arrivals& all, SnowAir& air) {
  const std::uint32_t rest_loose = landings.rests.loose;
  const std::uint32_t rest_hard = landings.rests.hard;
  const std::uint32_t rest_ground = landings.rests.ground;
  const std::uint32_t suspension = landings.rests.suspension;
  const std::uint32_t least_rest = landings.last ? certain : 0;
  const auto first_line = static_cast<std::uint64_t>(landings.lines.first_line);
  const std::int32_t windows = air.windows - 1;
  const std::int32_t rows = end - first_row;
  const std::int32_t count = all.count;
  std::int32_t rows_flown = 0;
  std::int32_t carried_off = 0;
  for (int first = 0; first < count; first += side_by_side) {
    const std::int32_t* __restrict line = all.line + first;
    const std::int32_t* __restrict row = all.row + first;
    const std::uint32_t* __restrict load = all.load + first;
    const std::uint32_t* __restrict snow = all.snow + first;
    const std::uint32_t* __restrict way = all.way + first;
    std::uint32_t* __restrict waiting = all.waiting + first;
    std::uint64_t* __restrict word = all.word + first;
    std::uint32_t* __restrict snow_left = all.snow_left + first;
    std::uint32_t* __restrict way_left = all.way_left + first;
    std::uint32_t* __restrict chance = all.rest + first;
    std::uint32_t* __restrict further = all.further + first;
    std::int32_t* __restrict place = all.place + first;
    std::int32_t* __restrict window = all.window + first;
    std::uint32_t* __restrict push = all.push + first;
    std::uint32_t* __restrict fall = all.fall + first;
    const std::int32_t lanes = count - first;
    ERG_EACH(k, side_by_side) word[k] = mix64(~row_words[row[k]] + first_line + static_cast<std::uint64_t>(line[k]));
    ERG_EACH(k, side_by_side) {
      const auto low = static_cast<std::uint32_t>(word[k]);
      const auto high = static_cast<std::uint32_t>(word[k] >> 32);
      const std::int32_t run = run_of(way[k]);
      const std::uint32_t bonded = snow[k] >> 16 != 0 ? strikes_bonded : 0;
      const std::uint32_t on_bare = bonded != 0 ? rest_hard : rest_ground;
      const std::uint32_t on_snow = (snow[k] & 0xffff) != 0 ? rest_loose : on_bare;
      const std::uint32_t in_light = on_snow > least_rest ? on_snow : least_rest;
      const std::uint32_t rest = mean_hop_64(way[k]) == 0 ? certain : in_light;
      const std::uint32_t stay = (low & 0xffff) < rest ? 1 : 0;
      const std::uint32_t off = (low >> 16) < suspension ? 1 : 0;
      const std::uint32_t fly = (stay | off) ^ 1;
      const std::int32_t whole = snow_hop_rows(way[k], high);
      const std::int32_t flown = whole < run ? whole : run;
      const std::int32_t to = row[k] + flown;
      const std::uint32_t bit = fly << ((first_row + to) & (snow_window - 1));
      const std::uint32_t here = to < rows ? bit : 0;
      chance[k] = rest;
      snow_left[k] = snow[k] + stay * snow_word(1, 1);
      way_left[k] = way[k] | stay * snow_has_landed;
      window[k] = ((first_row + to) / snow_window & windows) * snow_lines + line[k];
      place[k] = window[k] * snow_window + ((first_row + to) & (snow_window - 1));
      push[k] = -fly & (short_slab + share_of_hop(flown, whole));
      waiting[k] |= here;
      fall[k] = bit ^ here;
      further[k] = ((snow[k] & 0xffff) != 0 ? 0 : bonded) | (short_slabs_of(load[k]) > 1 ? is_crowd : 0);
      rows_flown += k < lanes ? flown & -static_cast<std::int32_t>(fly) : 0;
      carried_off += k < lanes ? static_cast<std::int32_t>((stay | fly) ^ 1) : 0;
    }
  }
  air.rows_flown += rows_flown;
  air.carried_off += carried_off;
}

/// The slabs of a load that are not the first.
void decide_others(const SnowLandings& landings, int first_row, int end, Arrivals& all, int k, SnowAir& air) {
  std::uint64_t word = all.word[k];
  for (std::uint32_t slabs = slabs_of(air.all_of(all.from[k], all.load[k])); slabs > 1; --slabs) {
    word = mix64(word);
    if (snow_stays(word, all.rest[k])) {
      all.snow_left[k] += snow_word(1, 1);
      all.way_left[k] |= snow_has_landed;
    } else if (snow_carried_off(word, landings.rests)) {
      ++air.carried_off;
    } else {
      const SnowHop hop = snow_hop(all.way[k], run_of(all.way[k]), static_cast<std::uint32_t>(word >> 32));
      const int row = first_row + all.row[k] + hop.rows;
      const int window = (row / snow_window & (air.windows - 1)) * snow_lines + all.line[k];
      const std::uint32_t bit = 1u << (row & (snow_window - 1));
      air.put(window * snow_window + (row & (snow_window - 1)), short_slab + static_cast<std::uint32_t>(hop.load));
      (row < end ? all.waiting[k] : air.falls[window]) |= bit;
      air.rows_flown += hop.rows;
    }
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
void strike(const SnowLandings& landings, int first_row, const SnowAir& air, Arrivals& all, int k) {
  const SnowLines& lines = landings.lines;
  const int here = all.cell[k];
  const std::uint32_t hops = std::uint32_t{lines.powers[here]} << 16;
  if (hops == 0) return;
  const std::int32_t* const ground = landings.ground;
  const int row = first_row + all.row[k];
  const int line = all.line[k];
  std::int32_t upwind = landings.upwind[line];
  if (row > 0) {
    const int before = lines.places[row - 1] + line * lines.next_line;
    upwind = mobile_of(lines.cells[before].snow) + (ground != nullptr ? ground[before] : 0);
  }
  const std::int32_t most = mobile_of(all.snow[k]);
  const std::int32_t surface = most + (ground != nullptr ? ground[here] : 0);
  const float rise = upwind == no_surface ? 0.0f : static_cast<float>(surface - upwind);
  const std::uint64_t load = air.all_of(all.from[k], all.load[k]);
  const float power = strike_power(*landings.law, hops, load, rise);
  const std::int32_t freed = freed_slabs(*landings.law, load, all.word[k], power,
                                         [&] { return strength_at(landings, row, line, all.snow[k]); });
  all.snow_left[k] += static_cast<std::uint32_t>(freed < most ? freed : most);
}

/// Loads that strike bonded snow, and those of more than one slab.
void decide_further(const SnowLandings& landings, int first_row, int end, Arrivals& all, SnowAir& air) {
  std::int32_t some[snow_lines];
  int count = 0;
  for (int k = 0; k < all.count; ++k) {
    some[count] = k;
    count += all.further[k] != 0 ? 1 : 0;
  }
  for (int n = 0; n < count; ++n) {
    const int k = some[n];
    if ((all.further[k] & strikes_bonded) != 0) strike(landings, first_row, air, all, k);
    if ((all.further[k] & is_crowd) != 0) decide_others(landings, first_row, end, all, k, air);
  }
}

/// Lanes too many look at the first row of the first line.
[[gnu::always_inline]] inline void fill_up(Arrivals& all) {
  for (int k = 0; k < side_by_side; ++k) all.line[all.count + k] = 0, all.waiting[all.count + k] = 1;
}

/// Writes what was decided; leaves those lines in which something else comes down.
void settle(const SnowLines& lines, const SnowAir& given_air, Arrivals& all) {
  const SnowAir air = given_air;
  StripCell* const cells = lines.cells;
  int count = 0;
  for (int k = 0; k < all.count; ++k) {
    cells[all.cell[k]] = {all.snow_left[k], all.way_left[k]};
    const int from = all.from[k];
    if (all.load[k] >= most_short_slabs * short_slab) air.excess[from] = 0;
    air.loads[from] = 0;
    air.put(all.place[k], all.push[k]);
    air.falls[all.window[k]] |= all.fall[k];
    const std::uint32_t waiting = all.waiting[k];
    all.line[count] = all.line[k];
    all.waiting[count] = waiting;
    count += waiting != 0 ? 1 : 0;
  }
  all.count = count;
  fill_up(all);
}

void land(const SnowLandings& landings, const std::uint64_t* row_words, int first_row, int end, std::uint64_t among,
          SnowAir& air) {
  const SnowLines lines = landings.lines;
  std::uint32_t* const falls = air.falls + (first_row / snow_window & (air.windows - 1)) * snow_lines;
  const int rows = end - first_row;
  const std::uint32_t within = rows < snow_window ? (1u << rows) - 1 : ~0u;
  Arrivals all;
  for (int line = 0; line < lines.lines; ++line) {
    const std::uint32_t waiting = falls[line] & within & -static_cast<std::uint32_t>(among >> line & 1);
    falls[line] ^= waiting;
    all.line[all.count] = line;
    all.waiting[all.count] = waiting;
    all.count += waiting != 0 ? 1 : 0;
  }
  fill_up(all);
  while (all.count > 0) {
    take_first(lines, first_row, air, all);
    decide(landings, row_words, first_row, end, all, air);
    decide_further(landings, first_row, end, all, air);
    settle(lines, air, all);
  }
}
