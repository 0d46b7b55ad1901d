// A monkey at mouse and keyboard: what it does next is random, the same for the same seed. It is kept from what would
// leave the folder that the test gave it, or fill the machine.
#pragma once

#include <random>
#include <string>
#include <vector>

namespace erg::test {

/// A widget on the screen, in pixels.
struct Spot {
  std::string name;
  float left = 0, top = 0, right = 0, bottom = 0;
};

/// A key, for ImGui and for xdotool.
struct MonkeyKey {
  int place = 0;  ///< in ImGuiIO::KeysDown
  bool ctrl = false;
  std::string name;  ///< "ctrl+z"
};

/// One thing done with the hands.
struct Deed {
  enum class Kind { move, press, release, wheel, key, type };
  Kind kind = Kind::move;
  float x = 0, y = 0;  ///< move: where to
  int button = 0;      ///< press, release: 0 left, 1 right, 2 middle
  int lines = 0;       ///< wheel
  MonkeyKey key;
  std::string text;  ///< type
};

class Monkey {
 public:
  Monkey(unsigned seed, float width, float height);

  /// What it does next, looking at the widgets of now.
  Deed next(const std::vector<Spot>& spots);

 private:
  int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }
  Deed go_somewhere(const std::vector<Spot>& spots);
  Deed press_or_let_go(const std::vector<Spot>& spots);

  std::mt19937 random_;
  float width_;
  float height_;
  float x_ = 0, y_ = 0;
  bool down_[3] = {};
};

}  // namespace erg::test
