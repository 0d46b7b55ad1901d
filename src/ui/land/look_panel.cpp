#include "ui/land/look_panel.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "forcing/bearing.h"
#include "picture/palette.h"
#include "ui/land/terrain_panes.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {

using picture::find_palette;
using picture::palette_names;
using render::Look;
using session::Log;
using session::Snapshot;

namespace {

constexpr float dial_side = 92;  // pixels at scale 1
constexpr double lowest_sun = 1;
constexpr double most_exaggeration = 10;
constexpr int to_the_horizon = 6;  // rings of copies
constexpr const char* own_palette = "own";

// A strip of a palette's colours.
void draw_palette(const picture::Palette& palette, ImVec2 low, ImVec2 high) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  constexpr int parts = 24;
  const auto colour = [&](int part) {
    const picture::Colour at = palette.at(static_cast<double>(part) / parts);
    return ImGui::GetColorU32(ImVec4(at.red, at.green, at.blue, 1));
  };
  for (int part = 0; part < parts; ++part) {
    const float left = low.x + (high.x - low.x) * static_cast<float>(part) / parts;
    const float right = low.x + (high.x - low.x) * static_cast<float>(part + 1) / parts;
    list.AddRectFilledMultiColor({left, low.y}, {right, high.y}, colour(part), colour(part + 1), colour(part + 1),
                                 colour(part));
  }
}

// The sky from above, north up: the sun's bearing is its direction, its altitude 90 degrees in the middle and 0 at the
// rim. True when it was moved.
bool sun_dial(Look& look, float side) {
  const Theme& theme = Gui::current().theme();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float radius = 0.5f * side;
  const ImVec2 middle{corner.x + radius, corner.y + radius};
  ImGui::InvisibleButton("sun", {side, side});
  mark("sun dial");
  const bool held = ImGui::IsItemActive();
  if (held) {
    const double east = ImGui::GetIO().MousePos.x - middle.x;
    const double north = middle.y - ImGui::GetIO().MousePos.y;
    const double away = std::min(std::hypot(east, north) / (0.9 * radius), 1.0);
    // Where something blows toward (x, y) it comes from the other side, and the sun stands there.
    if (away > 0.02) look.sun_bearing = forcing::bearing_of({-east, -north});
    look.sun_altitude = std::max(lowest_sun, 90 * (1 - away));
  }
  tooltip("Where the sun stands, seen from above: drag it. Near the rim it is low and shadows are long.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(middle, 0.9f * radius, ImGui::GetColorU32(theme.field), 48);
  list.AddCircle(middle, 0.9f * radius, ImGui::GetColorU32(theme.edge), 48);
  list.AddCircle(middle, 0.45f * radius, ImGui::GetColorU32(theme.edge), 32);
  const float letter = ImGui::GetFontSize();
  list.AddText({middle.x - 0.35f * letter, corner.y + 0.12f * radius}, ImGui::GetColorU32(theme.faint), "N");
  const double turn = radians(look.sun_bearing);
  const double away = 0.9 * radius * (1 - look.sun_altitude / 90);
  const ImVec2 sun{middle.x + static_cast<float>(away * std::sin(turn)),
                   middle.y - static_cast<float>(away * std::cos(turn))};
  list.AddLine(sun, middle, ImGui::GetColorU32(theme.edge), Gui::current().px(1.5f));
  list.AddCircleFilled(sun, Gui::current().px(held ? 8.0f : 6.5f), ImGui::GetColorU32(theme.accent), 20);
  return held;
}

class LookPanel final : public Panel {
 public:
  LookPanel(ViewState& view_state, Bookmarks& bookmarks) : view_state_(view_state), bookmarks_(bookmarks) {}

  const char* title() const override { return look_title; }
  Dock dock() const override { return Dock::right; }
  void draw(PanelContext& context) override;

 private:
  void draw_what(PanelContext& context);
  void draw_palettes();
  void draw_sun();
  void draw_camera();
  void draw_bookmarks(PanelContext& context);
  void keep_view(Log& log);
  void draw_extras(const PanelContext& context);

  ViewState& view_state_;
  Bookmarks& bookmarks_;
  std::string view_name_;
};

void LookPanel::draw(PanelContext& context) {
  draw_what(context);
  if (!view_state_.look.is_material()) draw_palettes();
  Look& look = view_state_.look;
  double contours = look.contours;
  constexpr double most_contours = 100;
  if (real_row({.label = "contours",
                .unit = look.is_material() ? "m" : "",
                .tooltip = "Interval of contour lines, in metres for materials, else in the unit of what is shown. "
                           "0: none.",
                .changed = contours != 0},
               contours, 0, most_contours) != RowEvent::none) {
    look.contours = contours == look.contours ? 0 : contours;
  }
  draw_sun();
  draw_camera();
  draw_bookmarks(context);
  draw_extras(context);
}

void LookPanel::draw_what(PanelContext& context) {
  const std::vector<LookChoice> choices = look_choices(context.app.now(), context.app.shown());
  const auto shown =
      std::find_if(choices.begin(), choices.end(), [&](const LookChoice& c) { return c.key == view_state_.look.show; });
  if (shown == choices.end()) view_state_.look.show = "material";  // a field that this model does not have
  std::vector<std::string> labels;
  for (const LookChoice& choice : choices) labels.push_back(choice.label);
  std::string label = shown == choices.end() ? choices.front().label : shown->label;
  if (choice_row({.label = "show", .tooltip = "What the terrain is coloured by"}, label, labels) == RowEvent::changed) {
    const auto chosen = std::find(labels.begin(), labels.end(), label) - labels.begin();
    view_state_.look.show = choices[static_cast<std::size_t>(chosen)].key;
  }
  context.app.runner().watch_shadow(view_state_.look.show == "shadow");
  context.app.runner().watch_flux(view_state_.look.show == "flux");
}

void LookPanel::draw_palettes() {
  Look& look = view_state_.look;
  std::vector<std::string> names{own_palette};
  names.insert(names.end(), palette_names().begin(), palette_names().end());
  std::string name = look.palette.empty() ? own_palette : look.palette;
  const RowEvent event = choice_row(
      {.label = "palette",
       .tooltip = look.palette.empty() ? "The colours that suit what is shown" : find_palette(look.palette).meaning,
       .changed = !look.palette.empty()},
      name, names);
  if (event != RowEvent::none) look.palette = event == RowEvent::reset || name == own_palette ? "" : name;
  if (!look.palette.empty()) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float high = Gui::current().px(8);
    const float wide = ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({wide, high});
    draw_palette(find_palette(look.palette), low, {low.x + wide, low.y + high});
  }
  switch_row({.label = "shaded", .tooltip = "Values are shaded by sun and sky, so that the relief shows"},
             look.shading);
}

void LookPanel::draw_sun() {
  Look& look = view_state_.look;
  const Look standard;
  sun_dial(look, Gui::current().px(dial_side));
  ImGui::SameLine();
  ImGui::BeginGroup();
  constexpr double round = 360;
  if (real_row({.label = "sun from",
                .unit = "\u00b0",
                .tooltip = "Bearing of the sun, degrees clockwise from north",
                .changed = look.sun_bearing != standard.sun_bearing},
               look.sun_bearing, 0, round) == RowEvent::reset) {
    look.sun_bearing = standard.sun_bearing;
  }
  if (real_row({.label = "altitude",
                .unit = "\u00b0",
                .tooltip = "Degrees of the sun above the horizon",
                .changed = look.sun_altitude != standard.sun_altitude},
               look.sun_altitude, lowest_sun, 90) == RowEvent::reset) {
    look.sun_altitude = standard.sun_altitude;
  }
  ImGui::EndGroup();
}

void LookPanel::draw_camera() {
  const float wide = share_of_width(3);
  int column = 0;
  for (const OfferedView& view : offered_views) {
    if (column++ % 3 != 0) ImGui::SameLine();
    const std::string what = std::string(view.what) + " (" + view.key + ")";
    if (button(view.label, {.tooltip = what, .size = {wide, 0}})) view_state_.wanted_view = view.preset;
  }
}

void LookPanel::keep_view(Log& log) {
  try {
    bookmarks_.keep(view_name_, view_state_.camera.camera());
    view_name_.clear();
  } catch (const InputError& error) {
    log.mistakes(error);
  }
}

void LookPanel::draw_bookmarks(PanelContext& context) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float third = share_of_width(3);
  ImGui::SetNextItemWidth(2 * third + gap);
  ImGui::InputTextWithHint("##view name", ("name it, or " + bookmarks_.free_name()).c_str(), &view_name_);
  mark("view name");
  tooltip("The name under which the view is kept");
  ImGui::SameLine();
  const bool replaces = bookmarks_.has(view_name_);
  if (button(replaces ? "Replace##keep" : "Keep view##keep",
             {.tooltip = "Keeps where the camera stands now, for this terrain and others",
              .name = "Keep view",
              .size = {third, 0}})) {
    keep_view(context.app.log());
  }
  std::string removed;
  for (const Bookmarks::Entry& entry : bookmarks_.entries()) {
    const WidgetScope scope(entry.name);
    const std::string file = bookmarks_.path_of(entry.name).string();
    const float cross = ImGui::GetFrameHeight();
    if (button(
            (entry.name + "##go").c_str(),
            {.tooltip = "Back to this view" + (file.empty() ? file : ". Its file, for erg render --camera:\n" + file),
             .name = entry.name,
             .look = ButtonLook::quiet,
             .size = {ImGui::GetContentRegionAvail().x - cross - gap, 0}})) {
      view_state_.camera.set(entry.camera);
    }
    ImGui::SameLine();
    if (button("\u2715##remove",
               {.tooltip = "Forget this view", .name = "remove", .look = ButtonLook::quiet, .size = {cross, 0}})) {
      removed = entry.name;
    }
  }
  if (!removed.empty()) bookmarks_.remove(removed);
}

void LookPanel::draw_extras(const PanelContext& context) {
  Look& look = view_state_.look;
  constexpr double least = 0.1;
  if (real_row({.label = "heights \u00d7",
                .tooltip = "Factor on all heights; 1 is true to scale",
                .changed = look.exaggeration != 1},
               look.exaggeration, least, most_exaggeration) == RowEvent::reset) {
    look.exaggeration = 1;
  }
  if (look.is_material()) {
    if (real_row({.label = "grain", .tooltip = "Strength of grains and ripples", .changed = look.grain != 1},
                 look.grain, 0, 1) == RowEvent::reset) {
      look.grain = 1;
    }
  }
  const Snapshot& now = context.app.now();
  const bool torus = now.has_runs() && now.runs.front().terrain->boundary() == Boundary::torus;
  bool copies = look.copies > 0;
  if (switch_row({.label = "to the horizon",
                  .tooltip = "What leaves a torus on one side comes in on the other: show it so, as far as one sees.",
                  .unavailable = torus ? "" : "This terrain has open edges: nothing lies beyond them."},
                 copies) == RowEvent::changed) {
    look.copies = copies ? to_the_horizon : 0;
  }
  switch_row({.label = "raw cells", .tooltip = "Straight lines from cell to cell: the data as it is"}, look.raw_cells);
  switch_row({.label = "wireframe", .tooltip = "The edges of the triangles that are drawn"}, look.wireframe);
  switch_row({.label = "legend", .tooltip = "Scale of colours, wind and north over the terrain"}, view_state_.legend);
}

}  // namespace

std::vector<LookChoice> look_choices(const Snapshot& now, std::size_t run) {
  std::vector<LookChoice> choices;
  for (const std::string& key : render::standard_looks()) choices.push_back({key, key});
  choices.push_back({"shadow", "wind shadow"});
  choices.push_back({"flux", "flux"});
  if (run < now.runs.size()) {
    for (const Field& field : now.runs[run].terrain->fields()) choices.push_back({field.info.key, field.info.label});
  }
  return choices;
}

std::unique_ptr<Panel> make_look_panel(ViewState& view_state, Bookmarks& bookmarks) {
  return std::make_unique<LookPanel>(view_state, bookmarks);
}

}  // namespace erg::ui
