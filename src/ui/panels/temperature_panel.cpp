// TEMPERATURE: over the run, for models that ask for it.
#include <algorithm>

#include "core/number_text.h"
#include "session/app_model.h"
#include "ui/panels/panels.h"
#include "ui/widgets/curve_editor.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {

using session::Setup;
using sim::temperature_parameter;

namespace {

class TemperaturePanel final : public Panel {
 public:
  const char* title() const override { return panel_title::temperature; }
  Dock dock() const override { return Dock::left; }
  bool wanted(const PanelContext& context) const override { return context.app.setup().model().info.asks_temperature; }
  void draw(PanelContext& context) override;

 private:
  static void draw_ends(Setup& setup);
  static void draw_curve(PanelContext& context);
};

void TemperaturePanel::draw_ends(Setup& setup) {
  const Temperature& now = setup.config().temperature;
  const Parameter declared = temperature_parameter();
  const auto row = [&](const char* label, double& value) {
    const RowEvent event = real_row({.label = label,
                                     .unit = declared.unit,
                                     .tooltip = parameter_tooltip(declared),
                                     .changed = value != std::get<double>(declared.standard)},
                                    value, declared.minimum, declared.maximum);
    if (event == RowEvent::reset) value = std::get<double>(declared.standard);
    return event != RowEvent::none;
  };
  double first = now.first;
  double last = now.last;
  const bool first_changed = row("at the start", first);
  const bool last_changed = row("at the end", last);
  if (first_changed || last_changed) setup.set_temperatures(first, last);
}

void TemperaturePanel::draw_curve(PanelContext& context) {
  Setup& setup = context.app.setup();
  const Temperature& now = setup.config().temperature;
  if (now.first == now.last) {
    explain("The temperature stays the same over the run. Give it another end to bend its curve.");
    return;
  }
  CurveFrame frame;
  frame.x_label = "step of the run";
  frame.y_label = unit_text(temperature_parameter().unit);
  frame.x = {0, static_cast<double>(std::max<std::int64_t>(1, setup.config().run.integer("steps") - 1))};
  frame.y = {now.first, now.last};
  frame.height = Gui::current().px(170);
  if (context.app.now().has_runs()) frame.cursor = static_cast<double>(context.app.now().step());
  BezierCurve curve = now.curve;
  if (edit_curve("curve", curve, frame)) setup.set_temperature_curve(curve);
}

void TemperaturePanel::draw(PanelContext& context) {
  draw_ends(context.app.setup());
  draw_curve(context);
}

}  // namespace

std::unique_ptr<Panel> make_temperature_panel() { return std::make_unique<TemperaturePanel>(); }

}  // namespace erg::ui
