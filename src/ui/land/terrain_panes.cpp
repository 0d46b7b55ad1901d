#include "ui/land/terrain_panes.h"

#include <algorithm>

#include "core/material.h"
#include "models/model.h"
#include "render/gl.h"
#include "render/textures.h"

namespace erg::ui {

using picture::Camera;
using render::Look;
using render::Renderer;
using render::RenderQuality;
using render::TerrainBox;
using render::TerrainView;
using session::RunSnapshot;
using session::Snapshot;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds rest{350};  // without a change before the fine picture is drawn

// So many times as long as a drawing took, terrain that changes by itself is left as drawn.
constexpr int breathing_space = 3;

// At rest a picture may take a moment, but not so long that the window seems stuck.
RenderQuality quality_at_rest(bool software) {
  return software ? RenderQuality{512, 1024, 3, 128, true} : RenderQuality::still();
}

}  // namespace

TerrainView view_of_run(const RunSnapshot& run) {
  TerrainView view;
  view.terrain = run.terrain.get();
  if (run.shadow) view.fields.push_back(run.shadow.get());
  if (run.flux) view.fields.push_back(run.flux.get());
  view.wind = run.last_wind.mean_bearing();
  view.material = models::find_model(run.config->model).info.material;
  // Shadow and flux come and go without the terrain.
  view.version = 4 * run.terrain_version + (run.shadow ? 1 : 0) + (run.flux ? 2 : 0);
  return view;
}

// One run's picture, what it shows, and the ground that it shows.
struct TerrainPanes::Pane final : TerrainGround {
  Renderer renderer;
  render::PictureTarget target;
  WindowPart part;
  std::vector<std::string> notes;
  // What was drawn last.
  std::uint64_t version = 0;
  WindowPart drawn_part;
  Look look;
  Camera camera;
  bool fine = false;
  int scale = 1;  // drawn pixels for one of the window, each way
  Clock::time_point changed;
  Clock::time_point drawn;
  Clock::duration cost{};  // of that drawing
  /// What a picture depends on.
  struct Drawing {
    std::uint64_t version = 0;
    WindowPart part;
    Look look;
    Camera camera;
    bool operator==(const Drawing&) const = default;
  };
  Drawing drawing() const { return {version, drawn_part, look, camera}; }
  Drawing ordered;  // from the painter of still pictures
  // The terrain is held as long as the renderer may be asked about it.
  std::shared_ptr<const Terrain> terrain;
  TerrainBox bounds;

  TerrainBox box() const override { return bounds; }
  std::optional<Eigen::Vector3d> under(const Camera& from, render::PicturePoint point, double aspect) const override {
    return renderer.terrain_under(from, point, aspect);
  }
  double height(double east, double north) const override { return renderer.ground_height(east, north); }
};

TerrainPanes::TerrainPanes(bool software, StillPainter* stills)
    : software_(software), stills_(software && stills != nullptr && stills->works() ? stills : nullptr) {}
TerrainPanes::~TerrainPanes() = default;

/// At once, where something differs from what is shown.
void TerrainPanes::draw_pane(Pane& pane, const RunSnapshot& run, const Look& look, const Camera& camera,
                             bool restless) {
  const Clock::time_point now = Clock::now();
  const bool by_hand = !(pane.part == pane.drawn_part) || !(look == pane.look) || !(camera == pane.camera);
  const bool differs = by_hand || view_of_run(run).version != pane.version;
  if (differs || restless) pane.changed = now;
  if (!differs) return;
  // Terrain that changes by itself may be drawn seldom: where drawing is slow, the controls come first.
  if (!by_hand && now - pane.drawn < breathing_space * pane.cost) return;
  paint(pane, run, look, camera, false);
  pane.drawn = Clock::now();
  pane.cost = pane.drawn - now;
}

void TerrainPanes::paint(Pane& pane, const RunSnapshot& run, const Look& look, const Camera& camera, bool fine) {
  const TerrainView view = view_of_run(run);
  pane.fine = fine;
  pane.renderer.set_quality(fine ? quality_at_rest(software_) : RenderQuality::moving(software_));
  // Twice the pixels each way, averaged as they are copied into the window, make edges smooth.
  pane.scale = fine && !software_ ? 2 : 1;
  const int width = pane.scale * pane.part.width;
  const int height = pane.scale * pane.part.height;
  pane.target.prepare(width, height);
  pane.notes = pane.renderer.draw_into(pane.target.frame(), view, look, camera, width, height);
  if (view.version != pane.version || look.exaggeration != pane.look.exaggeration) {
    pane.bounds = Renderer::box_of(view, look);
  }
  pane.terrain = run.terrain;
  pane.version = view.version;
  pane.drawn_part = pane.part;
  pane.look = look;
  pane.camera = camera;
}

/// Nothing has changed for a while, in any of the runs: those that are compared are always drawn alike.
bool TerrainPanes::rested() const {
  const Clock::time_point now = Clock::now();
  return std::ranges::all_of(panes_, [now](const auto& pane) { return now - pane->changed >= rest; });
}

void TerrainPanes::refine(const Snapshot& snapshot, const Look& look, const Camera& camera) {
  if (!rested() || std::ranges::all_of(panes_, [](const auto& pane) { return pane->fine; })) return;
  if (stills_ == nullptr) {
    for (std::size_t i = 0; i < panes_.size(); ++i) paint(*panes_[i], snapshot.runs[i], look, camera, true);
    return;
  }
  if (auto pictures = stills_->take(); pictures && take_stills(std::move(*pictures))) return;
  if (!stills_->busy()) order_stills(snapshot, look, camera);
}

void TerrainPanes::order_stills(const Snapshot& snapshot, const Look& look, const Camera& camera) {
  StillOrder order{{}, look, camera, quality_at_rest(software_)};
  for (std::size_t i = 0; i < panes_.size(); ++i) {
    Pane& pane = *panes_[i];
    order.parts.push_back({snapshot.runs[i], pane.part.width, pane.part.height});
    pane.ordered = pane.drawing();
  }
  stills_->order(std::move(order));
}

/// Shows what was drawn meanwhile; false where that is not what should be seen any more.
bool TerrainPanes::take_stills(std::vector<StillPicture> pictures) {
  const bool as_ordered =
      std::ranges::all_of(panes_, [](const auto& pane) { return pane->ordered == pane->drawing(); });
  if (!as_ordered) return false;
  for (std::size_t i = 0; i < panes_.size(); ++i) {
    Pane& pane = *panes_[i];
    pane.fine = true;
    if (i >= pictures.size()) continue;  // it could not be drawn: what is there stays
    pane.target.prepare(pictures[i].width, pictures[i].height);
    pane.target.write(pictures[i].pixels);
    pane.notes = std::move(pictures[i].notes);
  }
  return true;
}

void TerrainPanes::show(const Pane& pane, int window_height) const {
  const WindowPart& part = pane.part;
  const int low = window_height - part.top - part.height;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, pane.target.frame());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  render::gl11().Disable(GL_SCISSOR_TEST);
  glBlitFramebuffer(0, 0, pane.scale * part.width, pane.scale * part.height, part.left, low, part.left + part.width,
                    low + part.height, GL_COLOR_BUFFER_BIT, pane.scale == 1 ? GL_NEAREST : GL_LINEAR);
}

std::vector<std::string> TerrainPanes::draw(const Snapshot& snapshot, const Look& look, const Camera& camera,
                                            const std::vector<WindowPart>& parts, int window_height, bool restless) {
  const std::size_t count = std::min(snapshot.runs.size(), parts.size());
  panes_.resize(std::min(panes_.size(), count));
  while (panes_.size() < count) panes_.push_back(std::make_unique<Pane>());
  std::vector<std::string> notes;
  for (std::size_t index = 0; index < count; ++index) {
    Pane& pane = *panes_[index];
    pane.part = parts[index];
    draw_pane(pane, snapshot.runs[index], look, camera, restless);
  }
  refine(snapshot, look, camera);
  for (const auto& pane : panes_) {
    show(*pane, window_height);
    notes.insert(notes.end(), pane->notes.begin(), pane->notes.end());
  }
  return notes;
}

bool TerrainPanes::unfinished() const {
  const bool all_fine = std::ranges::all_of(panes_, [](const auto& pane) { return pane->fine; });
  return !all_fine && rested() && (stills_ == nullptr || !stills_->busy());
}

const TerrainGround* TerrainPanes::ground(std::size_t run) const {
  return run < panes_.size() ? panes_[run].get() : nullptr;
}

render::Picture TerrainPanes::picture(const RunSnapshot& run, const Look& look, const Camera& camera,
                                      const render::PictureSize& size) {
  Renderer renderer;
  return renderer.draw(view_of_run(run), look, camera, size);
}

}  // namespace erg::ui
