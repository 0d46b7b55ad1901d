// What of the person's work stands in a file, and what would be lost if it were left now.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "session/comparison.h"
#include "session/snapshot.h"

namespace erg::session {

/// Something that stands in no file.
struct UnsavedItem {
  std::size_t run = 0;
  /// The terrain itself, which a checkpoint keeps (its setup with it); false: the setup only, which a config keeps.
  bool terrain = false;
  std::string what;  ///< a sentence: "The setup of \"Barchan field\" was changed and is in no file."
};

/// What a command would leave behind.
enum class Leaves {
  terrain,    ///< CREATE: the terrains go, the setups stay
  everything  ///< quitting, opening another file
};

/// Dunes that grew by themselves can be grown again from their setup, to the bit. So a terrain counts as work when it
/// was painted on, when it was recovered after a crash, or when growing it again would take long.
class UnsavedWork {
 public:
  /// Steps that took this long together, in seconds, are worth a question.
  static constexpr double long_work = 300;

  /// Begins with a setup that stands in this file ("": as the program itself makes it), and no other in any.
  void start_from(const std::filesystem::path& file, sim::Config config);
  void setup_saved(const std::filesystem::path& file, sim::Config config);
  /// The terrain of one run as this snapshot shows it stands in a checkpoint.
  void terrain_saved(const Snapshot& snapshot, std::size_t run);
  /// The runs of this snapshot come from a crash's session, which goes when the program ends in order.
  void recovered(const Snapshot& snapshot);

  /// Whether a file has this setup.
  bool has(const sim::Config& config) const;
  /// The first thing that would be lost; terrains come first, for a checkpoint keeps the setup too.
  std::optional<UnsavedItem> missing(const Comparison& comparison, const Snapshot& snapshot, Leaves leaves) const;

 private:
  struct TerrainWork {
    std::size_t run = 0;
    std::uint64_t last_stroke = 0;
    double seconds_worked = 0;
  };
  const TerrainWork* kept_terrain(const Snapshot& snapshot, std::size_t run) const;
  std::string why_terrain_is_work(const Snapshot& snapshot, std::size_t run) const;
  std::optional<UnsavedItem> missing_terrain(const Snapshot& snapshot) const;

  std::map<std::filesystem::path, sim::Config> files_;
  std::uint64_t creation_ = 0;  ///< the runs that `lands_` speaks of
  std::vector<TerrainWork> terrains_;
  std::uint64_t recovered_creation_ = 0;
};

}  // namespace erg::session
