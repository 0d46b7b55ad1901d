// The table of what menus and keys do.
#include <algorithm>

#include "ui/land/look_panel.h"
#include "ui/panels/panels.h"
#include "ui/window/picture_panel.h"
#include "ui/window/shell.h"

namespace erg::ui {

using session::Settings;

namespace {

constexpr int f(int number) { return keys::function + number; }

}  // namespace

void Shell::make_actions() {
  make_file_actions();
  make_view_actions();
  make_run_actions();
  const auto shows = [this](const char* title) { return [this, title] { open(title); }; };
  actions_.push_back({"Help", "Keys and mouse", f(1), false, shows(panel_title::keys)});
  actions_.push_back({"Help", "Log", f(3), false, shows(panel_title::log)});
  actions_.push_back({"Help", "About Erg", 0, false, shows(panel_title::about)});
}

void Shell::make_file_actions() {
  const auto shows = [this](const char* title) { return [this, title] { open(title); }; };
  const auto nothing = [this] { return why_nothing_to_save(); };
  const auto save = [this] {
    if (!app_.has_own_file()) {
      open(panel_title::save);
    } else if (!app_.save_config(app_.file())) {
      open(panel_title::log);
    }
  };
  actions_.push_back({"File", "Gallery", 'G', false, shows(panel_title::gallery)});
  actions_.push_back({"File", "Open\u2026", 'O', true, shows(panel_title::open)});
  actions_.push_back({"File", "Save", 'S', true, save});
  actions_.push_back({"File", "Save as\u2026", 0, false, shows(panel_title::save)});
  actions_.push_back({.menu = "File",
                      .label = "Export\u2026",
                      .key = 'E',
                      .ctrl = true,
                      .act = shows(panel_title::export_files),
                      .unavailable = nothing,
                      .line_above = true});
  actions_.push_back(
      {.menu = "File", .label = "Picture\u2026", .key = f(12), .act = shows(picture_title), .unavailable = nothing});
  actions_.push_back(
      {.menu = "File", .label = "Quit", .key = 'Q', .ctrl = true, .act = [this] { quit(); }, .line_above = true});
  actions_.push_back(
      {.menu = "Edit",
       .label = "Undo",
       .key = 'Z',
       .ctrl = true,
       .act = [this] { app_.runner().undo(); },
       .unavailable = [this] { return app_.now().undo_count > 0 ? "" : "No stroke or reset to take back."; }});
  actions_.push_back({.menu = "Edit",
                      .label = "Redo",
                      .key = 'Y',
                      .ctrl = true,
                      .act = [this] { app_.runner().redo(); },
                      .unavailable = [this] { return app_.now().redo_count > 0 ? "" : "Nothing was taken back."; }});
}

void Shell::make_view_actions() {
  const auto nothing = [this] { return why_nothing_to_save(); };
  for (const OfferedView& view : offered_views) {
    const auto take_up = [this, preset = view.preset] { view_state_.wanted_view = preset; };
    actions_.push_back({.menu = "View", .label = view.label, .key = view.key, .act = take_up, .unavailable = nothing});
  }
  actions_.push_back({.menu = "View",
                      .label = "Compare\u2026",
                      .key = f(4),
                      .act = [this] { open(panel_title::compare); },
                      .line_above = true});
  actions_.push_back({.menu = "View",
                      .label = "Panels",
                      .key = f(2),
                      .act = [this] { columns_shown_ = !columns_shown_; },
                      .checked = [this] { return columns_shown_; }});
  actions_.push_back({.menu = "View",
                      .label = "Dark",
                      .act = [this] { app_.settings().dark = !app_.settings().dark; },
                      .checked = [this] { return app_.settings().dark; }});
  const auto scale_by = [this](double change) {
    return [this, change] {
      const double scale = std::clamp(gui_.scale() + change, Settings::smallest_scale, Settings::largest_scale);
      app_.settings().scale = scale;
    };
  };
  actions_.push_back({.menu = "View", .label = "Larger text", .key = '+', .act = scale_by(0.25)});
  actions_.push_back({.menu = "View", .label = "Smaller text", .key = '-', .act = scale_by(-0.25)});
  actions_.push_back(
      {.menu = "View", .label = "Letters to suit the screen", .act = [this] { app_.settings().scale = 0; }});
}

void Shell::make_run_actions() {
  const auto stuck = [this] { return why_no_step(app_.now()); };
  actions_.push_back({.menu = "Run",
                      .label = "Play or pause",
                      .key = keys::space,
                      .act = [this] { play_or_pause(app_.runner(), app_.now()); },
                      .unavailable = stuck});
  actions_.push_back({.menu = "Run",
                      .label = "One step",
                      .key = '.',
                      .act = [this] { app_.runner().step(); },
                      .unavailable =
                          [this, stuck] {
                            return app_.now().activity == session::Activity::running ? "It is running: pause first."
                                                                                     : stuck();
                          }});
  actions_.push_back({.menu = "Run",
                      .label = "Reset",
                      .key = 'R',
                      .act = [this] { app_.runner().reset(); },
                      .unavailable = [this] { return why_nothing_to_save(); }});
  actions_.push_back({.menu = "Run",
                      .label = "Create",
                      .key = 'N',
                      .ctrl = true,
                      .act = [this] { leave("CREATE", session::Leaves::terrain, [this] { app_.create(); }); },
                      .line_above = true});
}

}  // namespace erg::ui
