// Part of sweep_kernels.inl: slopes that are too steep slide, edge by edge. Edges of one class share no cell, so their
// order does not matter; the classes come in an order drawn anew each sub-sweep, which removes any bias in direction.


/// One slab down each edge between lanes of two rows that is steeper than what stands.
template <typename Lane, bool relief, bool varied>
void slide_lanes(Lane* __restrict a, Lane* __restrict b, const Lane* bedrock_a, const Lane* bedrock_b,
                 const Lane* step_a, const Lane* step_b, Lane step, int lanes) {
  ERG_EACH(i, lanes) {
    const Lane here = a[i];
    const Lane there = b[i];
    const Lane stands_a = varied ? step_a[i] : step;
    const Lane stands_b = varied ? step_b[i] : step;
    Lane down = here > static_cast<Lane>(there + stands_a) ? 1 : 0;
    Lane up = there > static_cast<Lane>(here + stands_b) ? 1 : 0;
    if (relief) {
      down = here > bedrock_a[i] ? down : Lane{0};
      up = there > bedrock_b[i] ? up : Lane{0};
    }
    a[i] = static_cast<Lane>(here - down + up);
    b[i] = static_cast<Lane>(there + down - up);
  }
}

/// Two neighbouring lanes read as one word of twice the width, so that edges within a row need no shuffles.
template <typename Lane>
struct LanePair {
  using Word = std::conditional_t<sizeof(Lane) == 1, std::uint16_t, std::uint32_t>;
  static constexpr int bits = 8 * static_cast<int>(sizeof(Lane));
  static Word read(const Lane* lanes) {
    Word word;
    __builtin_memcpy(&word, lanes, sizeof word);
    return word;
  }
  static Word low(Word word) { return static_cast<Word>(word & ((Word{1} << bits) - 1)); }
  static Word high(Word word) { return static_cast<Word>(word >> bits); }
};

/// One slab down each edge within `pairs` pairs of neighbouring lanes.
template <typename Lane, bool relief, bool varied>
void slide_pairs(Lane* lanes, const Lane* bedrock, const Lane* steps, int step, int pairs) {
  using Pair = LanePair<Lane>;
  using Word = typename Pair::Word;
  ERG_EACH(k, pairs) {
    Word word = Pair::read(lanes + 2 * k);
    const Word low = Pair::low(word);
    const Word high = Pair::high(word);
    Word low_stands = static_cast<Word>(step);
    Word high_stands = static_cast<Word>(step);
    if (varied) {
      const Word stands = Pair::read(steps + 2 * k);
      low_stands = Pair::low(stands);
      high_stands = Pair::high(stands);
    }
    Word up = low > static_cast<Word>(high + low_stands) ? 1 : 0;     // one slab from low to high
    Word down = high > static_cast<Word>(low + high_stands) ? 1 : 0;  // one slab from high to low
    if (relief) {
      const Word rock = Pair::read(bedrock + 2 * k);
      up = low > Pair::low(rock) ? up : Word{0};
      down = high > Pair::high(rock) ? down : Word{0};
    }
    word = static_cast<Word>(word - up + down + static_cast<Word>(up << Pair::bits) -
                             static_cast<Word>(down << Pair::bits));
    __builtin_memcpy(lanes + 2 * k, &word, sizeof word);
  }
}

template <typename Lane>
class Slider {
 public:
  explicit Slider(const SlidePlan<Lane>& plan) : plan_(plan) {}

  void tile(const SlideTile& tile) const {
    const int classes = plan_.diagonals ? 8 : 4;
    for (int k = 0; k < classes; ++k) {
      const EdgeClass edges = static_cast<EdgeClass>(plan_.order[k]);
      if (edges == across_even || edges == across_odd) {
        for (int y = tile.first_row; y < tile.end_row; ++y) across(y, tile, edges == across_odd ? 1 : 0);
        continue;
      }
      const int odd = edges == along_odd || edges == rising_odd || edges == falling_odd ? 1 : 0;
      for (int y = tile.first_row + ((tile.first_row & 1) != odd ? 1 : 0); y + 1 < tile.end_row; y += 2) {
        between_rows(y, y + 1, tile, edges);
      }
    }
  }

  void row_seam(const SlideTile& below) const {
    const int upper = below.end_row == plan_.layout.length ? 0 : below.end_row;
    between_rows(below.end_row - 1, upper, below, along_even);
    if (!plan_.diagonals) return;
    between_rows(below.end_row - 1, upper, below, rising_even);
    between_rows(below.end_row - 1, upper, below, falling_even);
  }

  void column_seam(int left_block, int right_block) const {
    const PlaneLayout& layout = plan_.layout;
    const std::size_t left = layout.at(left_block, layout.columns_of(left_block) - 1, 0);
    const std::size_t right = layout.at(right_block, 0, 0);
    const auto edges = [&](std::size_t from, std::size_t to, int rows_up, const Lane* steps, int step) {
      for (int y = 0; y < plan_.layout.length; ++y) {
        const int upper = y + rows_up < plan_.layout.length ? y + rows_up : 0;
        if (upper < y && plan_.open) continue;
        run(from + row(y), to + row(upper), 1, steps, step);
      }
    };
    edges(left, right, 0, plan_.steps, plan_.step);
    if (!plan_.diagonals || plan_.layout.length < 2) return;
    edges(left, right, 1, plan_.diagonal_steps, plan_.diagonal_step);
    edges(right, left, 1, plan_.diagonal_steps, plan_.diagonal_step);
  }

 private:
  std::size_t row(int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(plan_.layout.pitch); }

  void between_rows(int lower, int upper, const SlideTile& tile, EdgeClass edges) const {
    const std::size_t a = plan_.layout.at(tile.block, 0, lower);
    const std::size_t b = plan_.layout.at(tile.block, 0, upper);
    const int columns = plan_.layout.columns_of(tile.block);
    if (edges == along_even || edges == along_odd) {
      run(a, b, columns, plan_.steps, plan_.step);
      return;
    }
    const std::size_t rising = edges == rising_even || edges == rising_odd ? 1 : 0;
    run(a + 1 - rising, b + rising, columns - 1, plan_.diagonal_steps, plan_.diagonal_step);
  }

  /// Edges between cells a, a + 1, ... and b, b + 1, ...
  void run(std::size_t a, std::size_t b, int lanes, const Lane* steps, int step) const {
    Lane* heights = plan_.heights;
    const Lane* bedrock = plan_.bedrock;
    const Lane limit = static_cast<Lane>(step);
    if (bedrock && steps) {
      slide_lanes<Lane, true, true>(heights + a, heights + b, bedrock + a, bedrock + b, steps + a, steps + b, limit,
                                    lanes);
    } else if (bedrock) {
      slide_lanes<Lane, true, false>(heights + a, heights + b, bedrock + a, bedrock + b, nullptr, nullptr, limit,
                                     lanes);
    } else if (steps) {
      slide_lanes<Lane, false, true>(heights + a, heights + b, nullptr, nullptr, steps + a, steps + b, limit, lanes);
    } else {
      slide_lanes<Lane, false, false>(heights + a, heights + b, nullptr, nullptr, nullptr, nullptr, limit, lanes);
    }
  }

  /// Edges within a row of a tile: its cells (0, 1), (2, 3) ... or (1, 2), (3, 4) ...
  void across(int y, const SlideTile& tile, int first) const {
    const int pairs = (plan_.layout.columns_of(tile.block) - first) / 2;
    const std::size_t at = plan_.layout.at(tile.block, first, y);
    if (plan_.bedrock && plan_.steps) {
      slide_pairs<Lane, true, true>(plan_.heights + at, plan_.bedrock + at, plan_.steps + at, plan_.step, pairs);
    } else if (plan_.bedrock) {
      slide_pairs<Lane, true, false>(plan_.heights + at, plan_.bedrock + at, nullptr, plan_.step, pairs);
    } else if (plan_.steps) {
      slide_pairs<Lane, false, true>(plan_.heights + at, nullptr, plan_.steps + at, plan_.step, pairs);
    } else {
      slide_pairs<Lane, false, false>(plan_.heights + at, nullptr, nullptr, plan_.step, pairs);
    }
  }

  const SlidePlan<Lane>& plan_;
};
