// SECTION: a cut through the ground between two cells.
#include <algorithm>
#include <cmath>

#include "session/app_model.h"
#include "session/probe.h"
#include "ui/panels/panels.h"
#include "ui/widgets/axis_ticks.h"
#include "ui/widgets/file_browser.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {

using session::AppModel;
using session::CellPlace;
using session::RunSnapshot;

namespace {

std::string cell_text(CellPlace cell) { return std::to_string(cell.x) + ", " + std::to_string(cell.y); }

bool lies_on(const Terrain& terrain, CellPlace place) {
  return place.x >= 0 && place.y >= 0 && place.x < terrain.nx() && place.y < terrain.ny();
}

class SectionPanel final : public Panel {
 public:
  const char* title() const override { return panel_title::section; }
  Dock dock() const override { return Dock::right; }
  void draw(PanelContext& context) override;

 private:
  void take_clicks(PanelContext& context);
  void draw_buttons(PanelContext& context);
  void draw_hint() const;
  void draw_cut(const RunSnapshot& run);
  void mark_line(PanelContext& context) const;
  void save(AppModel& app);

  bool picking_ = false;
  std::optional<CellPlace> from_;
  std::optional<CellPlace> to_;
  session::Section cut_;
  std::uint64_t cut_version_ = 0;
  FilePopup file_{{.title = "SAVE SECTION", .action = "SAVE", .endings = {".csv"}, .saving = true}};
};

void SectionPanel::take_clicks(PanelContext& context) {
  if (!picking_) return;
  context.tool = TerrainTool::section;
  if (!context.pointer.pressed || !context.pointer.cell) return;
  const CellPlace cell = *context.pointer.cell;
  if (!from_ || to_) {
    from_ = cell;
    to_.reset();
  } else {
    to_ = cell;
    picking_ = false;
    cut_version_ = 0;
  }
}

void SectionPanel::draw_buttons(PanelContext& context) {
  if (button("PICK TWO POINTS", {.tooltip = "Then click two points of the terrain.",
                                 .look = picking_ ? ButtonLook::accent : ButtonLook::plain})) {
    picking_ = !picking_;
    if (picking_) {
      from_.reset();
      to_.reset();
    }
  }
  ImGui::SameLine();
  if (button("CLEAR", {.tooltip = "No cut.", .unavailable = from_ ? "" : "There is none."})) {
    picking_ = false;
    from_.reset();
    to_.reset();
  }
  ImGui::SameLine();
  if (button("SAVE", {.tooltip = "The cut as CSV.", .unavailable = to_ ? "" : "Pick two points first."})) {
    file_.ask(context.app.settings(), "section.csv");
  }
}

void SectionPanel::draw_hint() const {
  if (picking_ && !from_) explain("Click the first point on the terrain.");
  if (picking_ && from_) explain("From cell " + cell_text(*from_) + ". Click the second point.");
  if (!picking_ && !to_) explain("A cut through the ground shows here once two points are picked.");
}

void SectionPanel::draw_cut(const RunSnapshot& run) {
  if (!lies_on(*run.terrain, *from_) || !lies_on(*run.terrain, *to_)) {
    explain("The points lie outside this terrain. Pick them again.");
    return;
  }
  if (cut_version_ != run.terrain_version) {
    cut_ = session::cut_section(*run.terrain, *from_, *to_);
    cut_version_ = run.terrain_version;
  }
  const PlotLine lines[] = {{"surface", cut_.distance, cut_.surface, line_colour(0)},
                            {"bedrock", cut_.distance, cut_.bedrock, line_colour(5)}};
  PlotFrame frame;
  frame.x_label = "distance, m";
  frame.y_label = "height, m";
  frame.height = Gui::current().px(150);
  draw_plot("cut", lines, frame);
  explain("From cell " + cell_text(*from_) + " to cell " + cell_text(*to_) + ", " +
          figure_text(cut_.distance.empty() ? 0 : cut_.distance.back()) + " m.");
}

void SectionPanel::mark_line(PanelContext& context) const {
  if (!from_) return;
  TerrainMark line;
  const auto add = [&](CellPlace cell) {
    line.points.push_back({static_cast<double>(cell.x), static_cast<double>(cell.y)});
  };
  add(*from_);
  if (to_) {
    add(*to_);
  } else if (context.pointer.cell) {
    add(*context.pointer.cell);
  }
  if (line.points.size() > 1) context.marks.push_back(line);
}

void SectionPanel::save(AppModel& app) {
  const auto file = file_.draw(app);
  if (!file) return;
  try {
    session::write_section(*file, cut_, app.provenance());
    app.log().information("saved " + file->string());
  } catch (const InputError& error) {
    app.log().mistakes(error);
  }
}

void SectionPanel::draw(PanelContext& context) {
  const RunSnapshot* const run = context.app.active_run();
  if (run == nullptr) {
    explain("There is no terrain to cut yet.");
    return;
  }
  take_clicks(context);
  draw_buttons(context);
  draw_hint();
  if (from_ && to_) draw_cut(*run);
  mark_line(context);
  save(context.app);
}

}  // namespace

std::unique_ptr<Panel> make_section_panel() { return std::make_unique<SectionPanel>(); }

}  // namespace erg::ui
