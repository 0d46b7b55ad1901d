#include "harness.h"

#include <stdexcept>

#include "io/formats/png.h"
#include "picture_of_gui.h"

namespace erg::test {

using ui::WidgetPlace;

namespace {

constexpr float frame_seconds = 1.0f / 60;
constexpr int pause_frames = 30;  // longer than a double click may last

}  // namespace

UiHarness::UiHarness(std::function<void()> draw, ImVec2 size, float scale)
    : gui_(ui::ThemeKind::dark, scale), draw_(std::move(draw)), size_(size) {
  frames(2);
}

void UiHarness::frames(int count) {
  for (int frame = 0; frame < count; ++frame) gui_.frame(size_, frame_seconds, draw_);
}

WidgetPlace UiHarness::place(const std::string& name) const {
  const std::optional<WidgetPlace> found = gui_.widgets().find(name);
  if (!found) throw std::runtime_error("no widget \"" + name + "\" among:\n" + gui_.widgets().text());
  return *found;
}

void UiHarness::move(ImVec2 point) {
  ImGui::GetIO().MousePos = point;
  frames();
}

void UiHarness::press(int button) {
  ImGui::GetIO().MouseDown[button] = true;
  frames();
}

void UiHarness::release(int button) {
  ImGui::GetIO().MouseDown[button] = false;
  frames();
}

void UiHarness::click(ImVec2 point, int button) {
  move(point);
  frames(pause_frames);
  press(button);
  release(button);
  frames();
}

void UiHarness::click(const std::string& name) { click(place(name).middle()); }

void UiHarness::double_click(const std::string& name) {
  click(name);
  press();
  release();
  frames();
}

void UiHarness::drag(ImVec2 from, ImVec2 to, int steps) {
  move(from);
  frames(pause_frames);
  press();
  for (int step = 1; step <= steps; ++step) {
    const float part = static_cast<float>(step) / static_cast<float>(steps);
    move({from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)});
  }
  release();
  frames();
}

void UiHarness::drag(const std::string& name, ImVec2 from, ImVec2 to) {
  const WidgetPlace box = place(name);
  const auto at = [&](ImVec2 share) {
    return ImVec2(box.low.x + share.x * (box.high.x - box.low.x), box.low.y + share.y * (box.high.y - box.low.y));
  };
  drag(at(from), at(to));
}

void UiHarness::scroll(float lines) {
  ImGui::GetIO().MouseWheel = lines;
  frames();
}

void UiHarness::type(const std::string& text) {
  ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
  frames(2);
}

void UiHarness::key(int place) {
  bool& down = ImGui::GetIO().KeysDown[place];
  down = true;
  frames();
  down = false;
  frames();
}

void UiHarness::shortcut(char letter, bool ctrl) {
  ImGuiIO& io = ImGui::GetIO();
  bool& down = io.KeysDown[static_cast<unsigned char>(letter)];
  io.KeyCtrl = ctrl;
  io.KeyMods = ctrl ? ImGuiKeyModFlags_Ctrl : ImGuiKeyModFlags_None;
  down = true;
  frames();
  down = false;
  io.KeyCtrl = false;
  io.KeyMods = ImGuiKeyModFlags_None;
  frames();
}

void UiHarness::enter(const std::string& name, const std::string& text) {
  double_click(name);
  shortcut('A');
  type(text);
  key(ui::keys::enter);
}

void UiHarness::save_png(const std::filesystem::path& path) {
  frames();
  io::write_png(path, picture_of_gui(gui_, size_), {});
}

}  // namespace erg::test
