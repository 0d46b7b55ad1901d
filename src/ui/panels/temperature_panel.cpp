// TEMPERATURE: what runs over all of the run, for models that use it.
#include <algorithm>

#include "core/number_text.h"
#include "session/app_model.h"
#include "ui/panels/panels.h"
#include "ui/widgets/curve_editor.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {

using forcing::Channel;
using forcing::channels;
using forcing::Course;
using session::Setup;

namespace {

bool shown(const PanelContext& context, const Channel& channel) {
  return channel.over_run != nullptr && uses_channel(context.app.setup().model().info.channels, channel);
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

bool draw_curve(const PanelContext& context, const Parameter& declared, Course& course) {
  if (course.is_constant()) {
    explain("The " + declared.key + " stays the same over the run. Give it another end to bend its curve.");
    return false;
  }
  CurveFrame frame;
  frame.x_label = "step of the run";
  frame.y_label = unit_text(declared.unit);
  frame.x = {0, static_cast<double>(std::max<std::int64_t>(1, context.app.setup().config().run.integer("steps") - 1))};
  frame.y = {course.first, course.last};
  frame.height = Gui::current().px(170);
  if (context.app.now().has_runs()) frame.cursor = static_cast<double>(context.app.now().step());
  return edit_curve("curve", course.curve, frame);
}

class TemperaturePanel final : public Panel {
 public:
  const char* title() const override { return panel_title::temperature; }
  Dock dock() const override { return Dock::left; }
  bool wanted(const PanelContext& context) const override {
    return std::ranges::any_of(channels(), [&](const Channel& channel) { return shown(context, channel); });
  }
  void draw(PanelContext& context) override;
};

void TemperaturePanel::draw(PanelContext& context) {
  bool is_first = true;
  for (const Channel& channel : channels()) {
    if (!shown(context, channel)) continue;
    // The panel has the first one's name.
    std::optional<WidgetScope> scope;
    if (!is_first) {
      heading(channel.declared.label);
      scope.emplace(channel.declared.key);
    }
    is_first = false;
    Setup& setup = context.app.setup();
    Course course = setup.config().weather.*channel.over_run;
    const bool ends_changed = draw_ends(channel.declared, course);
    if (draw_curve(context, channel.declared, course) || ends_changed) setup.set_course(channel, course);
  }
}

}  // namespace

std::unique_ptr<Panel> make_temperature_panel() { return std::make_unique<TemperaturePanel>(); }

}  // namespace erg::ui
