// Kernels by which a strip takes the snow of its lines from the terrain and gives it back, part of snow_kernels.inl.
// What a step's flights can know beforehand is found on the way: how far slabs fly, and which cells let one go.

/// Cells in which higher ground stands so many rows ahead. A function of its own, or the compiler would join rows
/// instead of making vectors.
[[gnu::noinline]] void look_ahead(const std::int16_t* __restrict there, const std::int16_t* __restrict height,
                                  std::int16_t rows, std::int16_t* __restrict run) {
  ERG_EACH(i, snow_stretch) run[i] = there[i] > height[i] ? rows : run[i];
}
/// The same where lines drift: each has gone on by `least` places or one more, where `beside` stands.
[[gnu::noinline]] void look_aside(const std::int16_t* __restrict there, const std::int16_t* __restrict beside,
                                  const std::int16_t* __restrict moved, const std::int16_t* __restrict height,
                                  std::int16_t rows, std::int16_t* __restrict run) {
  ERG_EACH(i, snow_stretch) {
    const auto met = static_cast<std::int16_t>(there[i] ^ ((there[i] ^ beside[i]) & moved[i]));
    run[i] = met > height[i] ? rows : run[i];
  }
}
/// All ones where a line moves more than `least` places, else 0.
[[gnu::noinline]] void find_moved(const std::int16_t* __restrict before, const std::int16_t* __restrict after,
                                  std::int16_t least, std::int16_t* __restrict moved) {
  ERG_EACH(i, snow_stretch) moved[i] = static_cast<std::int16_t>(least + before[i] - after[i]);
}

/// Rows until higher ground, of cells side by side; `unhindered_run` where there is none within reach.
void find_runs(const SnowAhead& ahead, int clearance_16, std::int16_t* __restrict run) {
  alignas(64) std::int16_t height[snow_stretch];
  alignas(64) std::int16_t moved[snow_stretch];
  const std::int16_t* __restrict from = ahead.heights;
  ERG_EACH(i, snow_stretch) {
    height[i] = static_cast<std::int16_t>(flying_height(from[i], clearance_16));
    run[i] = unhindered_run;
  }
  for (int k = ahead.reach; k > 0; --k) {
    const std::int16_t* const there = from + k * ahead.next_row;
    if (ahead.drifted == nullptr) {
      look_ahead(there, height, static_cast<std::int16_t>(k), run);
      continue;
    }
    const std::int16_t least = ahead.least_drifted[k];
    const std::int16_t* const drifted = there + least * ahead.next_line;
    find_moved(ahead.drifted, ahead.drifted + k, least, moved);
    look_aside(drifted, drifted + ahead.next_line, moved, height, static_cast<std::int16_t>(k), run);
  }
}

/// `step` is a constant, so that both directions become vectors.
template <int step>
[[gnu::always_inline]] inline void take_in_order(const SnowStretch& stretch, const std::int16_t* __restrict run) {
  const std::int32_t* __restrict mobile = stretch.mobile;
  const std::int32_t* __restrict loose = stretch.loose;
  const std::uint32_t* __restrict chances = stretch.chances;
  const std::uint32_t* __restrict hops = stretch.hops;
  StripCell* __restrict cells = stretch.cells;
  std::uint16_t* __restrict powers = stretch.powers;
  std::uint32_t* __restrict polled_chances = stretch.polled_chances;
  ERG_EACH(i, stretch.count) {
    cells[i].snow = snow_word(loose[i * step], mobile[i * step]);
    cells[i].way = mean_hop_64(hops[i * step]) | static_cast<std::uint32_t>(run[i]) << 16;
  }
  ERG_EACH(i, stretch.count) polled_chances[i] = chances[i * step];
  ERG_EACH(i, stretch.count) powers[i] = static_cast<std::uint16_t>(hops[i * step] >> 16);
}

void take_snow(const SnowStretch& stretch) {
  alignas(64) std::int16_t run[snow_stretch];
  find_runs(stretch.ahead, stretch.law->clearance_16, run);
  if (stretch.step == 1) {
    take_in_order<1>(stretch, run);
  } else {
    take_in_order<-1>(stretch, run);
  }
}

template <int step>
[[gnu::always_inline]] inline void give_in_order(const SnowStretch& stretch) {
  std::int32_t* __restrict mobile = stretch.mobile;
  std::int32_t* __restrict loose = stretch.loose;
  float* __restrict landed = stretch.landed;
  const StripCell* __restrict cells = stretch.cells;
  const float now = stretch.law->now;
  ERG_EACH(i, stretch.count) {
    const std::uint32_t snow = cells[i].snow;
    mobile[i * step] = mobile_of(snow);
    loose[i * step] = loose_of(snow);
    landed[i * step] = (cells[i].way & snow_has_landed) != 0 ? now : landed[i * step];
  }
}

void give_snow(const SnowStretch& stretch) {
  if (stretch.step == 1) {
    give_in_order<1>(stretch);
  } else {
    give_in_order<-1>(stretch);
  }
}

/// The polls of a block of rows in one sub-sweep, one a line: as SnowPollDraw lists them; those beyond the last line,
/// in other rows than the window's and those that cannot lift anything with neither bit set.
[[gnu::always_inline]] inline void poll_block(const SnowPollDraw& draw, const SnowLines& lines, const SnowSweep& sweep,
                                              int block, const std::uint32_t* __restrict words,
                                              std::uint32_t* __restrict polls) {
  const std::uint32_t* __restrict polled_row = sweep.polled_row;
  const std::uint32_t* __restrict chances = draw.chances;
  const int* __restrict places = lines.places + draw.first_row;
  const std::uint32_t key = sweep.key;
  const std::int32_t rows = draw.end - draw.first_row;
  const std::int32_t first = block - draw.first_row;
  const std::int32_t next_line = lines.next_line;
  const std::int32_t count_lines = lines.lines;
  ERG_EACH(i, snow_lines) {
    const std::uint32_t word = words[i];
    const std::int32_t row = first + static_cast<std::int32_t>(polled_row[static_cast<std::int32_t>(word >> 24)]);
    const std::int32_t polled = (row >= 0 ? 1 : 0) & (row < rows ? 1 : 0) & (i < count_lines ? 1 : 0);
    const std::int32_t there = row & -polled;
    const std::uint32_t here = chances[places[there] + i * next_line];
    const std::uint32_t drawn = snow_poll_draw(word, key);
    const std::uint32_t lifts =
        (drawn < (here & 0xffff) ? 1u << lifts_loose_bit : 0u) | (drawn < here >> 16 ? 1u << lifts_hard_bit : 0u);
    const auto place = static_cast<std::uint32_t>(there << polled_row_bit | i);
    polls[i] = place | (lifts & -static_cast<std::uint32_t>(polled));
  }
}

/// Lists those of a block that might lift something; returns how many. Writes up to 16 places beyond them.
[[gnu::always_inline]] inline int list_polls(const std::uint32_t* polls, std::uint16_t* list) {
  int count = 0;
#if defined(__AVX512BW__)
  const __m512i either = _mm512_set1_epi32(1 << lifts_loose_bit | 1 << lifts_hard_bit);
  for (int i = 0; i < snow_lines; i += 16) {
    const __m512i some = _mm512_loadu_si512(polls + i);
    const __mmask16 lift = _mm512_test_epi32_mask(some, either);
    const __m512i listed = _mm512_maskz_compress_epi32(lift, some);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(list + count), _mm512_maskz_cvtepi32_epi16(0xffff, listed));
    count += __builtin_popcount(lift);
  }
#else
  for (int i = 0; i < snow_lines; ++i) {
    list[count] = static_cast<std::uint16_t>(polls[i]);
    count += polls[i] >> lifts_loose_bit != 0 ? 1 : 0;
  }
#endif
  return count;
}

void draw_polls(const SnowPollDraw& draw, const SnowLines& lines) {
  alignas(64) std::uint32_t words[snow_lines];
  alignas(64) std::uint32_t polls[snow_lines];
  const int most = most_polls(draw.sweeps);
  for (int number = 0; number < draw.sweeps; ++number) draw.counts[number] = 0;
  for (int block = draw.first_row & -draw.sweeps; block < draw.end; block += draw.sweeps) {
    const std::uint32_t key = snow_poll_key(draw.draws[0], block);
    const auto first_line = static_cast<std::uint32_t>(lines.first_line);
    ERG_EACH(i, snow_lines) words[i] = snow_poll_word(key, first_line + static_cast<std::uint32_t>(i));
    for (int number = 0; number < draw.sweeps; ++number) {
      poll_block(draw, lines, draw.draws[number], block, words, polls);
      draw.counts[number] += list_polls(polls, draw.polls + number * most + draw.counts[number]);
    }
  }
}
