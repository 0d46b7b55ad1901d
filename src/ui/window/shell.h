// The whole interface: menus, columns of panels, the terrain between them, run bar, status line, dialogs. Draws with
// ImGui alone; what needs OpenGL or the screen it asks of a Host.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "ui/land/terrain_window.h"
#include "ui/land/view_state.h"
#include "ui/panels/panel.h"
#include "ui/panels/run_bar.h"
#include "ui/panels/unsaved_panel.h"
#include "ui/widgets/gui.h"
#include "ui/window/actions.h"

namespace erg::ui {

/// A picture that a person asked for.
struct PictureOrder {
  std::filesystem::path path;
  render::PictureSize size;
  bool transparent = false;
};

/// What the interface stands on.
class Host {
 public:
  virtual ~Host() = default;
  /// The ground of a run as it is on the screen; null before it was drawn.
  virtual const TerrainGround* ground(std::size_t run) = 0;
  /// A picture for ImGui::Image, loaded once; null when it cannot be read.
  virtual ImTextureID picture(const std::filesystem::path& path) = 0;
  /// Draws the active run and writes it. Throws InputError.
  virtual void save_picture(const PictureOrder& order) = 0;
  /// Pictures drawn in the last second.
  virtual float frames_per_second() const = 0;
  /// How many times its usual size an interface should be made on this screen.
  virtual double suggested_scale() const = 0;
  /// Ends the program after this frame.
  virtual void close() = 0;
};

/// The interface.
class Shell {
 public:
  /// All three must outlive it.
  Shell(session::AppModel& app, Host& host, Gui& gui);
  ~Shell();
  Shell(const Shell&) = delete;
  Shell& operator=(const Shell&) = delete;

  /// One frame, within Gui::frame.
  void draw();

  /// Takes over theme and scale from the settings. Between frames.
  void apply_settings();

  ViewState& view_state() { return view_state_; }
  const ViewState& view_state() const { return view_state_; }
  TerrainWindow& terrain() { return terrain_; }
  /// Opens, closes a dialog, or folds out a panel.
  void open(const std::string& title);
  void close(const std::string& title);
  bool is_open(const std::string& title) const;
  /// PanelContext::leave.
  void leave(const std::string& what, session::Leaves leaves, std::function<void()> act);
  /// Closes the window, after the question about work that would be lost.
  void quit();

 private:
  void make_actions();
  void make_file_actions();
  void make_view_actions();
  void make_run_actions();
  void close_menu_on_escape();
  void draw_menu_bar();
  void draw_column(Dock dock, const char* name, float left, float top, float width, float height);
  void draw_column_edge(const char* name, float left, float top, float height, float sign);
  void draw_panel_of_column(Panel& panel);
  void draw_foot(float top, float height);
  void draw_dialogs();
  float layout(const std::string& name, float standard) const;
  void set_layout(const std::string& name, float value);
  std::string why_nothing_to_save() const;

  session::AppModel& app_;
  Host& host_;
  Gui& gui_;
  ViewState view_state_;
  Bookmarks bookmarks_;
  TerrainWindow terrain_;
  RunBar run_bar_;
  PanelContext context_;
  std::vector<std::unique_ptr<Panel>> panels_;
  std::vector<std::string> open_dialogs_;
  std::string to_front_;
  std::optional<Parting> parting_;
  std::vector<MenuAction> actions_;
  bool columns_shown_ = true;
  // In the last frame:
  bool dialog_has_keys_ = false;
  bool popup_was_open_ = false;
};

}  // namespace erg::ui
