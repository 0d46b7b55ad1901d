// Part of sweep_kernels.inl: slopes that are too steep slide, edge by edge. Edges of one class share no cell, so their
// order does not matter; the classes come in an order drawn anew each sub-sweep, which removes any bias in direction.

/// One slab down each edge between lanes of two rows that is steeper than what stands.
template <typename Lane, bool relief, bool varied>
[[gnu::always_inline]] inline void slide_lanes(Lane* __restrict a, Lane* __restrict b, const Lane* bedrock_a,
                                               const Lane* bedrock_b, const Lane* step_a, const Lane* step_b, Lane step,
                                               int lanes) {
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

/// The same where bedrock is null when it is level, and steps when all are alike. Inlined for the sake of single edges.
template <typename Lane>
[[gnu::always_inline]] inline void slide_here(Lane* a, Lane* b, const Lane* bedrock_a, const Lane* bedrock_b,
                                              const Lane* step_a, const Lane* step_b, Lane step, int lanes) {
  if (bedrock_a && step_a) {
    slide_lanes<Lane, true, true>(a, b, bedrock_a, bedrock_b, step_a, step_b, step, lanes);
  } else if (bedrock_a) {
    slide_lanes<Lane, true, false>(a, b, bedrock_a, bedrock_b, nullptr, nullptr, step, lanes);
  } else if (step_a) {
    slide_lanes<Lane, false, true>(a, b, nullptr, nullptr, step_a, step_b, step, lanes);
  } else {
    slide_lanes<Lane, false, false>(a, b, nullptr, nullptr, nullptr, nullptr, step, lanes);
  }
}

template <typename Lane>
[[gnu::noinline]] void slide_edges(Lane* a, Lane* b, const Lane* bedrock_a, const Lane* bedrock_b, const Lane* step_a,
                                   const Lane* step_b, Lane step, int lanes) {
  slide_here(a, b, bedrock_a, bedrock_b, step_a, step_b, step, lanes);
}

/// Places by which the row above is shifted to the left: the cell above place p stands in place p - skew_step. The
/// edge of the torus is left out.
inline int skew_step(const PlaneLayout& layout, int y) {
  return y + 1 < layout.length ? layout.shift(y + 1) - layout.shift(y) : 0;
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
        across(tile, edges == across_odd ? 1 : 0);
        continue;
      }
      const int odd = edges == along_odd || edges == rising_odd || edges == falling_odd ? 1 : 0;
      const int first = tile.first_row + ((tile.first_row & 1) != odd ? 1 : 0);
      for (int y = first; y + 1 < tile.end_row; y += 2) level_margin(tile.block, y, edges);
      for (int y = first; y + 1 < tile.end_row; y += 2) to_next_row(tile.block, y, edges);
    }
  }

  void row_border(const SlideTile& below) const {
    above_tile(below, along_even);
    if (!plan_.diagonals) return;
    above_tile(below, rising_even);
    above_tile(below, falling_even);
  }

  /// What is left of the column borders of skewed planes: diagonals over the torus edge, whose upper cells may belong
  /// to any other border.
  void corners() const {
    const PlaneLayout& layout = plan_.layout;
    const int top = layout.length - 1;
    for (const bool rising : {true, false}) {
      for (int left = 0; left < layout.blocks; ++left) {
        const int right = left + 1 == layout.blocks ? 0 : left + 1;
        const int last = layout.columns_of(left) - 1;
        const int place = rising ? place_over_torus_edge(right, 0) : place_over_torus_edge(left, last);
        run(rising ? layout.at(left, last, top) : layout.at(right, 0, top), layout.at_place(place, 0), 1, true);
      }
    }
  }

 private:
  /// Columns from the lower to the upper cell of an edge.
  static int columns_over(EdgeClass edges) {
    if (!is_diagonal(edges)) return 0;
    return edges == rising_even || edges == rising_odd ? 1 : -1;
  }

  // Rows are worked off in whole vectors: a tail of single lanes takes as long as many vectors. The last vector reaches
  // into the margin beyond the row's end (PlaneLayout::pitch), whose cells mean nothing. So that they neither give to
  // the row nor take from it, they are made level with it first, for all rows of a class before the first is read: a
  // vector that reads what was only just written in part has to wait.
  static int whole_vectors(int lanes) { return (lanes + 63) / 64 * 64; }

  /// Columns by which the row above lies to the right of a row, for edges of a class.
  int shift_to_next_row(int y, EdgeClass edges) const { return columns_over(edges) - skew_step(plan_.layout, y); }

  /// Levels the margin for the edges of one class between row y of a block and the row above it.
  void level_margin(int block, int y, EdgeClass edges) const {
    const int shift = shift_to_next_row(y, edges);
    const int columns = plan_.layout.columns_of(block);
    for (int over = 0; over < -shift; ++over) {
      plan_.heights[plan_.layout.at(block, columns + over, y)] =
          plan_.heights[plan_.layout.at(block, columns + shift + over, y + 1)];
    }
    for (int over = 0; over < shift; ++over) {
      plan_.heights[plan_.layout.at(block, columns + over, y + 1)] =
          plan_.heights[plan_.layout.at(block, columns - shift + over, y)];
    }
  }

  /// Edges of one class between row y of a block and the row above it, once their margin is level.
  void to_next_row(int block, int y, EdgeClass edges) const {
    const int shift = shift_to_next_row(y, edges);
    const int left_out = shift < 0 ? -shift : shift;
    run(plan_.layout.at(block, shift < 0 ? -shift : 0, y), plan_.layout.at(block, shift > 0 ? shift : 0, y + 1),
        whole_vectors(plan_.layout.columns_of(block) - left_out), is_diagonal(edges));
  }

  void above_tile(const SlideTile& below, EdgeClass edges) const {
    if (below.end_row < plan_.layout.length) {
      level_margin(below.block, below.end_row - 1, edges);
      to_next_row(below.block, below.end_row - 1, edges);
    } else {
      over_torus_edge(below.block, edges);
    }
  }

  /// Edges from a block's last row to row 0. What lies above the block may stand in other blocks.
  void over_torus_edge(int block, EdgeClass edges) const {
    const PlaneLayout& layout = plan_.layout;
    const int over = columns_over(edges);
    int lane = over < 0 ? 1 : 0;
    const int end = layout.columns_of(block) - (over > 0 ? 1 : 0);
    while (lane < end) {
      const int place = place_over_torus_edge(block, lane + over);
      const int upper_block = layout.block_of(place);
      const int in_upper = place - upper_block * layout.block_columns;
      const int side_by_side = layout.columns_of(upper_block) - in_upper;
      const int lanes = side_by_side < end - lane ? side_by_side : end - lane;
      run(layout.at(block, lane, layout.length - 1), layout.at(upper_block, in_upper, 0), lanes, is_diagonal(edges));
      lane += lanes;
    }
  }

  /// The place in row 0 that lies above a block's column of the last row.
  int place_over_torus_edge(int block, int column) const {
    const PlaneLayout& layout = plan_.layout;
    return layout.wrapped(block * layout.block_columns + column + layout.shift(layout.length - 1) - layout.shift(0));
  }

  void run(std::size_t a, std::size_t b, int lanes, bool diagonal) const {
    if (diagonal) {
      run(a, b, lanes, plan_.diagonal_steps, plan_.diagonal_step);
    } else {
      run(a, b, lanes, plan_.steps, plan_.step);
    }
  }

  /// Edges between cells a, a + 1, ... and b, b + 1, ...
  void run(std::size_t a, std::size_t b, int lanes, const Lane* steps, int step) const {
    const auto cell = [](const Lane* plane, std::size_t at) { return plane ? plane + at : nullptr; };
    slide_edges(plan_.heights + a, plan_.heights + b, cell(plan_.bedrock, a), cell(plan_.bedrock, b), cell(steps, a),
                cell(steps, b), static_cast<Lane>(step), lanes);
  }

  /// Edges within the rows of a tile: cells (0, 1), (2, 3) ... or (1, 2), (3, 4) ...
  void across(const SlideTile& tile, int first) const {
    const int columns = plan_.layout.columns_of(tile.block);
    if ((columns - first) % 2 != 0) {  // the last cell's partner is the margin's first
      for (int y = tile.first_row; y < tile.end_row; ++y) {
        const std::size_t margin = plan_.layout.at(tile.block, columns, y);
        plan_.heights[margin] = plan_.heights[margin - 1];
      }
    }
    const int pairs = whole_vectors(columns - first) / 2;
    for (int y = tile.first_row; y < tile.end_row; ++y) across(plan_.layout.at(tile.block, first, y), pairs);
  }

  void across(std::size_t at, int pairs) const {
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
