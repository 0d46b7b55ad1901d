// RECOVERY: what a crash left behind.
#include <filesystem>

#include "session/app_model.h"
#include "ui/panels/panels.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {
namespace {

void recover(PanelContext& context, const std::filesystem::path& folder) {
  if (context.app.recover(folder)) {
    context.close(panel_title::recovery);
    context.close(panel_title::gallery);
  } else {
    context.open(panel_title::log);
  }
}

class RecoveryPanel final : public Panel {
 public:
  const char* title() const override { return panel_title::recovery; }
  Dock dock() const override { return Dock::dialog; }
  bool wanted(const PanelContext& context) const override { return !context.app.crashed_sessions().empty(); }
  ImVec2 size() const override { return {560, 200}; }
  void draw(PanelContext& context) override;

 private:
  static bool draw_session(PanelContext& context, std::size_t index);
};

bool RecoveryPanel::draw_session(PanelContext& context, std::size_t index) {
  const session::CrashedSession lost = context.app.crashed_sessions()[index];
  const WidgetScope scope("session " + std::to_string(index + 1));
  ImGui::Separator();
  say(lost.title.empty() ? "Untitled" : lost.title, Gui::current().theme().text);
  const std::string runs = lost.runs > 1 ? ", " + std::to_string(lost.runs) + " runs" : "";
  const std::string step = lost.step > 0 ? "step " + std::to_string(lost.step) : std::string("from its checkpoint");
  explain(step + runs + ", saved " + lost.saved_at);
  if (button("RECOVER", {.tooltip = "Goes on from there, paused.", .look = ButtonLook::accent})) {
    // A question may come first, and the list be another when it is answered.
    context.leave("RECOVER", session::Leaves::everything,
                  [&context, folder = lost.folder] { recover(context, folder); });
    return true;
  }
  ImGui::SameLine();
  if (button("DISCARD", {.tooltip = "Deletes what was saved of it, for good."})) {
    context.app.discard_crashed(lost.folder);
    return true;
  }
  return false;
}

void RecoveryPanel::draw(PanelContext& context) {
  if (context.app.crashed_sessions().empty()) {
    explain("Nothing is left to recover.");
    return;
  }
  explain("Erg did not end in order last time. This was saved before:");
  for (std::size_t index = 0; index < context.app.crashed_sessions().size(); ++index) {
    if (draw_session(context, index)) return;  // the list has changed
  }
}

}  // namespace

std::unique_ptr<Panel> make_recovery_panel() { return std::make_unique<RecoveryPanel>(); }

}  // namespace erg::ui
