// WIND: constant, or a list of seasons that repeats.
#include <algorithm>
#include <cmath>

#include "forcing/bearing.h"
#include "session/app_model.h"
#include "session/wind_cycle.h"
#include "ui/panels/panels.h"
#include "ui/widgets/axis_ticks.h"
#include "ui/widgets/curve_editor.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/row_table.h"
#include "ui/widgets/widgets.h"
#include "ui/widgets/wind_dial.h"

namespace erg::ui {

using forcing::compass_name;
using forcing::largest_strength;
using forcing::smallest_strength;
using forcing::WindInterval;

namespace {

constexpr std::size_t cycle_samples = 400;  // at most

/// "5" or "3 to 8".
std::string strength_text(const WindInterval& season) {
  const std::string first = figure_text(season.first, 3);
  return season.first == season.last ? first : first + " to " + figure_text(season.last, 3);
}

class WindPanel final : public Panel {
 public:
  const char* title() const override { return panel_title::wind; }
  Dock dock() const override { return Dock::left; }
  void draw(PanelContext& context) override;

 private:
  bool shows_seasons(const session::WindEditor& wind) const {
    return seasons_wanted_ || !wind.schedule().is_constant();
  }
  void draw_kind(const session::WindEditor& wind);
  void draw_list(const session::WindEditor& wind, std::size_t now);
  void draw_list_buttons(session::WindEditor wind);
  void draw_bearing(session::WindEditor wind);
  void draw_strengths(session::WindEditor wind, const std::string& strength_label);
  void draw_column(session::WindEditor wind, const std::string& key) const;
  void draw_swing(const session::WindEditor& wind) const;
  void draw_curve(session::WindEditor wind, const session::AppModel& app, const std::string& strength_label);
  void draw_cycle(const session::WindEditor& wind, std::int64_t step, const std::string& strength_label) const;
  static void draw_rose(const session::WindEditor& wind, const session::AppModel& app);

  std::size_t selected_ = 0;
  bool seasons_wanted_ = false;
  std::vector<WindInterval> put_aside_;  ///< the seasons while the wind is constant, so that switching loses nothing
};

void WindPanel::draw_kind(const session::WindEditor& wind) {
  const bool seasons = shows_seasons(wind);
  const float half = share_of_width(2);
  if (button("CONSTANT", {.tooltip = "One bearing and one strength for ever. Seasons are kept for later.",
                          .look = seasons ? ButtonLook::plain : ButtonLook::accent,
                          .size = {half, 0}}) &&
      seasons) {
    put_aside_ = wind.schedule().intervals;
    WindInterval constant = wind.season(selected_);
    constant.last = constant.first;
    constant.curve = {};
    session::WindEditor(wind).replace({constant});
    seasons_wanted_ = false;
    selected_ = 0;
  }
  ImGui::SameLine();
  if (button("SEASONS", {.tooltip = "A list of winds that repeats.",
                         .look = seasons ? ButtonLook::accent : ButtonLook::plain,
                         .size = {half, 0}}) &&
      !seasons) {
    session::WindEditor(wind).replace(put_aside_);
    seasons_wanted_ = true;
  }
}

void WindPanel::draw_list(const session::WindEditor& wind, std::size_t now) {
  constexpr ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp;
  if (!ImGui::BeginTable("seasons", 4, flags)) return;
  ImGui::TableSetupColumn("", 0, 0.5f);
  ImGui::TableSetupColumn("from", 0, 1.6f);
  ImGui::TableSetupColumn("strength", 0, 1.3f);
  ImGui::TableSetupColumn("steps", 0, 1);
  ImGui::TableHeadersRow();
  for (std::size_t index = 0; index < wind.seasons(); ++index) {
    const WindInterval& season = wind.season(index);
    ImGui::TableNextColumn();
    const std::string number = std::to_string(index + 1);
    if (ImGui::Selectable(number.c_str(), index == selected_, ImGuiSelectableFlags_SpanAllColumns)) selected_ = index;
    mark("season " + number);
    ImGui::TableNextColumn();
    ImGui::Text("%s", (compass_name(season.bearing) + "  " + figure_text(season.bearing) + "\u00b0").c_str());
    ImGui::TableNextColumn();
    ImGui::Text("%s", strength_text(season).c_str());
    ImGui::TableNextColumn();
    ImGui::Text("%lld", static_cast<long long>(season.steps));
    if (index == now) {
      ImGui::SameLine();
      ImGui::TextColored(Gui::current().theme().accent, "now");
    }
  }
  ImGui::EndTable();
}

void WindPanel::draw_list_buttons(session::WindEditor wind) {
  switch (list_buttons({.row_name = "season", .count = wind.seasons(), .selected = selected_, .fewest = 1})) {
    case ListEdit::none:
      break;
    case ListEdit::add:
      selected_ = wind.add();
      break;
    case ListEdit::copy:
      selected_ = wind.duplicate(selected_);
      break;
    case ListEdit::remove:
      wind.remove(selected_);
      selected_ = std::min(selected_, wind.seasons() - 1);
      break;
    case ListEdit::up:
      if (wind.move_up(selected_)) --selected_;
      break;
    case ListEdit::down:
      if (wind.move_down(selected_)) ++selected_;
      break;
  }
}

void WindPanel::draw_bearing(session::WindEditor wind) {
  const Gui& gui = Gui::current();
  double bearing = wind.season(selected_).bearing;
  bool changed = wind_dial("dial", bearing, gui.px(132), wind.season(selected_).spread);
  ImGui::SameLine();
  ImGui::BeginGroup();
  ImGui::Dummy({1, gui.px(24)});
  ImGui::TextColored(gui.theme().faint, "blows from");
  changed = type_bearing("bearing", bearing) || changed;
  ImGui::EndGroup();
  if (changed) wind.set_bearing(selected_, bearing);
}

void WindPanel::draw_strengths(session::WindEditor wind, const std::string& strength_label) {
  const WindInterval season = wind.season(selected_);
  const bool seasons = shows_seasons(wind);
  const std::string range = "\nrange: " + figure_text(smallest_strength) + " to " + figure_text(largest_strength);
  const auto row = [&](const char* label, const std::string& meaning, double value) {
    return Row{.label = label, .tooltip = meaning + range, .changed = value != wind.standard().first};
  };
  double first = season.first;
  const RowEvent event = real_row(row(seasons ? "first strength" : "strength", strength_label, first), first,
                                  smallest_strength, largest_strength);
  if (event == RowEvent::reset) first = wind.standard().first;
  if (event != RowEvent::none) {
    wind.set_first(selected_, first);
    if (!seasons) wind.set_last(selected_, first);
  }
  if (!seasons) return;
  double last = season.last;
  const RowEvent last_event = real_row(row("last strength", strength_label + " at the end of the season", last), last,
                                       smallest_strength, largest_strength);
  if (last_event == RowEvent::reset) last = wind.standard().last;
  if (last_event != RowEvent::none) wind.set_last(selected_, last);
  std::int64_t steps = season.steps;
  const Declarations columns = wind.columns();
  const Parameter& declared = *columns.find("steps");
  const RowEvent steps_event =
      integer_row({.label = "length", .unit = "steps", .tooltip = parameter_tooltip(declared)}, steps,
                  static_cast<std::int64_t>(declared.minimum), static_cast<std::int64_t>(declared.maximum));
  if (steps_event == RowEvent::changed) wind.set_steps(selected_, steps);
}

void WindPanel::draw_column(session::WindEditor wind, const std::string& key) const {
  const Declarations columns = wind.columns();
  ParameterValue value = wind.value(selected_, key);
  if (parameter_row(*columns.find(key), value) != RowEvent::none) wind.set(selected_, key, value);
}

void WindPanel::draw_swing(const session::WindEditor& wind) const {
  draw_column(wind, "spread");
  if (wind.season(selected_).spread > 0) draw_column(wind, "hold");
}

void WindPanel::draw_curve(session::WindEditor wind, const session::AppModel& app, const std::string& strength_label) {
  const WindInterval& season = wind.season(selected_);
  if (season.first == season.last) {
    explain("The strength stays the same over this season. Give it another last strength to bend its curve.");
    return;
  }
  CurveFrame frame;
  frame.x_label = "step of the season";
  frame.y_label = strength_label;
  frame.x = {0, static_cast<double>(std::max<std::int64_t>(1, season.steps - 1))};
  frame.y = {season.first, season.last};
  frame.height = Gui::current().px(170);
  const session::WindCycle cycle = session::sample_cycle(wind.schedule(), 2);
  if (app.now().has_runs() && cycle.season_at(app.now().step()) == selected_) {
    frame.cursor = static_cast<double>(cycle.position(app.now().step()) - cycle.season_starts[selected_]);
  }
  BezierCurve curve = season.curve;
  if (edit_curve("curve", curve, frame)) wind.set_curve(selected_, curve);
}

void WindPanel::draw_cycle(const session::WindEditor& wind, std::int64_t step,
                           const std::string& strength_label) const {
  const auto steps_of_cycle = static_cast<std::size_t>(std::max<std::int64_t>(2, wind.schedule().cycle()));
  const session::WindCycle cycle = session::sample_cycle(wind.schedule(), std::min(cycle_samples, steps_of_cycle));
  std::vector<double> steps(cycle.steps.begin(), cycle.steps.end());
  PlotFrame frame;
  frame.x_label = "step of the cycle";
  frame.y_label = strength_label;
  frame.x = AxisRange{0, static_cast<double>(cycle.length)};
  frame.from_zero = true;
  frame.cursor = static_cast<double>(cycle.position(step));
  frame.height = Gui::current().px(150);
  for (std::size_t index = 0; index < cycle.season_starts.size(); ++index) {
    const bool last = index + 1 == cycle.season_starts.size();
    const std::int64_t end = last ? cycle.length : cycle.season_starts[index + 1];
    frame.bands.push_back({static_cast<double>(cycle.season_starts[index]), static_cast<double>(end),
                           compass_name(wind.season(index).bearing), index == selected_});
  }
  const PlotLine line{"", steps, cycle.strengths, line_colour(0)};
  draw_plot("cycle", {&line, 1}, frame);
}

void WindPanel::draw_rose(const session::WindEditor& wind, const session::AppModel& app) {
  const Gui& gui = Gui::current();
  const std::int64_t now = app.now().step();
  std::int64_t end = now + wind.schedule().cycle();
  if (app.now().has_runs()) end = std::max(end, app.now().runs.front().config->run.integer("steps"));
  const session::WindRose rose = session::wind_rose(wind.schedule(), now, end, session::WindRecord::sectors);
  // What has blown is what was recorded: the seasons may be set to anything else by now.
  draw_wind_rose("rose", app.now().blown.sums, rose.to_blow, gui.px(150));
  ImGui::SameLine();
  ImGui::BeginGroup();
  ImGui::Dummy({1, gui.px(40)});
  const float line = ImGui::GetTextLineHeight();
  const auto key = [&](bool filled, const char* text) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 end_corner{corner.x + line * 0.8f, corner.y + line * 0.9f};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (filled) list.AddRectFilled(corner, end_corner, ImGui::GetColorU32(gui.theme().accent));
    if (!filled) list.AddRect(corner, end_corner, ImGui::GetColorU32(gui.theme().text));
    ImGui::Dummy({line, line});
    ImGui::SameLine();
    ImGui::TextColored(gui.theme().faint, "%s", text);
  };
  key(true, "has blown");
  key(false, "will blow");
  ImGui::EndGroup();
}

void WindPanel::draw(PanelContext& context) {
  session::AppModel& app = context.app;
  session::WindEditor wind = app.comparison().wind();
  selected_ = std::min(selected_, wind.seasons() - 1);
  const std::string strength_label = app.setup().model().info.strength_label;
  draw_kind(wind);
  selected_ = std::min(selected_, wind.seasons() - 1);
  if (shows_seasons(wind)) {
    const std::size_t now = session::sample_cycle(wind.schedule(), 2).season_at(app.now().step());
    draw_list(wind, now);
    draw_list_buttons(wind);
  }
  draw_bearing(wind);
  draw_strengths(wind, strength_label);
  draw_swing(wind);
  for (const forcing::Channel& channel : forcing::channels()) {
    if (channel.of_interval != nullptr && app.comparison().uses(channel)) draw_column(wind, channel.declared.key);
  }
  if (shows_seasons(wind)) {
    draw_curve(wind, app, strength_label);
    if (section("The whole cycle")) draw_cycle(wind, app.now().step(), strength_label);
  }
  if (section("Wind rose")) draw_rose(wind, app);
}

}  // namespace

std::unique_ptr<Panel> make_wind_panel() { return std::make_unique<WindPanel>(); }

}  // namespace erg::ui
