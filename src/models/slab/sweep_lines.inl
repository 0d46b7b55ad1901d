// Part of sweep_kernels.inl: how a strip's lines are found in memory as they run down the wind.

/// Copies `count` lanes, in whole pieces of 64 bytes where there is room for the last one too, here and there. A
/// processor hands what was just written on to a load within one store, and a load across two has to wait.
template <typename T>
void copy_lanes(T* to, const T* from, int count, int room_here, int room_there) {
  using Piece [[gnu::vector_size(64), gnu::aligned(1), gnu::may_alias]] = std::uint8_t;
  constexpr int lanes = 64 / static_cast<int>(sizeof(T));
  const int rounded = (count + lanes - 1) / lanes * lanes;
  const int in_pieces = rounded <= room_here && rounded <= room_there ? rounded : count / lanes * lanes;
  for (int lane = 0; lane < in_pieces; lane += lanes) {
    *reinterpret_cast<Piece*>(to + lane) = *reinterpret_cast<const Piece*>(from + lane);
  }
  if (in_pieces < count) {
    std::memcpy(to + in_pieces, from + in_pieces, static_cast<std::size_t>(count - in_pieces) * sizeof(T));
  }
}

/// Follows the lines of a strip from row to row: in which columns they stand, and where those lie in a plane.
class LineWalk {
 public:
  LineWalk(const PlaneLayout& layout, std::int64_t drift, std::int64_t phase, int first_line, int lines)
      : layout_(layout), drift_(drift), phase_(phase), first_line_(first_line), lines_(lines) {}

  /// Stands in a row, which may lie before or beyond the grid.
  void start(std::int64_t row) {
    const std::int64_t offset = kernels::line_offset(row, drift_, phase_, layout_.length);
    rest_ = row * drift_ + phase_ - offset * layout_.length;
    const std::int64_t row_in_grid = row % layout_.length;
    y_ = static_cast<int>(row_in_grid < 0 ? row_in_grid + layout_.length : row_in_grid);
    column_ = layout_.wrapped(static_cast<int>((first_line_ + offset) % layout_.width));
    stepped_ = false;
    find_place();
    lead_ = row == y_ ? offset - skew_ : 0;
  }

  /// Goes on to the next row.
  void go_on() {
    rest_ += drift_;
    stepped_ = rest_ >= layout_.length;
    if (stepped_) {
      rest_ -= layout_.length;
      if (++column_ == layout_.width) column_ = 0;
    }
    if (++y_ == layout_.length) {
      y_ = 0;
      lead_ = 0;
      find_place();
      return;
    }
    if (!stepped_ && layout_.skew == 0) return;
    const int skew = layout_.shift(y_);
    const int moved = (stepped_ ? 1 : 0) - (skew - skew_);
    skew_ = skew;
    lead_ += moved;
    in_block_ += moved;
    if (in_block_ < 0 || in_block_ >= layout_.columns_of(block_)) find_place();
  }

  /// The row of the grid.
  int y() const { return y_; }

  /// Column of the first line.
  int column() const { return column_; }
  /// Places from line i's own, i, to the one where it stands: 0 to most_lead on skewed planes, until the lines leave
  /// the grid.
  int offset() const { return lead_; }
  /// Whether the lines have moved one column sideways at this row.
  bool stepped() const { return stepped_; }
  /// Calls visit(first lane, cell of a plane, lanes, room) for each run of the first lanes that lie side by side in a
  /// plane. There is room for more lanes than the run's where the block's margin follows it.
  template <typename Visit>
  void for_runs(int lanes_wanted, const Visit& visit) const {
    int block = block_;
    int column = in_block_;
    for (int lane = 0; lane < lanes_wanted; column = 0) {
      const int in_block = layout_.columns_of(block) - column;
      const int left = lanes_wanted - lane;
      const int lanes = in_block < left ? in_block : left;
      visit(lane, layout_.at(block, column, y_), lanes, lanes == in_block ? layout_.pitch - column : lanes);
      lane += lanes;
      block = block + 1 == layout_.blocks ? 0 : block + 1;
    }
  }

  template <typename T>
  void copy_in(T* lanes, const T* plane) const {
    copy_in(lanes, plane, lines_);
  }
  /// The same of the first lanes alone; others may be changed.
  template <typename T>
  void copy_in(T* lanes, const T* plane, int lanes_wanted) const {
    // What a run reads of a block's margin is overwritten by the next run.
    for_runs(lanes_wanted, [&](int lane, std::size_t cell, int count, int room) {
      copy_lanes(lanes + lane, plane + cell, count, lines_ - lane, room);
    });
  }

 private:
  void find_place() {
    skew_ = layout_.shift(y_);
    const int place = layout_.wrapped(column_ - skew_);
    block_ = layout_.block_of(place);
    in_block_ = place - block_ * layout_.block_columns;
  }

  PlaneLayout layout_;
  std::int64_t drift_;
  std::int64_t phase_;
  int first_line_;
  int lines_;
  std::int64_t rest_ = 0;  // (row * drift + phase) mod length
  int y_ = 0;
  int skew_ = 0;  // of row y
  int lead_ = 0;
  int column_ = 0;
  int block_ = 0;     // of the column's place
  int in_block_ = 0;  // where in that block
  bool stepped_ = false;
};
