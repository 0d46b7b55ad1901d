#include "ui/window/desktop.h"

#include <stb/stb_image.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <deque>
#include <fstream>
#include <map>
#include <memory>
#include <stdexcept>

#include "io/formats/png.h"
#include "ui/land/terrain_panes.h"
#include "ui/panels/panels.h"
#include "ui/window/gui_renderer.h"
#include "ui/window/shell.h"
#include "ui/window/window.h"

namespace erg::ui {

using picture::RgbaImage;
using render::gl11;
using render::Look;
using session::Activity;
using session::Settings;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds counted{1};  // for frames a second

// Pictures a second, over the last second.
class FrameCounter {
 public:
  void count() { times_.push_back(Clock::now()); }
  float rate() {
    while (!times_.empty() && Clock::now() - times_.front() > counted) times_.pop_front();
    return static_cast<float>(times_.size());
  }

 private:
  std::deque<Clock::time_point> times_;
};

// The list of widgets in a file, whole at any moment. Its first line counts the frames drawn, so that a test can wait
// for those that follow its input.
class MapFile {
 public:
  explicit MapFile(std::filesystem::path path) : path_(std::move(path)) {}
  void write(const WidgetMap& widgets) {
    if (path_.empty()) return;
    const std::filesystem::path draft = path_.string() + ".new";
    std::ofstream(draft) << ++frames_ << "\n" << widgets.text();
    std::error_code ignored;
    std::filesystem::rename(draft, path_, ignored);
  }

 private:
  std::filesystem::path path_;
  std::uint64_t frames_ = 0;
};

std::optional<RgbaImage> read_image(const std::filesystem::path& path) {
  int width = 0;
  int height = 0;
  int channels = 0;
  unsigned char* const pixels = stbi_load(path.c_str(), &width, &height, &channels, 4);
  if (pixels == nullptr) return std::nullopt;
  RgbaImage image{width, height, {}};
  image.pixels.assign(pixels, pixels + 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  stbi_image_free(pixels);
  return image;
}

class Desktop final : public Host {
 public:
  explicit Desktop(const DesktopRequest& request);

  void run();

  const TerrainGround* ground(std::size_t run) override { return terrain_.ground(run); }
  ImTextureID picture(const std::filesystem::path& path) override;
  void save_picture(const PictureOrder& order) override;
  float frames_per_second() const override { return frame_rate_; }
  double suggested_scale() const override { return window_.suggested_scale(); }
  void close() override { window_.close(); }

 private:
  static WindowOptions options(const DesktopRequest& request, const Settings& settings);
  void draw(int width, int height, float seconds);
  bool busy();
  bool must_close();

  const std::function<bool()> asked_to_end_;
  session::AppModel app_;
  std::unique_ptr<StillPainter> stills_ = std::make_unique<StillPainter>();  // before the window, as it asks
  Gui gui_;  // before the window, whose input goes into it
  Window window_;
  GuiRenderer renderer_;
  TerrainPanes terrain_;
  Shell shell_;
  MapFile map_;
  FrameCounter frames_;
  float frame_rate_ = 0;
  std::map<std::filesystem::path, ImTextureID> pictures_;
  std::string title_;
  std::uint64_t shown_snapshot_ = 0;
  std::uint64_t shown_log_ = 0;
};

WindowOptions Desktop::options(const DesktopRequest& request, const Settings& settings) {
  WindowOptions options;
  options.width = request.width > 0 ? request.width : settings.window_width;
  options.height = request.height > 0 ? request.height : settings.window_height;
  return options;
}

Desktop::Desktop(const DesktopRequest& request)
    : asked_to_end_(request.asked_to_end),
      app_(request.folders),
      window_(options(request, app_.settings())),
      terrain_(window_.is_software(), stills_.get()),
      shell_(app_, *this, gui_),
      map_(request.widget_map) {
  if (!window_.is_software()) stills_.reset();  // a graphics card is quick enough by itself
  if (request.scale > 0) app_.settings().scale = request.scale;
  app_.log().information("drawing with " + window_.driver());
  if (const std::string why = app_.why_not_kept(); !why.empty()) {
    std::fprintf(stderr, "erg: %s\n", why.c_str());
    app_.log().warning(why);
  }
  if (!request.open.empty()) {
    if (!app_.open(request.open)) shell_.open(panel_title::log);
  } else {
    shell_.open(panel_title::gallery);
  }
  if (!app_.crashed_sessions().empty()) shell_.open(panel_title::recovery);
}

ImTextureID Desktop::picture(const std::filesystem::path& path) {
  const auto known = pictures_.find(path);
  if (known != pictures_.end()) return known->second;
  const std::optional<RgbaImage> image = read_image(path);
  const ImTextureID texture = image ? renderer_.add_texture(*image) : nullptr;
  pictures_[path] = texture;
  return texture;
}

void Desktop::save_picture(const PictureOrder& order) {
  const session::RunSnapshot* const run = app_.active_run();
  if (run == nullptr) throw InputError(order.path.string(), "there is no terrain to draw", "create one first");
  Look look = shell_.view_state().look;
  look.transparent = order.transparent;
  look.legend = shell_.view_state().legend;
  const render::Picture picture = terrain_.picture(*run, look, shell_.view_state().camera.camera(), order.size);
  io::write_run_png(order.path, picture.image, app_.provenance());
}

bool Desktop::busy() {
  const Activity activity = app_.now().activity;
  const bool moving = activity == Activity::running || activity == Activity::building;
  const bool view_to_come = app_.now().has_runs() && !shell_.view_state().wanted_view.empty();
  // A brush that is held goes on pouring; a slider that is held follows.
  return moving || view_to_come || ImGui::IsAnyMouseDown() || terrain_.unfinished() ||
         app_.runner().snapshot()->number != shown_snapshot_ || app_.log().version() != shown_log_;
}

bool Desktop::must_close() {
  if (!asked_to_end_ || !asked_to_end_()) return false;
  std::fprintf(stderr, "erg: asked to end: %s\n", app_.rescue().c_str());
  return true;
}

void Desktop::draw(int width, int height, float seconds) {
  app_.tick();
  shown_snapshot_ = app_.now().number;
  shown_log_ = app_.log().version();
  app_.settings().window_width = width;
  app_.settings().window_height = height;
  shell_.apply_settings();
  gui_.frame({static_cast<float>(width), static_cast<float>(height)}, seconds, [this] { shell_.draw(); });
  const ImVec4& ground = gui_.theme().ground;
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  gl11().ClearColor(ground.x, ground.y, ground.z, 1);
  gl11().Clear(GL_COLOR_BUFFER_BIT);
  TerrainWindow& terrain = shell_.terrain();
  Look look = shell_.view_state().look;
  look.legend = false;
  terrain.set_notes(terrain_.draw(app_.now(), look, shell_.view_state().camera.camera(), terrain.parts(), height,
                                  terrain.restless()));
  renderer_.draw(gui_, 0);
  frames_.count();
  frame_rate_ = frames_.rate();
  map_.write(gui_.widgets());
  const std::string title = app_.title() + (app_.unsaved() ? " * - Erg" : " - Erg");
  if (title != title_) window_.set_title(title);
  title_ = title;
}

void Desktop::run() {
  try {
    window_.run({.draw = [this](int width, int height, float seconds) { draw(width, height, seconds); },
                 .busy = [this] { return busy(); },
                 .close_wanted = [this] { shell_.quit(); },
                 .must_close = [this] { return must_close(); },
                 .display_lost = [this] { return "the display is gone: " + app_.rescue(); }});
  } catch (const std::exception& error) {
    // The window cannot go on, but what runs in it is whole.
    throw std::runtime_error(std::string(error.what()) + "; " + app_.rescue());
  }
}

}  // namespace

void run_desktop(const DesktopRequest& request) { Desktop(request).run(); }

}  // namespace erg::ui
