// Keys of an X window: their places on any layout, and the text that they write through the input method, with dead
// keys and the letters of every script. The window feeds it X's events; freeglut knows nothing of all this.
#pragma once

#include <memory>
#include <string>

struct _XDisplay;  // as X names it
union _XEvent;

namespace erg::ui {

/// One key going down or up.
struct KeyStroke {
  int place = -1;     ///< in ImGuiIO::KeysDown; -1: none
  std::string text;   ///< what it writes, UTF-8; "" for none
  bool down = false;  ///< false: it was let go
};

/// Reads keys for one window of a display.
class KeyReader {
 public:
  KeyReader(_XDisplay* display, unsigned long window);
  ~KeyReader();
  KeyReader(const KeyReader&) = delete;
  KeyReader& operator=(const KeyReader&) = delete;

  /// Whether an event is the input method's own: part of a letter that is not finished, or what it has to say to
  /// itself.
  bool filters(_XEvent& event);
  /// What a KeyPress or KeyRelease says.
  KeyStroke read(_XEvent& event);
  /// The window got the keyboard, or lost it.
  void set_focus(bool here);

 private:
  struct Hidden;
  std::unique_ptr<Hidden> hidden_;
};

}  // namespace erg::ui
