// Part of sweep_kernels.inl: where a strip's lines lie in the shadow of what stands upwind.

/// The shadow lines of a strip: from the highest crest upwind each falls row by row until the ground rises above it.
template <typename Lane>
class ShadowLine {
 public:
  ShadowLine(const SweepPlan<Lane>& plan, Strip<Lane>& strip)
      : strip_(strip),
        row_fall_(static_cast<Shadow>(plan.row_fall)),
        adjacent_fall_(static_cast<Lane>(plan.adjacent_fall >> fixed_point_bits)),
        shades_beside_(adjacent_fall_ != plan.row_fall >> fixed_point_bits) {}

  /// Which lanes of a row lie in shadow, and the shadow lines for the next row.
  void cast(Row<Lane>& row, int lanes) {
    if (shades_beside_) {
      cast_both(row, lanes);
      return;
    }
    const Lane* __restrict height = row.height;
    Lane* __restrict dark = row.dark;
    Shadow* __restrict line = strip_.line;
    const Shadow fall = row_fall_;
    ERG_EACH(i, lanes) {
      const Shadow top = static_cast<Shadow>(height[i] << fixed_point_bits);
      dark[i] = top < line[i] ? all_ones : Lane{0};
      const Shadow higher = top > line[i] ? top : line[i];
      line[i] = static_cast<Shadow>((higher > fall ? higher : fall) - fall);
    }
  }

 private:
  using Shadow = typename Strip<Lane>::Shadow;
  static constexpr Lane all_ones = static_cast<Lane>(~Lane{0});

  /// The same with a second line, from each cell to the next row.
  void cast_both(Row<Lane>& row, int lanes) {
    const Lane* __restrict height = row.height;
    Lane* __restrict dark = row.dark;
    Shadow* __restrict line = strip_.line;
    const Shadow fall = row_fall_;
    Lane* __restrict upwind = strip_.upwind;
    const Lane clear = adjacent_fall_;
    ERG_EACH(i, lanes) {
      const Shadow top = static_cast<Shadow>(height[i] << fixed_point_bits);
      const Lane shaded_below = static_cast<Lane>((upwind[i] > clear ? upwind[i] : clear) - clear);
      dark[i] =
          static_cast<Lane>((top < line[i] ? all_ones : Lane{0}) | (height[i] < shaded_below ? all_ones : Lane{0}));
      const Shadow higher = top > line[i] ? top : line[i];
      line[i] = static_cast<Shadow>((higher > fall ? higher : fall) - fall);
      upwind[i] = height[i];
    }
  }

  Strip<Lane>& strip_;
  const Shadow row_fall_;     // 1/256 slabs, along the wind
  const Lane adjacent_fall_;  // whole slabs, to the next row, which an oblique wind meets nearer than a row's length
  // Heights are whole slabs, so that the shorter way matters only where the line falls less by a whole one.
  const bool shades_beside_;
};
