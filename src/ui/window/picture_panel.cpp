#include "ui/window/picture_panel.h"

#include <array>
#include <new>

#include "sim/memory.h"
#include "ui/widgets/file_browser.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {
namespace {

constexpr std::int64_t longest_side = 16384;  // pixels

class PicturePanel final : public Panel {
 public:
  explicit PicturePanel(std::function<void(const PictureOrder&)> save) : save_(std::move(save)) {}

  const char* title() const override { return picture_title; }
  Dock dock() const override { return Dock::dialog; }
  ImVec2 size() const override { return {460, 300}; }
  void draw(PanelContext& context) override;

 private:
  void draw_sizes();
  void write(PanelContext& context);

  std::function<void(const PictureOrder&)> save_;
  std::int64_t width_ = 1920;
  std::int64_t height_ = 1080;
  bool smooth_ = true;
  bool transparent_ = false;
  std::string file_;
  int frames_until_drawn_ = 0;  // the window says that it draws before it does
  std::string result_;
  bool failed_ = false;
  FilePopup browser_{{.title = "SAVE PICTURE", .action = "SAVE", .endings = {".png"}, .saving = true}};
};

void PicturePanel::draw(PanelContext& context) {
  draw_sizes();
  switch_row({.label = "smooth edges", .tooltip = "Draws four pixels for each one and averages them"}, smooth_);
  switch_row({.label = "transparent", .tooltip = "Nothing behind the terrain, and no legend"}, transparent_);
  ImGui::Dummy({0, Gui::current().px(6)});
  const std::string reason = context.app.now().has_runs() ? "" : "There is no terrain yet.";
  if (button("Save picture\u2026", {.tooltip = "Choose the file",
                                    .unavailable = reason,
                                    .name = "save picture",
                                    .look = ButtonLook::accent,
                                    .size = {Gui::current().px(150), 0}})) {
    browser_.ask(context.app.settings(),
                 context.app.suggested_name("-" + std::to_string(context.app.now().step()) + ".png"));
  }
  if (const auto chosen = browser_.draw(context.app)) {
    file_ = chosen->string();
    frames_until_drawn_ = 3;
    result_ = "Drawing \u2026";
    failed_ = false;
  }
  if (frames_until_drawn_ > 0 && --frames_until_drawn_ == 0) write(context);
  if (!result_.empty()) say(result_, failed_ ? Gui::current().theme().lost : Gui::current().theme().text);
  if (!result_.empty() && !failed_ && frames_until_drawn_ == 0) mark("saved");
}

void PicturePanel::draw_sizes() {
  const struct {
    const char* label;
    std::int64_t width, height;
  } sizes[] = {{"1280 \u00d7 720", 1280, 720},
               {"1920 \u00d7 1080", 1920, 1080},
               {"3840 \u00d7 2160", 3840, 2160},
               {"2048 \u00d7 2048", 2048, 2048}};
  bool first = true;
  for (const auto& size : sizes) {
    if (!first) ImGui::SameLine();
    first = false;
    const bool chosen = size.width == width_ && size.height == height_;
    if (button(size.label,
               {.tooltip = "Width and height in pixels", .look = chosen ? ButtonLook::accent : ButtonLook::plain})) {
      width_ = size.width;
      height_ = size.height;
    }
  }
  const std::string range = "1 to " + std::to_string(longest_side) + " pixels";
  integer_row({.label = "width", .unit = "pixels", .tooltip = range}, width_, 1, longest_side);
  integer_row({.label = "height", .unit = "pixels", .tooltip = range}, height_, 1, longest_side);
}

void PicturePanel::write(PanelContext& context) {
  try {
    const render::PictureSize size{static_cast<int>(width_), static_cast<int>(height_), smooth_ ? 2 : 1};
    save_({file_, size, transparent_});
    result_ = "Saved " + file_;
    context.app.log().information("saved " + file_);
  } catch (const InputError& error) {
    failed_ = true;
    result_ = error.mistakes().front().text();
    context.app.log().mistakes(error);
  } catch (const std::bad_alloc& error) {
    failed_ = true;
    result_ = file_ + ": " + sim::problem_of(error);
    context.app.log().error(result_);
  }
}

}  // namespace

std::unique_ptr<Panel> make_picture_panel(std::function<void(const PictureOrder&)> save) {
  return std::make_unique<PicturePanel>(std::move(save));
}

}  // namespace erg::ui
