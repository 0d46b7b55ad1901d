// What the program remembers of its window from one day to the next.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace erg::session {

/// Kept as settings.json in settings_folder().
struct Settings {
  static constexpr std::size_t most_recent = 12;
  static constexpr double smallest_scale = 0.5;
  static constexpr double largest_scale = 4;

  bool dark = true;
  double scale = 0;      ///< of the interface; 0: chosen from the window's size
  int window_width = 0;  ///< pixels; 0: as suits the screen
  int window_height = 0;
  std::map<std::string, double> layout;  ///< sizes of panels and what is folded, by names of the window's own
  std::string last_folder;
  std::vector<std::string> recent;  ///< absolute paths, latest first
  double autosave_minutes = 3;      ///< 0: never

  /// Puts a path at the head of the recent files.
  void add_recent(const std::filesystem::path& path);

  bool operator==(const Settings&) const = default;
};

/// $XDG_CONFIG_HOME/erg, else ~/.config/erg; empty when neither variable is set.
std::filesystem::path settings_folder();
/// $XDG_STATE_HOME/erg, else ~/.local/state/erg: autosaved sessions.
std::filesystem::path state_folder();

/// Reads settings; what is missing or makes no sense has its default: settings never keep the program from starting.
/// `complaint` gets what was wrong with the file.
Settings read_settings(const std::filesystem::path& folder, std::string& complaint);
/// Writes them, making the folder. Throws InputError when it cannot.
void write_settings(const std::filesystem::path& folder, const Settings& settings);

}  // namespace erg::session
