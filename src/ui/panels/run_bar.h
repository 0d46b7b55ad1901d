// Play, pause, step, run so many steps, speed; and the line at the foot that says how things stand.
#pragma once

#include <string>

#include "session/app_model.h"

namespace erg::ui {

/// The run bar: one row of controls in the current ImGui window.
class RunBar {
 public:
  /// Draws it; what is pressed goes to the app's runner.
  void draw(session::AppModel& app);

 private:
  void draw_buttons(session::AppModel& app);
  void draw_steps(session::AppModel& app);
  void draw_progress(const session::Snapshot& now) const;
  void draw_speed(session::AppModel& app) const;

  std::int64_t steps_to_run_ = 200;
};

/// Play when still, pause when running: what the space key does too.
void play_or_pause(session::Runner& runner, const session::Snapshot& now);
/// Why no step can be made now; "" when one can.
std::string why_no_step(const session::Snapshot& now);

/// The status line in the current ImGui window. True when its log entry was pressed.
bool draw_status(session::AppModel& app, float frames_per_second, const std::vector<std::string>& notes);

}  // namespace erg::ui
