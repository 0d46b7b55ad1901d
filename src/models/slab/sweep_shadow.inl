// Part of sweep_kernels.inl: where a strip's lines lie in the shadow of what stands upwind.

/// The shadow lines of a strip: from the highest crest upwind each falls row by row until the ground rises above it.
template <typename Lane>
class ShadowLine {
 public:
  ShadowLine(const SweepPlan<Lane>& plan, Strip<Lane>& strip)
      : strip_(strip),
        oblique_(plan.oblique),
        row_fall_(static_cast<Shadow>(plan.row_fall)),
        next_fall_(whole_slabs(plan.next_fall)),
        second_fall_(whole_slabs(plan.second_fall)) {}

  /// Which lanes of a row lie in shadow, and the shadow lines for the next row.
  void cast(Row<Lane>& row, int lanes) {
    if (oblique_) {
      cast_obliquely(row, lanes);
      return;
    }
    const Lane* __restrict height = row.height;
    Lane* __restrict shaded = row.shaded;
    Shadow* __restrict line = strip_.line;
    const Shadow fall = row_fall_;
    ERG_EACH(i, lanes) {
      const Shadow top = static_cast<Shadow>(height[i] << kernels::fixed_point_bits);
      shaded[i] = top < line[i] ? all_ones : Lane{0};
      const Shadow higher = top > line[i] ? top : line[i];
      line[i] = static_cast<Shadow>((higher > fall ? higher : fall) - fall);
    }
  }

 private:
  using Shadow = typename Strip<Lane>::Shadow;
  static constexpr Lane all_ones = static_cast<Lane>(~Lane{0});

  /// The same with falls of their own from the next row upwind and from the second.
  void cast_obliquely(Row<Lane>& row, int lanes) {
    const Lane* __restrict height = row.height;
    Lane* __restrict shaded = row.shaded;
    Shadow* __restrict line = strip_.line;                   // of what stands two rows upwind and farther
    Lane* __restrict second = strip_.upwind[strip_.second];  // this row will take its place
    strip_.second = 1 - strip_.second;
    const Lane* __restrict next = strip_.upwind[strip_.second];
    const Shadow fall = row_fall_;
    const Lane next_clear = next_fall_;
    const Lane second_clear = second_fall_;
    ERG_EACH(i, lanes) {
      const Lane below_next = static_cast<Lane>((next[i] > next_clear ? next[i] : next_clear) - next_clear);
      const Lane below_second = static_cast<Lane>((second[i] > second_clear ? second[i] : second_clear) - second_clear);
      const Lane shaded_below = below_next > below_second ? below_next : below_second;
      const Shadow top = static_cast<Shadow>(height[i] << kernels::fixed_point_bits);
      shaded[i] =
          static_cast<Lane>((top < line[i] ? all_ones : Lane{0}) | (height[i] < shaded_below ? all_ones : Lane{0}));
      const Shadow next_top = static_cast<Shadow>(next[i] << kernels::fixed_point_bits);
      const Shadow next_line = static_cast<Shadow>((next_top > fall ? next_top : fall) - fall);
      const Shadow higher = next_line > line[i] ? next_line : line[i];
      line[i] = static_cast<Shadow>((higher > fall ? higher : fall) - fall);
      second[i] = height[i];
    }
  }

  /// A fall of the shadow line (1/256 slabs) in whole slabs: heights are whole too.
  static Lane whole_slabs(std::uint32_t fall) {
    const std::uint32_t slabs = fall >> kernels::fixed_point_bits;
    return slabs < all_ones ? static_cast<Lane>(slabs) : all_ones;
  }

  Strip<Lane>& strip_;
  const bool oblique_;
  const Shadow row_fall_;
  const Lane next_fall_;
  const Lane second_fall_;
};
