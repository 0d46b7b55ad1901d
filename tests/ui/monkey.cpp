#include "monkey.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "ui/widgets/gui.h"

namespace erg::test {
namespace {

/// What the monkey must not press: ways to other folders, sizes that take all memory, the way out.
bool forbidden(std::string_view name) {
  constexpr std::array words{"/UP",          "/path",  "/places/",       "/recent/",       "/Cells east",
                             "/Cells north", "/width", "PICTURE/height", "menu File/Quit", "PICTURE/size"};
  return name.ends_with('/') ||
         std::ranges::any_of(words, [&](std::string_view word) { return name.find(word) != std::string_view::npos; });
}

bool holds(const Spot& spot, float x, float y) {
  constexpr float margin = 3;
  return x >= spot.left - margin && x <= spot.right + margin && y >= spot.top - margin && y <= spot.bottom + margin;
}

const std::vector<MonkeyKey>& all_keys() {
  static const std::vector<MonkeyKey> all = [] {
    std::vector<MonkeyKey> list{{ui::keys::escape, false, "Escape"},
                                {ui::keys::enter, false, "Return"},
                                {ui::keys::tab, false, "Tab"},
                                {ui::keys::backspace, false, "BackSpace"},
                                {ui::keys::left, false, "Left"},
                                {ui::keys::right, false, "Right"},
                                {ui::keys::up, false, "Up"},
                                {ui::keys::down, false, "Down"},
                                {ui::keys::home, false, "Home"},
                                {ui::keys::end, false, "End"},
                                {ui::keys::page_up, false, "Prior"},
                                {ui::keys::page_down, false, "Next"},
                                {ui::keys::remove, false, "Delete"},
                                {ui::keys::space, false, "space"},
                                {'.', false, "period"},
                                {'+', false, "plus"},
                                {'-', false, "minus"}};
    for (const char letter : std::string("FGR1234")) list.push_back({letter, false, std::string(1, letter)});
    for (const char letter : std::string("ACENOSVXYZ")) {
      list.push_back({letter, true, std::string("ctrl+") + static_cast<char>(letter - 'A' + 'a')});
    }
    for (int number = 1; number <= 12; ++number) {
      list.push_back({ui::keys::function + number, false, "F" + std::to_string(number)});
    }
    return list;
  }();
  return all;
}

/// Typed into whatever entry is open: numbers, names, what makes no sense. No way to another folder.
constexpr std::array texts{"7", "0.5", "-3", "1e9", "nan", "mine", "270", "x", "48", "0", "a b", "99999999999"};

}  // namespace

Monkey::Monkey(unsigned seed, float width, float height) : random_(seed), width_(width), height_(height) {}

Deed Monkey::next(const std::vector<Spot>& spots) {
  const int dice = below(100);
  Deed deed;
  if (dice < 45) return go_somewhere(spots);
  if (dice < 82) return press_or_let_go(spots);
  if (dice < 86) {
    deed.kind = Deed::Kind::wheel;
    deed.lines = below(2) == 0 ? 1 : -1;
  } else if (dice < 95) {
    deed.kind = Deed::Kind::key;
    deed.key = all_keys()[static_cast<std::size_t>(below(static_cast<int>(all_keys().size())))];
  } else {
    deed.kind = Deed::Kind::type;
    deed.text = texts[static_cast<std::size_t>(below(static_cast<int>(texts.size())))];
  }
  return deed;
}

/// Mostly onto a widget, now and then anywhere.
Deed Monkey::go_somewhere(const std::vector<Spot>& spots) {
  x_ = static_cast<float>(below(static_cast<int>(width_)));
  y_ = static_cast<float>(below(static_cast<int>(height_)));
  if (!spots.empty() && below(5) > 0) {
    const Spot& spot = spots[static_cast<std::size_t>(below(static_cast<int>(spots.size())))];
    const auto within = [this](float low, float high) {
      return low + (high - low) * (0.1f + 0.8f * static_cast<float>(below(1000)) / 1000);
    };
    x_ = within(spot.left, spot.right);
    y_ = within(spot.top, spot.bottom);
  }
  Deed deed;
  deed.x = x_;
  deed.y = y_;
  return deed;
}

Deed Monkey::press_or_let_go(const std::vector<Spot>& spots) {
  Deed deed;
  for (int button = 0; button < 3; ++button) {
    if (!down_[button]) continue;
    down_[button] = false;
    deed.kind = Deed::Kind::release;
    deed.button = button;
    return deed;
  }
  const bool barred =
      std::ranges::any_of(spots, [this](const Spot& spot) { return forbidden(spot.name) && holds(spot, x_, y_); });
  if (barred) return go_somewhere(spots);
  deed.kind = Deed::Kind::press;
  deed.button = below(8) < 6 ? 0 : 1 + below(2);
  down_[deed.button] = true;
  return deed;
}

}  // namespace erg::test
