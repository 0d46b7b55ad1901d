// A column as wide as the window's docks, to put widgets into.
#pragma once

#include <functional>
#include <utility>

#include "harness.h"
#include "ui/widgets/widgets.h"

namespace erg::test {

inline void hold_shift(bool down) {
  ImGui::GetIO().KeyShift = down;
  ImGui::GetIO().KeyMods = down ? ImGuiKeyModFlags_Shift : ImGuiKeyModFlags_None;
}

inline UiHarness in_a_column(std::function<void()> draw, float width = 330) {
  return UiHarness(
      [draw = std::move(draw), width] {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({width, 800});
        ImGui::Begin("column", nullptr, ImGuiWindowFlags_NoDecoration);
        draw();
        ImGui::End();
      },
      {width, 800});
}

}  // namespace erg::test
