// The window with everything in it: what `erg` and `erg gui` run.
#pragma once

#include <filesystem>
#include <functional>

#include "session/app_model.h"

namespace erg::ui {

/// How the window begins.
struct DesktopRequest {
  session::AppFolders folders;
  /// Config or checkpoint to open; none: the gallery.
  std::filesystem::path open;
  /// Letters and controls this many times their usual size; 0: as the settings say.
  double scale = 0;
  /// Pixels; 0: as it was last time.
  int width = 0;
  int height = 0;
  /// For tests: a file that counts the frames and lists where every widget lies, written with each frame. Empty: none.
  std::filesystem::path widget_map;
  /// Whether the system has asked the program to end: then the runs are saved for the next start, and the window closes
  /// without a question. Asked many times a second. Empty: it never does.
  std::function<bool()> asked_to_end;
};

/// Opens the window and comes back when it is closed. Throws InputError where there is no display or no OpenGL 3.3.
void run_desktop(const DesktopRequest& request);

}  // namespace erg::ui
