// Copy and paste between this program and the others on the display; freeglut has none.
#pragma once

#include <memory>
#include <string>

namespace erg::ui {

/// Owns a connection to the display of its own. While it lives, ImGui's current context copies and pastes through it.
/// Does nothing where no display answers.
class Clipboard {
 public:
  Clipboard();
  ~Clipboard();
  Clipboard(const Clipboard&) = delete;
  Clipboard& operator=(const Clipboard&) = delete;

  /// Offers a text to other programs.
  void copy(const std::string& text);
  /// What was copied last, here or in another program; "" when there is nothing or its owner does not answer soon.
  std::string paste();
  /// Hands the text to programs that asked for it since; call it often.
  void answer();

 private:
  struct Hidden;
  std::unique_ptr<Hidden> hidden_;
  std::string text_;
};

}  // namespace erg::ui
