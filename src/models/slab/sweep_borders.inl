// Part of sweep_kernels.inl: the borders between blocks of columns. Each block keeps its outermost columns aside,
// packed together; the border is slid on such copies, and each thread writes the columns of its own blocks. Were one
// thread to write both sides in their places, it would take a cache line a row from the other, which would take it
// back.

/// Outermost columns that a border may change, on each side: where rows are skewed against each other a diagonal edge
/// reaches two columns deep.
template <typename Lane>
int border_depth(const SlidePlan<Lane>& plan) {
  return plan.diagonals && plan.layout.skew != 0 ? 2 : 1;
}

/// Copies a block's outermost columns to where they are kept.
template <typename Lane>
void keep_edges(const SlidePlan<Lane>& plan, int block) {
  const PlaneLayout& layout = plan.layout;
  const std::size_t last = static_cast<std::size_t>(layout.columns_of(block) - 1);
  const int depth = border_depth(plan);
  Lane* const edges[4] = {plan.edge_column(block, 0), plan.edge_column(block, 1), plan.edge_column(block, 2),
                          plan.edge_column(block, 3)};
  for (int y = 0; y < layout.length; ++y) {
    const Lane* row = plan.heights + layout.at(block, 0, y);
    edges[0][y] = row[0];
    edges[3][y] = row[last];
    if (depth == 1) continue;
    edges[1][y] = row[1];
    edges[2][y] = row[last - 1];
  }
}

/// Copies the first places of some of a block's rows to where they are kept for the strip before the block.
template <typename Lane>
void keep_ghosts(const SlidePlan<Lane>& plan, int block, int first_row, int end_row) {
  const PlaneLayout layout = plan.layout;
  Lane* kept = plan.ghosts + static_cast<std::size_t>(block) * static_cast<std::size_t>(layout.length) * ghost_places;
  const Lane* row = plan.heights + layout.at(block, 0, first_row);
  for (int y = first_row; y < end_row; ++y, row += layout.pitch) {
    // A block is wider than that, and its margin follows where the last one is not.
    std::memcpy(kept + ghost_places * y, row, ghost_places * sizeof(Lane));
  }
}

/// The border between two blocks.
template <typename Lane>
class ColumnSeam {
 public:
  ColumnSeam(const SlidePlan<Lane>& plan, int left, int right)
      : plan_(plan), left_(left), right_(right), depth_(border_depth(plan)) {}

  /// Each class of edges that cross the border, row after row. Where rows are skewed against each other those along the
  /// wind do so too.
  void slide(bool left_mine, bool right_mine) {
    const PlaneLayout layout = plan_.layout;
    for (int column = 2 - depth_; column < 2 + depth_; ++column) fetch(column);
    edges({left_outer, 0}, {right_outer, 0}, layout.length);
    const int rows = plan_.open ? layout.length - 1 : layout.length;
    for (int y = 0; y < rows && layout.skew != 0; ++y) {
      if (skew_step(layout, y) != 0) edge({right_outer, y}, {left_outer, y + 1});
    }
    if (plan_.diagonals && layout.length > 1) {
      // On skewed planes those over the torus edge come later (Slider::corners).
      const int own_rows = layout.skew == 0 ? rows : layout.length - 1;
      for (const bool rising : {true, false}) {
        for (int y = 0; y < own_rows; ++y) diagonals(y, rising);
      }
    }
    for (int k = 0; k < depth_; ++k) {
      if (left_mine) put_back(left_outer - k);
      if (right_mine) put_back(right_outer + k);
    }
  }

 private:
  enum Column : int { left_inner, left_outer, right_outer, right_inner };
  enum Layer : int { heights, bedrock, steps, diagonal_steps };
  struct Cell {
    int column;
    int row;
  };

  Lane* at(Layer layer, Cell cell) const {
    const int column = 4 * layer + cell.column;
    return plan_.border + static_cast<std::size_t>(column) * static_cast<std::size_t>(plan_.layout.length) + cell.row;
  }

  /// The same of a layer that may not be there: null.
  Lane* of(const Lane* plane, Layer layer, Cell cell) const { return plane ? at(layer, cell) : nullptr; }

  /// The cell of a column in row 0 of the planes.
  std::size_t foot(int column) const {
    const PlaneLayout& layout = plan_.layout;
    if (column >= right_outer) return layout.at(right_, column - right_outer, 0);
    return layout.at(left_, layout.columns_of(left_) - 1 - (left_outer - column), 0);
  }

  void fetch(int column) const {
    const Lane* kept =
        column >= right_outer ? plan_.edge_column(right_, column - right_outer) : plan_.edge_column(left_, column + 2);
    std::memcpy(at(heights, {column, 0}), kept, static_cast<std::size_t>(plan_.layout.length) * sizeof(Lane));
    fetch_layer(bedrock, plan_.bedrock, column);
    fetch_layer(steps, plan_.steps, column);
    if (plan_.diagonals) fetch_layer(diagonal_steps, plan_.diagonal_steps, column);
  }

  void fetch_layer(Layer layer, const Lane* plane, int column) const {
    if (plane == nullptr) return;
    Lane* to = at(layer, {column, 0});
    const Lane* from = plane + foot(column);
    for (int y = 0; y < plan_.layout.length; ++y, from += plan_.layout.pitch) to[y] = *from;
  }

  void put_back(int column) const {
    const Lane* from = at(heights, {column, 0});
    Lane* to = plan_.heights + foot(column);
    for (int y = 0; y < plan_.layout.length; ++y, to += plan_.layout.pitch) *to = from[y];
  }

  /// The diagonal edges above row y.
  void diagonals(int y, bool rising) const {
    const int above = y + 1 < plan_.layout.length ? y + 1 : 0;
    if (skew_step(plan_.layout, y) == 0) {
      const Cell lower{rising ? left_outer : right_outer, y};
      diagonal_edge(lower, {rising ? right_outer : left_outer, above});
    } else if (!rising) {
      diagonal_edge({right_outer, y}, {left_inner, above});
      diagonal_edge({right_inner, y}, {left_outer, above});
    }
  }

  /// Edges from a cell and those above it to another and those above that.
  void edges(Cell a, Cell b, int rows) const {
    slide_edges<Lane>(at(heights, a), at(heights, b), of(plan_.bedrock, bedrock, a), of(plan_.bedrock, bedrock, b),
                      of(plan_.steps, steps, a), of(plan_.steps, steps, b), static_cast<Lane>(plan_.step), rows);
  }

  void edge(Cell a, Cell b) const {
    slide_here<Lane>(at(heights, a), at(heights, b), of(plan_.bedrock, bedrock, a), of(plan_.bedrock, bedrock, b),
                     of(plan_.steps, steps, a), of(plan_.steps, steps, b), static_cast<Lane>(plan_.step), 1);
  }

  void diagonal_edge(Cell a, Cell b) const {
    const Lane* plane = plan_.diagonal_steps;
    slide_here<Lane>(at(heights, a), at(heights, b), of(plan_.bedrock, bedrock, a), of(plan_.bedrock, bedrock, b),
                     of(plane, diagonal_steps, a), of(plane, diagonal_steps, b), static_cast<Lane>(plan_.diagonal_step),
                     1);
  }

  // A copy: what is written through a pointer to bytes might be a part of anything else, and be read again each time.
  const SlidePlan<Lane> plan_;
  const int left_;
  const int right_;
  const int depth_;
};
