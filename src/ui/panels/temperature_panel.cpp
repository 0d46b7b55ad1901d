// TEMPERATURE: what runs over all of the run, for models that use it.
#include <algorithm>

#include "session/studio.h"
#include "ui/panels/panels.h"
#include "ui/widgets/curve_editor.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {

using session::Setup;

namespace {

bool shown(const Desk& desk, const Channel& channel) {
  return channel.over_run != nullptr && uses_channel(desk.studio.setup().model().info.channels, channel);
}

bool draw_ends(const Parameter& declared, Course& course) {
  const double standard = std::get<double>(declared.default_value);
  const auto row = [&](const char* label, double& value) {
    const RowEvent event = real_row(
        {.label = label, .unit = declared.unit, .tooltip = parameter_tooltip(declared), .changed = value != standard},
        value, declared.minimum, declared.maximum);
    if (event == RowEvent::reset) value = standard;
    return event != RowEvent::none;
  };
  const bool first_changed = row("at the start", course.first);
  return row("at the end", course.last) || first_changed;
}

bool draw_curve(const Desk& desk, const Parameter& declared, Course& course) {
  if (course.is_constant()) {
    explain("The " + declared.key + " stays the same over the run. Give it another end to bend its curve.");
    return false;
  }
  CurveFrame frame;
  frame.x_label = "step of the run";
  frame.y_label = declared.unit;
  frame.x = {0, static_cast<double>(std::max<std::int64_t>(1, desk.studio.setup().config().run.integer("steps") - 1))};
  frame.y = {course.first, course.last};
  frame.height = Gui::current().px(170);
  if (desk.studio.now().has_runs()) frame.cursor = static_cast<double>(desk.studio.now().step());
  return edit_curve("curve", course.curve, frame);
}

class TemperaturePanel final : public Panel {
 public:
  const char* title() const override { return panel_title::temperature; }
  Dock dock() const override { return Dock::left; }
  bool wanted(const Desk& desk) const override {
    return std::ranges::any_of(channels(), [&](const Channel& channel) { return shown(desk, channel); });
  }
  void draw(Desk& desk) override;
};

void TemperaturePanel::draw(Desk& desk) {
  bool is_first = true;
  for (const Channel& channel : channels()) {
    if (!shown(desk, channel)) continue;
    // The panel has the first one's name.
    std::optional<WidgetScope> scope;
    if (!is_first) {
      heading(channel.declared.label);
      scope.emplace(channel.declared.key);
    }
    is_first = false;
    Setup& setup = desk.studio.setup();
    Course course = setup.config().weather.*channel.over_run;
    const bool ends_changed = draw_ends(channel.declared, course);
    if (draw_curve(desk, channel.declared, course) || ends_changed) setup.set_course(channel, course);
  }
}

}  // namespace

std::unique_ptr<Panel> make_temperature_panel() { return std::make_unique<TemperaturePanel>(); }

}  // namespace erg::ui
