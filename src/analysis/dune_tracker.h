// Follows each dune through time: which dune of a later look is which of an earlier one, and how far it has moved.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/dune_outlines.h"

namespace erg::analysis {

/// A dune's way, m.
struct DuneWay {
  double east = 0;
  double north = 0;
};

/// Which dune of `earlier` each of `later` is; nothing for one that is new, has merged or has split. Two dunes are one
/// where each is the other's nearest, their middles are less than half the earlier one's length or width apart
/// (whichever is longer), and neither has more than 1.1 times the sand of the other: one that joins or loses a piece is
/// another. `terrain` says how far the torus reaches, if it is one. So between two looks dunes should move less than
/// half their length.
std::vector<std::optional<std::size_t>> match_dunes(const std::vector<Dune>& earlier, const std::vector<Dune>& later,
                                                    const Terrain& terrain);

/// The shortest way from one dune's middle to another's, around the torus where there is one.
DuneWay way_between(const Dune& from, const Dune& to, const Terrain& terrain);

/// Numbers dunes and follows them from look to look.
class DuneTracker {
 public:
  /// What is known of one dune of the last look.
  struct Track {
    std::int64_t number = 0;  ///< stays with the dune; counts from 1 as dunes come into sight
    std::int64_t since = 0;   ///< step of the look from which `way` counts
    DuneWay way;              ///< since then
  };

  /// Takes note of the dunes of `terrain` after `step` steps; steps must grow.
  void observe(std::int64_t step, std::vector<Dune> dunes, const Terrain& terrain);
  /// Counts ways anew from the last look; dunes keep their numbers.
  void start_ways();

  /// The dunes of the last look.
  const std::vector<Dune>& dunes() const { return dunes_; }
  /// Of each of them, in the same order.
  const std::vector<Track>& tracks() const { return tracks_; }
  /// Step of the last look.
  std::int64_t step() const { return step_; }

 private:
  std::vector<Dune> dunes_;
  std::vector<Track> tracks_;
  std::int64_t step_ = 0;
  std::int64_t last_number_ = 0;
};

}  // namespace erg::analysis
