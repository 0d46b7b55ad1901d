// Kernels of snow in flight, part of snow_kernels.inl: a strip of lines goes down the wind row by row. In each row
// slabs lift from polled cells; then those come down that are in the air there. All lines of a row are independent of
// each other, so their random words, rests and hops are vectors' work; what is drawn for them is then written one after
// another. What slabs do is random, so no branch of the inner loops hangs on it where a choice between two numbers will
// do.

constexpr int side_by_side = 16;  // lanes that are worked on together; those too many do no harm

// --- lifting ---

// A polled cell: its line and its row in the block, and whether loose snow would lift there, and bonded snow.
constexpr int polled_row_bit = 8;
constexpr int lifts_loose_bit = 14;
constexpr int lifts_hard_bit = 15;

/// Polls one cell of each of the lines from `begin` to before `end` in a block of as many rows as there are sub-sweeps,
/// and lists those that might let a slab go; returns how many. On an open grid only those whose line has, or has not,
/// crossed the side since the first row of the block.
[[gnu::noinline]] int poll(const SnowPlanes& planes, const SnowSweep& sweep, int block, const SnowStrip& strip,
                           int begin, int end, bool crossed, std::uint16_t* list) {
  constexpr int lanes = 64;
  alignas(64) std::uint32_t polled[lanes];
  const std::uint32_t* __restrict polled_row = sweep.polled_row;
  const std::uint32_t* __restrict chances = planes.chances;
  const int* __restrict offsets = planes.offsets + 1 + block;
  const std::uint32_t block_key = snow_poll_key(sweep, block);
  const std::uint32_t sweep_key = sweep.key;
  const std::int32_t width = planes.width;
  const std::int32_t step_u = planes.step_u;
  const std::int32_t step_v = planes.step_v;
  const std::int32_t origin = planes.origin + block * step_v;
  const std::int32_t rows = planes.length - block;
  const std::int32_t open = planes.torus ? 0 : 1;
  const std::int32_t wanted = crossed ? 1 : 0;
  int count = 0;
  for (int first = begin; first < end; first += lanes) {
    const std::int32_t first_line = strip.first + first;
    const std::int32_t lines = end - first;
    ERG_EACH(i, lanes) {
      const std::uint32_t word = snow_poll_word(block_key, static_cast<std::uint32_t>(first_line + i));
      const auto row = static_cast<std::int32_t>(polled_row[static_cast<std::int32_t>(word >> 24)]);
      const std::int32_t inside = (row < rows ? 1 : 0) & (i < lines ? 1 : 0);
      const std::int32_t there = row & -inside;
      const std::int32_t line = first_line + (i & -inside);
      const std::int32_t gone = offsets[there] + line;
      const std::int32_t column = gone < width ? gone : gone - width;
      const std::int32_t began = offsets[0] + line < width ? offsets[0] + line : offsets[0] + line - width;
      const std::uint32_t chance = chances[origin + column * step_u + there * step_v];
      const std::uint32_t drawn = snow_poll_draw(word, sweep_key);
      const std::uint32_t lifts =
          (drawn < (chance & 0xffff) ? 1u << lifts_loose_bit : 0u) | (drawn < chance >> 16 ? 1u << lifts_hard_bit : 0u);
      const std::int32_t listed = inside & (((column < began ? 1 : 0) & open) == wanted ? 1 : 0);
      polled[i] = static_cast<std::uint32_t>(first + i + (there << polled_row_bit)) |
                  (lifts & -static_cast<std::uint32_t>(listed));
    }
    for (const std::uint32_t poll : polled) {
      list[count] = static_cast<std::uint16_t>(poll);
      count += poll >> lifts_loose_bit != 0 ? 1 : 0;
    }
  }
  return count;
}

/// Slabs lift from polled cells of a block and hop: lift_chance_of, without_slab, snow_line_word and snow_hop in lanes
/// of 32 bits. All of a block may lift before any comes down in it: neither changes what the other reads.
[[gnu::noinline]] void lift(const SnowPlanes& planes, int block, const std::uint64_t* __restrict row_words,
                            const std::uint16_t* polls, int count, SnowStrip& strip) {
  alignas(64) std::int32_t line[snow_strip_list];
  alignas(64) std::int32_t place[snow_strip_list];
  alignas(64) std::uint32_t left[snow_strip_list];  // of the cell's snow
  alignas(64) std::uint32_t goes[snow_strip_list];
  alignas(64) std::int32_t ring_row[snow_strip_list];
  alignas(64) std::uint32_t share[snow_strip_list];
  auto* const words = reinterpret_cast<std::uint32_t*>(planes.cells);  // a cell's two
  const SnowStrip air = strip;                                         // a copy, which no store can change
  const int* __restrict offsets = planes.offsets + 1 + block;
  const std::int32_t width = planes.width;
  const std::int32_t step_u = planes.step_u;
  const std::int32_t step_v = planes.step_v;
  const std::int32_t origin = planes.origin + block * step_v;
  const std::int32_t first_line = air.first;
  std::int32_t rows_flown = 0;
  std::int32_t lifted = 0;
  for (int first = 0; first < count; first += side_by_side) {
    alignas(64) std::int32_t poll[side_by_side];
    alignas(64) std::int32_t row[side_by_side];
    alignas(64) std::uint32_t way[side_by_side];
    alignas(64) std::uint64_t word[side_by_side];
    const std::uint16_t* __restrict list = polls + first;
    const std::uint32_t* __restrict found = words;
    const std::int32_t lanes = count - first;
    ERG_EACH(k, side_by_side) poll[k] = k < lanes ? list[k] : 0;
    ERG_EACH(k, side_by_side) {
      const std::int32_t here = poll[k] & 0xff;
      row[k] = poll[k] >> polled_row_bit & 0x3f;
      const std::int32_t column = offsets[row[k]] + first_line + here;
      const std::int32_t at = origin + (column < width ? column : column - width) * step_u + row[k] * step_v;
      const std::uint32_t snow = found[2 * at];
      const std::uint32_t loose = (snow & 0xffff) != 0 ? 1 : 0;
      const std::uint32_t hard = snow != 0 ? 1 : 0;
      const auto lifts_loose = static_cast<std::uint32_t>(poll[k] >> lifts_loose_bit & 1);
      const auto lifts_hard = static_cast<std::uint32_t>(poll[k] >> lifts_hard_bit & 1);
      const std::uint32_t lets_go = (loose & lifts_loose) | ((loose ^ 1) & hard & lifts_hard);
      line[first + k] = here;
      place[first + k] = at;
      goes[first + k] = lets_go;
      left[first + k] = snow - lets_go * 0x10000u - (lets_go & loose);
      way[k] = found[2 * at + 1];
    }
    ERG_EACH(k, side_by_side) {
      word[k] = mix64(row_words[row[k]] + static_cast<std::uint64_t>(first_line + line[first + k]));
    }
    ERG_EACH(k, side_by_side) {
      const std::int32_t run = run_of(way[k]);
      const std::int32_t whole = snow_hop_rows(way[k], static_cast<std::uint32_t>(word[k]));
      const std::int32_t flown = whole < run ? whole : run;
      ring_row[first + k] = air.ring_row(block + row[k] + flown);
      share[first + k] = share_of_hop(flown, whole) & -goes[first + k];
      rows_flown += flown & -static_cast<std::int32_t>(goes[first + k]);
      lifted += static_cast<std::int32_t>(goes[first + k]);
    }
  }
  strip.rows_flown += rows_flown;
  strip.lifts += lifted;
  for (int k = 0; k < count; ++k) {
    words[2 * place[k]] = left[k];
    air.put(ring_row[k], line[k], goes[k] * one_slab + share[k]);
  }
  if (planes.lift_counts == nullptr) return;
  for (int k = 0; k < count; ++k) planes.lift_counts[planes.cell_at(place[k])] += static_cast<std::int32_t>(goes[k]);
}

/// Asks for the cells that lift next: the processor does not foresee where they lie.
void fetch_polled(const SnowPlanes& planes, int block, int list, const SnowStrip& strip) {
  if (block >= planes.length) return;
  for (int k = 0; k < strip.poll_counts[list]; ++k) {
    const std::int32_t poll = strip.polls[list * snow_strip_list + k];
    const int row = block + (poll >> polled_row_bit & 0x3f);
    __builtin_prefetch(planes.cells + planes.place_of_line(strip.first + (poll & 0xff), row), 1);
  }
}

// --- coming down ---

/// Loads that come down in a row, each in another line.
struct Arrivals {
  alignas(64) std::int32_t line[snow_strip_list];
  alignas(64) std::int32_t place[snow_strip_list];
  alignas(64) std::uint64_t word[snow_strip_list];
  alignas(64) std::uint32_t snow[snow_strip_list];  // of the cell
  alignas(64) std::uint32_t way[snow_strip_list];
  alignas(64) std::uint32_t rest[snow_strip_list];       // chance of 65536 to stay
  alignas(64) std::uint32_t snow_left[snow_strip_list];  // of the cell afterwards
  alignas(64) std::uint32_t way_left[snow_strip_list];
  alignas(64) std::uint32_t strikes[snow_strip_list];  // 1: on bonded snow
  // Of the first slab of each: where it goes on, as a load; both halves 0 where it does not.
  alignas(64) std::int32_t ring_row[snow_strip_list];
  alignas(64) std::uint32_t flies[snow_strip_list];
  alignas(64) std::uint32_t share[snow_strip_list];
};

/// Looks at the cells in which loads come down, and decides on the first slab of each, by the snow as it finds it:
/// snow_line_word, chance_to_stay, snow_stays, snow_carried_off and snow_hop in lanes of 32 bits.
[[gnu::always_inline]] inline void decide(const SnowPlanes& planes, bool last, int row, std::uint64_t row_word,
                                          const std::uint16_t* __restrict list, int count, Arrivals& all,
                                          SnowStrip& strip) {
  const SnowStrip air = strip;
  const auto* __restrict words = reinterpret_cast<const std::uint32_t*>(planes.cells);
  const std::int32_t width = planes.width;
  const std::int32_t step_u = planes.step_u;
  const std::int32_t origin = planes.origin + row * planes.step_v;
  const std::int32_t offset = planes.offsets[row + 1] + air.first;
  const std::uint64_t first_word = row_word + static_cast<std::uint64_t>(strip.first);
  const SnowRests rests = planes.rests;
  const std::uint32_t least_rest = last ? certain : 0;
  std::int32_t rows_flown = 0;
  std::int32_t carried_off = 0;
  for (int first = 0; first < count; first += side_by_side) {
    const std::int32_t lanes = count - first;
    ERG_EACH(i, side_by_side) all.line[first + i] = list[first + i];
    ERG_EACH(i, side_by_side) {
      const int k = first + i;
      const std::int32_t column = offset + all.line[k];
      all.place[k] = origin + (column < width ? column : column - width) * step_u;
      all.snow[k] = words[2 * all.place[k]];
      all.way[k] = words[2 * all.place[k] + 1];
    }
    ERG_EACH(i, side_by_side) {
      all.word[first + i] = mix64(first_word + static_cast<std::uint64_t>(all.line[first + i]));
    }
    ERG_EACH(i, side_by_side) {
      const int k = first + i;
      const std::uint32_t snow = all.snow[k];
      const std::uint32_t way = all.way[k];
      const auto low = static_cast<std::uint32_t>(all.word[k]);
      const auto high = static_cast<std::uint32_t>(all.word[k] >> 32);
      const std::uint32_t on_bare = snow != 0 ? rests.hard : rests.ground;
      const std::uint32_t on_snow = (snow & 0xffff) != 0 ? rests.loose : on_bare;
      const std::uint32_t in_light = on_snow > least_rest ? on_snow : least_rest;
      const std::uint32_t rest = mean_hop_64(way) == 0 ? certain : in_light;
      const std::uint32_t stays = (low & 0xffff) < rest ? 1 : 0;
      const std::uint32_t off = ((low >> 16) < rests.suspension ? 1 : 0) & (stays ^ 1);
      const std::uint32_t flies = (stays | off) ^ 1;
      const std::int32_t run = run_of(way);
      const std::int32_t whole = snow_hop_rows(way, high);
      const std::int32_t flown = whole < run ? whole : run;
      all.rest[k] = rest;
      all.strikes[k] = (snow != 0 ? 1 : 0) & ((snow & 0xffff) == 0 ? 1 : 0);
      all.snow_left[k] = snow + stays * snow_word(1, 1);
      all.way_left[k] = way | stays * snow_has_landed;
      all.flies[k] = flies;
      all.share[k] = share_of_hop(flown, whole) & -flies;
      all.ring_row[k] = air.ring_row(row + flown);
      rows_flown += i < lanes ? flown & -static_cast<std::int32_t>(flies) : 0;
      carried_off += i < lanes ? static_cast<std::int32_t>(off) : 0;
    }
  }
  strip.rows_flown += rows_flown;
  strip.slabs_out += carried_off;
}

/// The slabs of a load that are not the first.
void decide_others(const SnowPlanes& planes, int row, std::uint64_t load, int k, Arrivals& all, SnowStrip& strip) {
  std::uint64_t word = all.word[k];
  for (std::uint32_t slabs = slabs_of(load); slabs > 1; --slabs) {
    word = mix64(word);
    if (snow_stays(word, all.rest[k])) {
      all.snow_left[k] += snow_word(1, 1);
      all.way_left[k] |= snow_has_landed;
    } else if (snow_carried_off(word, planes.rests)) {
      ++strip.slabs_out;
    } else {
      const SnowHop hop = snow_hop(all.way[k], run_of(all.way[k]), static_cast<std::uint32_t>(word >> 32));
      strip.put(strip.ring_row(row + hop.rows), all.line[k], hop.load);
      strip.rows_flown += hop.rows;
    }
  }
}

/// How many slabs of bonded snow the impacts of a load free in place.
[[gnu::noinline]] std::int32_t strike(const SnowPlanes& planes, int row, std::uint64_t load, int k, const Arrivals& all,
                                      int first_line) {
  const std::int32_t place = all.place[k];
  const std::uint32_t hops = std::uint32_t{planes.powers[place]} << 16;
  if (hops == 0) return 0;
  const auto ground = [&planes](std::int32_t at) { return planes.relief ? planes.bedrock[planes.cell_at(at)] : 0; };
  const std::int32_t mobile = mobile_of(all.snow[k]);
  const int line = first_line + all.line[k];
  std::int32_t rise = 0;
  if (row > 0) {
    const std::int32_t upwind = planes.place_of_line(line, row - 1);
    rise = mobile + ground(place) - mobile_of(planes.cells[upwind].snow) - ground(upwind);
  } else if (planes.torus) {  // behind the edge all is as it was before the flights
    const std::int32_t upwind = planes.place_of_line(line, -1) + planes.length * planes.step_v;
    rise = mobile + ground(place) - planes.mobile[planes.cell_at(upwind)] - ground(upwind);
  }
  const float power = strike_power(*planes.law, hops, load, static_cast<float>(rise));
  const std::int32_t freed = freed_slabs(*planes.law, load, all.word[k], power, [&] {
    return snow_strength(*planes.law, place % planes.pitch, place / planes.pitch, mobile);
  });
  return freed < mobile ? freed : mobile;
}

/// Brings down all that is in the air over a row: slabs strike what lies there, stay or fly on.
[[gnu::noinline]] void land(const SnowPlanes& planes, bool last, int row, std::uint64_t row_word, SnowStrip& strip) {
  const SnowStrip air = strip;
  const int there = air.ring_row(row);
  const int count = air.counts[there];
  if (count == 0) return;
  Arrivals all;
  decide(planes, last, row, row_word, air.lists + there * snow_strip_list, count, all, strip);
  for (int k = 0; k < count; ++k) {
    std::uint64_t& load = air.load(there, all.line[k]);
    if (all.strikes[k] != 0) {
      all.snow_left[k] += static_cast<std::uint32_t>(strike(planes, row, load, k, all, air.first));
    }
    if (slabs_of(load) > 1) decide_others(planes, row, load, k, all, strip);
    planes.cells[all.place[k]] = {all.snow_left[k], all.way_left[k]};
    load = 0;
    air.put(all.ring_row[k], all.line[k], all.flies[k] * one_slab + all.share[k]);
  }
  air.counts[there] = 0;
}

// --- edges ---

/// The slabs in the air over a line have left over an open side before this row.
void drop_out(int row, int line, SnowStrip& strip) {
  for (int rows = 0; rows <= static_cast<int>(strip.ring_mask); ++rows) {
    const int there = strip.ring_row(row + rows);
    std::uint64_t& load = strip.load(there, line);
    if (load == 0) continue;
    const std::int64_t slabs = slabs_of(load);
    strip.slabs_out += slabs;
    strip.rows_flown -= slabs * (rows + 1);
    load = 0;
    std::uint16_t* listed = strip.lists + there * snow_strip_list;
    const std::uint16_t last = listed[--strip.counts[there]];
    while (*listed != line) ++listed;
    *listed = last;
  }
}

/// Drift comes in over an open edge.
void enter(const SnowPlanes& planes, const SnowSweep& sweep, int row, int line, SnowStrip& strip) {
  if (planes.inflow <= 0 || !sweep.polls) return;
  std::uint32_t word = entering_word(sweep, strip.first + line);
  const int slabs = entering_slabs(planes.inflow, planes.sweeps, word);
  const std::uint32_t way = planes.cells[planes.place_of_line(strip.first + line, row)].way;
  for (int slab = 0; slab < slabs; ++slab) {
    word = next_snow_word(word);
    const int rows = entering_rows(way, run_of(way), word);
    strip.put(strip.ring_row(row + rows), line, one_slab + whole_hop);
    strip.rows_flown += rows;
  }
  strip.slabs_in += slabs;
}

/// The line of a strip that begins anew in this row of an open grid, having left it on the other side; -1 if none does.
int crossing_line(const SnowPlanes& planes, int row, const SnowStrip& strip) {
  const int offset = planes.offsets[row + 1];
  if (row == 0 || offset == planes.offsets[row]) return -1;
  const int line = (offset == 0 ? 0 : planes.width - offset) - strip.first;
  return line < strip.lines ? line : -1;
}

/// What is in the air over the last row goes on at the other end of the torus, or has left over the open edge.
void leave_grid(const SnowPlanes& planes, SnowStrip& strip) {
  if (planes.torus && planes.closes) {
    strip.ring_first += static_cast<std::uint32_t>(planes.length);
    return;
  }
  for (int rows = 0; rows <= static_cast<int>(strip.ring_mask); ++rows) {
    const int there = strip.ring_row(planes.length + rows);
    for (int k = 0; k < strip.counts[there]; ++k) {
      const int line = strip.lists[there * snow_strip_list + k];
      std::uint64_t& load = strip.load(there, line);
      if (planes.torus) {
        const int next = (strip.first + line + planes.drift) % planes.width;
        planes.handed_over[static_cast<std::ptrdiff_t>(rows) * planes.width + next] += load;
        strip.hands_over = true;
      } else {
        const std::int64_t slabs = slabs_of(load);
        strip.slabs_out += slabs;
        strip.rows_flown -= slabs * (rows + 1);
      }
      load = 0;
    }
    strip.counts[there] = 0;
  }
}

void poll_all(const SnowPlanes& planes, SnowStrip& strip) {
  for (int block = 0; block < planes.length; block += planes.sweeps) {
    for (int number = 0; number < planes.sweeps; ++number) {
      const int list = block + number;
      strip.poll_counts[list] =
          poll(planes, planes.draws[number], block, strip, 0, strip.lines, false, strip.polls + list * snow_strip_list);
    }
  }
}

void fly(const SnowPlanes& given, int number, SnowStrip& strip) {
  const SnowPlanes planes = given;
  const SnowSweep& sweep = planes.draws[number];
  alignas(64) std::uint64_t row_words[64] = {};
  alignas(64) std::uint16_t polls[snow_strip_list] = {};
  for (int row = 0; row < planes.length && (sweep.polls || strip.anything_aloft()); ++row) {
    const int block = row & -planes.sweeps;
    const int crossing = planes.torus ? -1 : crossing_line(planes, row, strip);
    if (crossing >= 0) {
      drop_out(row, crossing, strip);
      enter(planes, sweep, row, crossing, strip);
    }
    if (row == block) {
      ERG_EACH(k, planes.sweeps) row_words[k] = flight_row_word(sweep.key, row + k);
      const int list = block + number;  // of a block and sub-sweep
      if (sweep.polls) {
        lift(planes, block, row_words, strip.polls + list * snow_strip_list, strip.poll_counts[list], strip);
        fetch_polled(planes, block + planes.sweeps, list + planes.sweeps, strip);
      }
    } else if (crossing >= 0) {  // what was in the air is lost; only now may a slab of this line lift in the block
      const int count = poll(planes, sweep, block, strip, crossing, crossing + 1, true, polls);
      lift(planes, block, row_words, polls, count, strip);
    }
    for (int line = 0; row == 0 && !planes.torus && line < strip.lines; ++line) enter(planes, sweep, row, line, strip);
    land(planes, sweep.last, row, ~row_words[row - block], strip);
  }
  leave_grid(planes, strip);
}
