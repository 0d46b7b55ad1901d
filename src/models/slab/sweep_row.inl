// Part of sweep_kernels.inl: the scratch of one row of a strip's lanes, and their random numbers.

/// Scratch of one row of a strip. Masks are 0 or all ones.
template <typename Lane>
struct Row {
  alignas(64) Lane height[strip_lines];
  alignas(64) Lane bedrock[strip_lines];
  alignas(64) Lane shaded[strip_lines];
  alignas(64) Lane random[strip_lines];          // of the draw at hand
  alignas(64) Lane no_lift[strip_lines];         // mask: nothing lifts here
  alignas(64) Lane threshold[strip_lines];       // a slab stays if its random byte is below
  alignas(64) Lane always_deposit[strip_lines];  // mask: every slab stays
  alignas(64) Lane lifted[strip_lines];
  alignas(64) Lane landed[strip_lines];
  alignas(64) Lane leaving[strip_lines];
  alignas(64) std::uint8_t cover[strip_lines];
  alignas(64) Lane next_bedrock[strip_lines];
  alignas(64) Lane none[strip_lines];                        // always 0
  alignas(64) std::uint32_t landing_words[strip_lines / 4];  // of the first landing; further draws follow from them
  std::uint64_t word;                                        // of this row; keys its draws
};

/// One bit for each of 64 lanes: set where the lane holds more than `limit` (0 or 2). Lanes hold less than half of
/// what they can. Compilers do not find the instructions by which vectors of bytes give such bits.
template <int limit, typename Lane>
std::uint64_t lanes_above(const Lane* lanes) {
#if defined(__AVX512BW__)
  if constexpr (sizeof(Lane) == 1) {
    return _mm512_cmpgt_epi8_mask(_mm512_loadu_si512(lanes), _mm512_set1_epi8(limit));
  }
#elif defined(__AVX2__)
  if constexpr (sizeof(Lane) == 1) {
    const auto half = [&](int first) {
      const __m256i bytes = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(lanes + first));
      const __m256i above = _mm256_cmpgt_epi8(bytes, _mm256_set1_epi8(limit));
      return static_cast<std::uint32_t>(_mm256_movemask_epi8(above));
    };
    return half(0) | static_cast<std::uint64_t>(half(32)) << 32;
  }
#endif
  constexpr int lanes_per_word = 8 / static_cast<int>(sizeof(Lane));
  constexpr int lane_bits = 8 * static_cast<int>(sizeof(Lane));
  constexpr bool bytes = sizeof(Lane) == 1;
  constexpr std::uint64_t ones = bytes ? 0x0101010101010101u : 0x0001000100010001u;
  // An addition carries into a lane's top bit and no further.
  constexpr std::uint64_t wrap_pass = ones * ((std::uint64_t{1} << (lane_bits - 1)) - 1 - limit);
  // Multiplying gathers the top bits of a word's lanes in its uppermost bits, in order.
  constexpr std::uint64_t gather = bytes ? 0x0102040810204080u : 0x0001000200040008u;
  constexpr int gathered_at = bytes ? 56 : 48;
  constexpr std::uint64_t gathered = (1u << lanes_per_word) - 1;
  std::uint64_t mask = 0;
  for (int word_number = 0; word_number < 64 / lanes_per_word; ++word_number) {
    std::uint64_t word;
    __builtin_memcpy(&word, lanes + word_number * lanes_per_word, 8);
    const std::uint64_t top = ((word + wrap_pass) >> (lane_bits - 1)) & ones;
    mask |= ((top * gather) >> gathered_at & gathered) << (word_number * lanes_per_word);
  }
  return mask;
}

/// Random bytes of a strip's lanes, keyed by line.
template <typename Lane>
class LineDraws {
 public:
  LineDraws(int first_line, int lanes) : first_quad_(static_cast<std::uint32_t>(first_line) / 4), lanes_(lanes) {}

  /// Random bytes for all lanes, of a fresh draw.
  void fill(Lane* lanes, std::uint32_t key) const {
    const std::uint32_t first = first_quad_;
    Lane* __restrict out = lanes;
    ERG_EACH(q, lanes_ / 4) spread(quad_word(key, first + static_cast<std::uint32_t>(q)), out + 4 * q);
  }

  /// The same for the draws of the first landing, whose words are kept: further draws follow from them.
  void fill_landing(Row<Lane>& row) const {
    const std::uint32_t key = draw_key(row.word, Draw::first_landing);
    const std::uint32_t first = first_quad_;
    std::uint32_t* __restrict words = row.landing_words;
    ERG_EACH(q, lanes_ / 4) words[q] = quad_word(key, first + static_cast<std::uint32_t>(q));
    Lane* __restrict out = row.random;
    ERG_EACH(q, lanes_ / 4) spread(words[q], out + 4 * q);
  }

  template <Draw draw>
  void fill_next(Row<Lane>& row) const {
    const std::uint32_t* __restrict words = row.landing_words;
    Lane* __restrict out = row.random;
    ERG_EACH(q, lanes_ / 4) spread(next_word(words[q], draw), out + 4 * q);
  }

 private:
  /// Cuts a word into bytes, one for each of four lanes (little-endian).
  static void spread(std::uint32_t word, Lane* lanes) {
    if constexpr (sizeof(Lane) == 1) {
      __builtin_memcpy(lanes, &word, sizeof word);
    } else {
      for (int i = 0; i < 4; ++i) lanes[i] = static_cast<Lane>(word >> (8 * i) & 0xff);
    }
  }

  const std::uint32_t first_quad_;  // four lines share a word
  const int lanes_;
};
