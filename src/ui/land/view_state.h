// What the terrain is looked at with: look, camera, bookmarks. One for all runs that are compared.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "picture/camera.h"
#include "render/look.h"
#include "ui/land/terrain_camera.h"

namespace erg::ui {

/// The part of the window's state that only the eye cares about.
struct ViewState {
  render::Look look;
  TerrainCamera camera;
  bool legend = true;  ///< legend, wind arrow and north over the terrain
  /// A preset to take up as soon as the terrain's extent is known; "" when the camera is where it should be.
  std::string wanted_view = "block";
};

/// A view that menu, keys and LOOK offer.
struct OfferedView {
  const char* label;
  const char* preset;  ///< as TerrainCamera::choose takes it
  char key;
  const char* what;
};
inline constexpr OfferedView offered_views[] = {{"Top", "top", '1', "Straight from above, north up"},
                                                {"Oblique", "oblique", '2', "Over the terrain towards the horizon"},
                                                {"Block", "block", '3', "The whole of it, from the south"},
                                                {"Side", "side", '4', "From the south, low"},
                                                {"Frame", "frame", 'F', "All of it, from where you look now"}};

/// Cameras kept by name, as JSON files of a folder.
class Bookmarks {
 public:
  /// Reads what is there; an empty folder keeps nothing beyond the program's end.
  explicit Bookmarks(std::filesystem::path folder);

  /// One of them.
  struct Entry {
    std::string name;
    picture::Camera camera;
  };
  const std::vector<Entry>& entries() const { return entries_; }
  /// Adds or replaces; without a name it gets free_name(). Throws InputError when it cannot be written.
  void keep(const std::string& name, const picture::Camera& camera);
  bool has(const std::string& name) const;
  void remove(const std::string& name);
  /// "view 1", "view 2" ...: the first that is free.
  std::string free_name() const;
  /// The file of one, which `erg render --camera` takes; empty where nothing is kept.
  std::filesystem::path path_of(const std::string& name) const;

 private:
  /// As a file may be called: without '/' and without spaces around.
  static std::string plain(std::string name);

  std::filesystem::path folder_;
  std::vector<Entry> entries_;
};

}  // namespace erg::ui
