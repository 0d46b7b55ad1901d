#include "ui/panels/run_bar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "ui/widgets/typed_number.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {

using session::Activity;
using session::AppModel;
using session::LogLevel;
using session::Snapshot;

namespace {

// Stops of the speed slider in steps a second; 0: unlimited.
constexpr std::array<double, 13> speeds{1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 0};

template <typename... Numbers>
std::string format(const char* pattern, Numbers... numbers) {
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), pattern, numbers...);
  return text.data();
}

// 28 400 000 as "28.4 M".
std::string short_number(double value) {
  if (value >= 1e9) return format("%.3g G", value / 1e9);
  if (value >= 1e6) return format("%.3g M", value / 1e6);
  if (value >= 1e4) return format("%.3g k", value / 1e3);
  return format(value < 10 ? "%.1f" : "%.0f", value);
}

std::string time_text(double seconds) {
  if (seconds < 100) return format("%.0f s", std::ceil(seconds));
  if (seconds < 6000) return format("%.0f min", std::ceil(seconds / 60));
  return format("%.1f h", seconds / 3600);
}

ImVec4 colour_of(Activity activity, const Theme& theme) {
  switch (activity) {
    case Activity::running:
      return theme.good;
    case Activity::building:
      return theme.accent;
    case Activity::failed:
      return theme.lost;
    case Activity::finished:
      return theme.cool;
    default:
      return theme.text;
  }
}

void status_item(const std::string& name, const std::string& text, const ImVec4& colour, std::string_view what) {
  ImGui::TextColored(colour, "%s", text.c_str());
  mark(name);
  tooltip(what);
  ImGui::SameLine(0, Gui::current().px(20));
}

bool draw_log_item(const session::Log& log) {
  const Theme& theme = Gui::current().theme();
  const std::size_t errors = log.count(LogLevel::error);
  const std::size_t warnings = log.count(LogLevel::warning);
  std::string text = "log";
  const auto add = [&](std::size_t count, const std::string& one) {
    if (count > 0) text += (text == "log" ? ": " : ", ") + std::to_string(count) + " " + one + (count > 1 ? "s" : "");
  };
  add(errors, "error");
  add(warnings, "warning");
  ImGui::PushStyleColor(ImGuiCol_Text, errors > 0 ? theme.lost : warnings > 0 ? theme.accent : theme.faint);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {Gui::current().px(6), 0});
  const bool pressed =
      button((text + "##log").c_str(), {.tooltip = "Open the log", .name = "log", .look = ButtonLook::quiet});
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  return pressed;
}

}  // namespace

std::string why_no_step(const Snapshot& now) {
  switch (now.activity) {
    case Activity::empty:
      return "There is no terrain yet: choose a preset, or CREATE one.";
    case Activity::building:
      return "The terrain is being made.";
    case Activity::finished:
      return "It is finished: " + now.message + ". Reset it, or change something.";
    case Activity::failed:
      return "A step failed: " + now.message + ". Reset it.";
    default:
      return {};
  }
}

void play_or_pause(session::Runner& runner, const Snapshot& now) {
  if (now.activity == Activity::running) {
    runner.pause();
  } else if (why_no_step(now).empty()) {
    runner.play();
  }
}

void RunBar::draw(AppModel& app) {
  const WidgetScope scope("RUN");
  draw_buttons(app);
  ImGui::SameLine(0, Gui::current().px(20));
  draw_steps(app);
  ImGui::SameLine(0, Gui::current().px(20));
  draw_speed(app);
  ImGui::SameLine(0, Gui::current().px(20));
  draw_progress(app.now());
}

void RunBar::draw_buttons(AppModel& app) {
  const Snapshot& now = app.now();
  const bool running = now.activity == Activity::running;
  const float wide = Gui::current().px(92);
  if (button("\u25c0\u25c0 Reset##reset", {.tooltip = "Back to where this terrain began (R). Can be undone.",
                                           .unavailable = now.has_runs() ? "" : "There is no terrain yet.",
                                           .name = "reset",
                                           .size = {wide, 0}})) {
    app.runner().reset();
  }
  ImGui::SameLine();
  const std::string reason = why_no_step(now);
  if (button(running ? "\u275a\u275a Pause##play" : "\u25b6 Play##play",
             {.tooltip = running ? "Stop after this step (Space)" : "Let the wind blow (Space)",
              .unavailable = reason,
              .name = "play",
              .look = running ? ButtonLook::plain : ButtonLook::accent,
              .size = {wide, 0}})) {
    play_or_pause(app.runner(), now);
  }
  ImGui::SameLine();
  if (button("\u25b6| Step##step", {.tooltip = "One step (.)",
                                    .unavailable = running ? "It is running: pause first." : reason,
                                    .name = "step",
                                    .size = {wide, 0}})) {
    app.runner().step();
  }
}

void RunBar::draw_steps(AppModel& app) {
  const Snapshot& now = app.now();
  const std::string reason = why_no_step(now);
  if (button("Run##run", {.tooltip = "Run so many steps, then pause", .unavailable = reason, .name = "run"})) {
    app.runner().run(steps_to_run_);
  }
  ImGui::SameLine();
  ImGui::SetNextItemWidth(Gui::current().px(72));
  take_typed_number("##steps");
  ImGui::InputScalar("##steps", ImGuiDataType_S64, &steps_to_run_);
  constexpr std::int64_t most = 1'000'000'000;
  steps_to_run_ = std::clamp<std::int64_t>(steps_to_run_, 1, most);
  mark("steps to run");
  tooltip("How many steps Run makes");
  ImGui::SameLine();
  ImGui::TextUnformatted("steps");
}

void RunBar::draw_speed(AppModel& app) const {
  const double limit = app.now().speed_limit;
  int stop = static_cast<int>(speeds.size()) - 1;
  for (int index = 0; limit > 0 && index < stop; ++index) {
    if (limit <= speeds[static_cast<std::size_t>(index)]) {
      stop = index;
      break;
    }
  }
  const std::string text = limit > 0 ? format("%.0f steps/s", limit) : std::string("full speed");
  ImGui::SetNextItemWidth(Gui::current().px(150));
  if (ImGui::SliderInt("##speed", &stop, 0, static_cast<int>(speeds.size()) - 1, text.c_str(),
                       ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput)) {
    app.runner().set_speed(speeds[static_cast<std::size_t>(stop)]);
  }
  mark("speed");
  tooltip("The most steps a second, from one to as many as the machine makes");
}

void RunBar::draw_progress(const Snapshot& now) const {
  const Theme& theme = Gui::current().theme();
  if (!now.has_runs()) {
    ImGui::TextColored(theme.faint, "no terrain yet");
    mark("clock");
    return;
  }
  std::string clock = session::clock_text(*now.runs.front().config, now.step());
  ImGui::AlignTextToFramePadding();
  if (now.goal < 0) {
    ImGui::TextUnformatted(clock.c_str());
    mark("clock");
    return;
  }
  clock += " of " + std::to_string(now.goal);
  const double left = now.seconds_left();
  if (now.activity == Activity::running && left >= 0) clock += ", " + time_text(left) + " left";
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, {theme.accent.x, theme.accent.y, theme.accent.z, 0.45f});
  ImGui::ProgressBar(static_cast<float>(now.progress()), {-1, 0}, clock.c_str());
  ImGui::PopStyleColor();
  mark("clock");
}

bool draw_status(AppModel& app, float frames_per_second, const std::vector<std::string>& notes) {
  const WidgetScope scope("STATUS");
  const Theme& theme = Gui::current().theme();
  const Snapshot& now = app.now();
  std::string state = to_string(now.activity);
  if (!now.message.empty()) state += ": " + now.message;
  status_item("state", state, colour_of(now.activity, theme), "What the simulation is doing");
  if (const session::RunSnapshot* const run = app.active_run()) {
    if (now.activity == Activity::running) {
      status_item("steps", short_number(now.steps_per_second) + " steps/s", theme.text,
                  "Steps done in the last second");
      status_item("polls", short_number(now.polls_per_second) + " polls/s", theme.text,
                  "Cells asked for a slab in the last second, all runs together");
    }
    status_item("executor", run->executor_text(), theme.text, "What does the work");
    const std::int64_t drift = run->mass_drift();
    status_item("drift", "mass drift " + std::to_string(drift), drift == 0 ? theme.text : theme.lost,
                "Slabs on the ground beyond what the account says: start + in - out. It is 0, always.");
  }
  std::string frames = "Pictures of the window in the last second. At rest it draws none, which costs nothing.";
  for (const std::string& note : notes) frames += "\nJust now " + note + ".";
  status_item("frames", format("%.0f frames/s", static_cast<double>(frames_per_second)), theme.text, frames);
  return draw_log_item(app.log());
}

}  // namespace erg::ui
