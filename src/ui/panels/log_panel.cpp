// LOG: what happened, by level.
#include "session/log.h"

#include "session/app_model.h"
#include "ui/panels/panels.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {

using session::Log;
using session::LogLevel;
using session::LogLine;

namespace {

class LogPanel final : public Panel {
 public:
  const char* title() const override { return panel_title::log; }
  Dock dock() const override { return Dock::dialog; }
  ImVec2 size() const override { return {760, 360}; }
  void draw(PanelContext& context) override;

 private:
  void draw_levels(const Log& log);
  bool read_lines(const Log& log);
  void draw_lines(bool news) const;

  LogLevel least_ = LogLevel::information;
  std::vector<LogLine> lines_;
  std::uint64_t version_ = ~std::uint64_t{0};
  LogLevel read_level_ = LogLevel::information;
};

void LogPanel::draw_levels(const Log& log) {
  const std::pair<const char*, LogLevel> levels[] = {
      {"ALL", LogLevel::information}, {"WARNINGS", LogLevel::warning}, {"ERRORS", LogLevel::error}};
  for (const auto& [label, level] : levels) {
    if (level != LogLevel::information) ImGui::SameLine();
    const std::string count = level == LogLevel::information ? "" : " " + std::to_string(log.count(level));
    const std::string text = std::string(label) + count + "##" + label;
    if (button(text.c_str(), {.tooltip = "Shows lines of at least this level.",
                              .look = level == least_ ? ButtonLook::accent : ButtonLook::plain})) {
      least_ = level;
    }
    mark(label);
  }
}

/// Copies the log where it or the level has changed; true then.
bool LogPanel::read_lines(const Log& log) {
  if (version_ == log.version() && read_level_ == least_) return false;
  version_ = log.version();
  read_level_ = least_;
  lines_ = log.lines(least_);
  return true;
}

void LogPanel::draw_lines(bool news) const {
  const Theme& theme = Gui::current().theme();
  ImGui::BeginChild("lines", {0, 0}, true, ImGuiWindowFlags_AlwaysVerticalScrollbar);
  if (lines_.empty()) explain("Nothing to tell.");
  for (const LogLine& line : lines_) {
    ImGui::TextColored(theme.faint, "%s", line.time.c_str());
    ImGui::SameLine();
    say(line.text, line.level == LogLevel::error     ? theme.lost
                   : line.level == LogLevel::warning ? theme.accent
                                                     : theme.text);
  }
  if (news) ImGui::SetScrollHereY(1);
  ImGui::EndChild();
}

void LogPanel::draw(PanelContext& context) {
  Log& log = context.app.log();
  draw_levels(log);
  ImGui::SameLine();
  const bool news = read_lines(log);
  const bool empty = lines_.empty();
  if (button("COPY", {.tooltip = "The lines shown, to the clipboard.", .unavailable = empty ? "No lines." : ""})) {
    ImGui::SetClipboardText(log.text(least_).c_str());
  }
  ImGui::SameLine();
  if (button("CLEAR", {.tooltip = "Forgets all lines.", .unavailable = empty ? "No lines." : ""})) log.clear();
  draw_lines(news);
}

}  // namespace

std::unique_ptr<Panel> make_log_panel() { return std::make_unique<LogPanel>(); }

}  // namespace erg::ui
