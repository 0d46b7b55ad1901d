#include "ui/widgets/theme.h"

#include <array>

namespace erg::ui {
namespace {

ImVec4 colour(unsigned hex, float opacity = 1) {
  return {static_cast<float>((hex >> 16) & 255u) / 255, static_cast<float>((hex >> 8) & 255u) / 255,
          static_cast<float>(hex & 255u) / 255, opacity};
}

ImVec4 with_opacity(ImVec4 base, float opacity) {
  base.w = opacity;
  return base;
}

ImVec4 between(const ImVec4& first, const ImVec4& second, float part) {
  return {first.x + part * (second.x - first.x), first.y + part * (second.y - first.y),
          first.z + part * (second.z - first.z), 1};
}

void set_colours(const Theme& theme, ImGuiStyle& style) {
  const auto set = [&](ImGuiCol which, const ImVec4& value) { style.Colors[which] = value; };
  const ImVec4 hovered = between(theme.field, theme.accent, 0.25f);
  const ImVec4 pressed = between(theme.field, theme.accent, 0.45f);
  set(ImGuiCol_Text, theme.text);
  set(ImGuiCol_TextDisabled, theme.faint);
  set(ImGuiCol_WindowBg, theme.panel);
  set(ImGuiCol_ChildBg, with_opacity(theme.panel, 0));
  set(ImGuiCol_PopupBg, between(theme.panel, theme.ground, 0.3f));
  set(ImGuiCol_Border, theme.edge);
  set(ImGuiCol_BorderShadow, with_opacity(theme.edge, 0));
  set(ImGuiCol_FrameBg, theme.field);
  set(ImGuiCol_FrameBgHovered, hovered);
  set(ImGuiCol_FrameBgActive, pressed);
  set(ImGuiCol_TitleBg, theme.ground);
  set(ImGuiCol_TitleBgActive, theme.ground);
  set(ImGuiCol_TitleBgCollapsed, theme.ground);
  set(ImGuiCol_MenuBarBg, theme.ground);
  set(ImGuiCol_ScrollbarBg, with_opacity(theme.ground, 0.4f));
  set(ImGuiCol_ScrollbarGrab, theme.edge);
  set(ImGuiCol_ScrollbarGrabHovered, theme.faint);
  set(ImGuiCol_ScrollbarGrabActive, theme.faint);
  set(ImGuiCol_CheckMark, theme.accent);
  set(ImGuiCol_SliderGrab, between(theme.field, theme.accent, 0.42f));
  set(ImGuiCol_SliderGrabActive, between(theme.field, theme.accent, 0.6f));
  set(ImGuiCol_Button, theme.field);
  set(ImGuiCol_ButtonHovered, hovered);
  set(ImGuiCol_ButtonActive, pressed);
  set(ImGuiCol_Header, between(theme.panel, theme.accent, 0.18f));
  set(ImGuiCol_HeaderHovered, between(theme.panel, theme.accent, 0.26f));
  set(ImGuiCol_HeaderActive, between(theme.panel, theme.accent, 0.36f));
  set(ImGuiCol_Separator, theme.edge);
  set(ImGuiCol_SeparatorHovered, theme.accent);
  set(ImGuiCol_SeparatorActive, theme.accent);
  set(ImGuiCol_ResizeGrip, with_opacity(theme.edge, 0.6f));
  set(ImGuiCol_ResizeGripHovered, theme.accent);
  set(ImGuiCol_ResizeGripActive, theme.accent);
  set(ImGuiCol_Tab, theme.panel);
  set(ImGuiCol_TabHovered, hovered);
  set(ImGuiCol_TabActive, between(theme.panel, theme.accent, 0.3f));
  set(ImGuiCol_PlotLines, theme.accent);
  set(ImGuiCol_PlotHistogram, theme.accent);
  set(ImGuiCol_TableHeaderBg, theme.field);
  set(ImGuiCol_TableBorderStrong, theme.edge);
  set(ImGuiCol_TableBorderLight, with_opacity(theme.edge, 0.6f));
  set(ImGuiCol_TableRowBg, with_opacity(theme.panel, 0));
  set(ImGuiCol_TableRowBgAlt, with_opacity(theme.field, 0.35f));
  set(ImGuiCol_TextSelectedBg, with_opacity(theme.accent, 0.35f));
  set(ImGuiCol_DragDropTarget, theme.accent);
  set(ImGuiCol_NavHighlight, theme.accent);
  set(ImGuiCol_ModalWindowDimBg, with_opacity(colour(0x000000), 0.45f));
}

}  // namespace

Theme Theme::make(ThemeKind kind) {
  if (kind == ThemeKind::light) {
    return {kind,
            colour(0xd9dbde),
            colour(0xeff0f2),
            colour(0xffffff),
            colour(0xbfc3c8),
            colour(0x1f2225),
            colour(0x5a6068),
            colour(0xa36a12),
            colour(0xffffff),
            colour(0x1f6a9e),
            colour(0x2e7d46),
            colour(0xb3261e)};
  }
  return {kind,
          colour(0x1b1d20),
          colour(0x24272b),
          colour(0x32363c),
          colour(0x41464d),
          colour(0xd9dcdf),
          colour(0x9aa0a6),
          colour(0xe0b062),
          colour(0x1b1d20),
          colour(0x7fb2d9),
          colour(0x7fc48f),
          colour(0xe0665c)};
}

ImVec4 Theme::line(int index) const {
  // After Okabe and Ito (2008), with the theme's own two first.
  const std::array<ImVec4, 6> lines{accent,
                                    cool,
                                    kind == ThemeKind::dark ? colour(0x66c2a5) : colour(0x00785a),
                                    kind == ThemeKind::dark ? colour(0xd98cc0) : colour(0xa5457f),
                                    kind == ThemeKind::dark ? colour(0xf0e442) : colour(0x7d7600),
                                    kind == ThemeKind::dark ? colour(0xc9ccd0) : colour(0x4a4f55)};
  return lines[static_cast<std::size_t>(index) % lines.size()];
}

void apply_theme(const Theme& theme, float scale) {
  // ScaleAllSizes multiplies what is there, so each time starts from ImGui's own style.
  ImGuiStyle style;
  style.WindowPadding = {12, 8};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 4};
  style.ItemInnerSpacing = {4, 4};
  style.IndentSpacing = 16;
  style.ScrollbarSize = 12;
  style.GrabMinSize = 12;
  style.WindowBorderSize = 1;
  style.FrameRounding = 3;
  style.GrabRounding = 3;
  style.PopupRounding = 4;
  style.ScrollbarRounding = 6;
  style.WindowMenuButtonPosition = ImGuiDir_None;
  style.ScaleAllSizes(scale);
  set_colours(theme, style);
  ImGui::GetStyle() = style;
}

}  // namespace erg::ui
