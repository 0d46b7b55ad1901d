// NUMBERS: the run's numbers over time, and how heights and slopes are spread.
#include <algorithm>
#include <array>

#include "core/number_text.h"
#include "io/formats/run_numbers.h"
#include "session/app_model.h"
#include "session/probe.h"
#include "ui/panels/panels.h"
#include "ui/widgets/axis_ticks.h"
#include "ui/widgets/file_browser.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {

using io::run_numbers;
using io::RunNumber;
using session::AppModel;
using session::Histogram;
using session::RunSnapshot;
using session::Snapshot;

namespace {

constexpr std::size_t most_plots = 6;

struct Spread {
  const char* label;
  const char* quantity;  ///< with its unit, for the axis and the CSV
  Histogram (*measure)(const Terrain&);
};
constexpr std::array<Spread, 3> spreads{
    Spread{"slopes", "slope, degrees", [](const Terrain& terrain) { return session::slope_histogram(terrain); }},
    Spread{"heights", "height, m", [](const Terrain& terrain) { return session::height_histogram(terrain); }},
    Spread{"thickness", "thickness, slabs",
           [](const Terrain& terrain) { return session::thickness_histogram(terrain); }},
};

/// "height, m".
std::string with_unit(const RunNumber& number) {
  return number.unit.empty() ? number.label : number.label + ", " + unit_text(number.unit);
}

std::size_t column_of(const std::string& key) {
  const std::vector<RunNumber>& numbers = run_numbers();
  const auto place =
      std::find_if(numbers.begin(), numbers.end(), [&](const RunNumber& number) { return number.key == key; });
  return static_cast<std::size_t>(place - numbers.begin());
}

class NumbersPanel final : public Panel {
 public:
  const char* title() const override { return panel_title::numbers; }
  Dock dock() const override { return Dock::right; }
  void draw(PanelContext& context) override;

 private:
  void choose_numbers();
  void draw_over_time(const Snapshot& now);
  static void draw_number(const Snapshot& now, std::size_t column);
  void draw_spread(const RunSnapshot& run);
  void save(AppModel& app);

  std::vector<std::size_t> columns_{column_of("max_slabs")};  ///< of run_numbers(), those that are plotted
  std::size_t spread_ = 0;
  Histogram histogram_;
  std::uint64_t measured_version_ = 0;
  std::size_t measured_spread_ = spreads.size();
  FilePopup series_file_{{.title = "SAVE NUMBERS", .action = "SAVE", .endings = {".csv"}, .saving = true}};
  FilePopup histogram_file_{{.title = "SAVE HISTOGRAM", .action = "SAVE", .endings = {".csv"}, .saving = true}};
};

void NumbersPanel::choose_numbers() {
  const std::vector<RunNumber>& numbers = run_numbers();
  ImGui::SetNextItemWidth(-1);
  const std::string preview =
      columns_.size() == 1 ? numbers[columns_.front()].label : std::to_string(columns_.size()) + " numbers";
  const bool open = ImGui::BeginCombo("##numbers", preview.c_str(), ImGuiComboFlags_HeightLarge);
  if (!open) mark("numbers");
  if (!open) return tooltip("Which numbers are drawn over time.");
  for (std::size_t column = 1; column < numbers.size(); ++column) {
    const auto place = std::find(columns_.begin(), columns_.end(), column);
    bool shown = place != columns_.end();
    if (ImGui::Checkbox(numbers[column].label.c_str(), &shown)) {
      if (shown && columns_.size() < most_plots) columns_.push_back(column);
      if (!shown && columns_.size() > 1) columns_.erase(place);
    }
    mark("number " + numbers[column].key);
    tooltip(numbers[column].meaning);
  }
  ImGui::EndCombo();
}

void NumbersPanel::draw_number(const Snapshot& now, std::size_t column) {
  std::vector<std::vector<double>> steps;
  std::vector<std::vector<double>> values;
  for (const RunSnapshot& run : now.runs) {
    steps.push_back(run.series->column(0));
    values.push_back(run.series->column(column));
  }
  std::vector<PlotLine> lines;
  for (std::size_t run = 0; run < now.runs.size(); ++run) {
    const std::string label = now.runs.size() > 1 ? "run " + std::to_string(run + 1) : "";
    lines.push_back({label, steps[run], values[run], line_colour(static_cast<int>(run))});
  }
  PlotFrame frame;
  frame.x_label = "step";
  frame.y_label = with_unit(run_numbers()[column]);
  frame.height = Gui::current().px(130);
  draw_plot(run_numbers()[column].key.c_str(), lines, frame);
}

void NumbersPanel::draw_over_time(const Snapshot& now) {
  choose_numbers();
  for (const std::size_t column : columns_) draw_number(now, column);
}

void NumbersPanel::draw_spread(const RunSnapshot& run) {
  for (std::size_t kind = 0; kind < spreads.size(); ++kind) {
    if (kind > 0) ImGui::SameLine();
    if (button(spreads[kind].label, {.look = kind == spread_ ? ButtonLook::accent : ButtonLook::plain})) spread_ = kind;
  }
  if (measured_version_ != run.terrain_version || measured_spread_ != spread_) {
    histogram_ = spreads[spread_].measure(*run.terrain);
    measured_version_ = run.terrain_version;
    measured_spread_ = spread_;
  }
  PlotFrame frame;
  frame.x_label = spreads[spread_].quantity;
  frame.y_label = "cells";
  frame.height = Gui::current().px(140);
  const double end = histogram_.lowest + histogram_.width * static_cast<double>(histogram_.counts.size());
  draw_histogram("spread", histogram_.counts, {histogram_.lowest, end}, frame);
}

void NumbersPanel::save(AppModel& app) {
  if (button("SAVE NUMBERS", {.tooltip = "The rows behind the plots over time, all columns, as CSV."})) {
    series_file_.ask(app.settings(), "numbers.csv");
  }
  ImGui::SameLine();
  if (button("SAVE HISTOGRAM", {.tooltip = "The bars of the histogram as CSV."})) {
    histogram_file_.ask(app.settings(), std::string(spreads[spread_].label) + ".csv");
  }
  if (const auto file = series_file_.draw(app)) app.start_export(*file, "csv");
  if (const auto file = histogram_file_.draw(app)) {
    try {
      session::write_histogram(*file, histogram_, spreads[spread_].quantity, app.provenance());
      app.log().information("saved " + file->string());
    } catch (const InputError& error) {
      app.log().mistakes(error);
    }
  }
}

void NumbersPanel::draw(PanelContext& context) {
  const Snapshot& now = context.app.now();
  if (!now.has_runs()) {
    explain("Numbers appear here once there is a terrain: press CREATE, or open one from the gallery.");
    if (button("GALLERY", {.look = ButtonLook::accent})) context.open(panel_title::gallery);
    return;
  }
  if (section("Over time")) draw_over_time(now);
  if (section("Histogram")) draw_spread(*context.app.active_run());
  save(context.app);
}

}  // namespace

std::unique_ptr<Panel> make_numbers_panel() { return std::make_unique<NumbersPanel>(); }

}  // namespace erg::ui
