#include "ui/window/key_reader.h"

#include <X11/XKBlib.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <langinfo.h>

#include <array>
#include <clocale>
#include <cstring>
#include <string_view>
#include <utility>

#include "ui/window/key_place.h"

namespace erg::ui {
namespace {

bool writes_utf8() { return std::string_view(nl_langinfo(CODESET)) == "UTF-8"; }

/// Letters as the person's locale has them, and in any case as UTF-8: without it X knows no dead keys but Latin ones.
void choose_letters() {
  if (std::setlocale(LC_CTYPE, "") != nullptr && writes_utf8()) return;
  for (const char* const locale : {"C.UTF-8", "en_US.UTF-8"}) {
    if (std::setlocale(LC_CTYPE, locale) != nullptr) return;
  }
}

}  // namespace

struct KeyReader::Hidden {
  ::Display* display = nullptr;
  ::Window window = 0;
  XIM method = nullptr;
  XIC context = nullptr;
  XkbDescPtr keyboard = nullptr;   // for the names of the keys
  std::array<int, 256> pressed{};  // the place under which a key went down: it goes up there, whatever Shift is then

  Hidden(::Display* on, ::Window of) : display(on), window(of) {
    pressed.fill(-1);
    XkbSetDetectableAutoRepeat(display, True, nullptr);  // a key that is held does not come up in between
    keyboard = XkbGetMap(display, 0, XkbUseCoreKbd);
    if (keyboard != nullptr) XkbGetNames(display, XkbKeyNamesMask, keyboard);
    choose_letters();
    open_method();
  }
  ~Hidden() {
    if (context != nullptr) XDestroyIC(context);
    if (method != nullptr) XCloseIM(method);
    if (keyboard != nullptr) XkbFreeKeyboard(keyboard, 0, True);
  }

  void open_method() {
    // The one that the environment names; where it does not answer, X's own, which puts dead keys together.
    for (const char* const modifiers : {"", "@im=none"}) {
      if (XSetLocaleModifiers(modifiers) == nullptr) continue;
      method = XOpenIM(display, nullptr, nullptr, nullptr);
      if (method != nullptr) break;
    }
    if (method == nullptr) return;
    XIMCallback gone{reinterpret_cast<XPointer>(this), [](XIM, XPointer self, XPointer) {
                       auto* const hidden = reinterpret_cast<Hidden*>(self);
                       hidden->method = nullptr;
                       hidden->context = nullptr;
                     }};
    XSetIMValues(method, XNDestroyCallback, &gone, nullptr);
    context = XCreateIC(method, XNInputStyle, XIMPreeditNothing | XIMStatusNothing, XNClientWindow, window,
                        XNFocusWindow, window, nullptr);
    if (context == nullptr) return;
    long wanted = 0;
    XWindowAttributes attributes{};
    if (XGetICValues(context, XNFilterEvents, &wanted, nullptr) == nullptr &&
        XGetWindowAttributes(display, window, &attributes) != 0) {
      XSelectInput(display, window, attributes.your_event_mask | wanted | FocusChangeMask);
    }
    XSetICFocus(context);
  }

  std::string position(unsigned code) const {
    if (keyboard == nullptr || keyboard->names == nullptr || keyboard->names->keys == nullptr) return {};
    if (code < keyboard->min_key_code || code > keyboard->max_key_code) return {};
    const char* const name = keyboard->names->keys[code].name;
    return {name, strnlen(name, XkbKeyNameLength)};
  }
  KeySym symbol(unsigned code, int group, int level) const {
    return XkbKeycodeToKeysym(display, static_cast<KeyCode>(code), static_cast<unsigned>(group),
                              static_cast<unsigned>(level));
  }
  /// The letter of another layout that is set up beside the present one.
  KeySym latin(unsigned code, int present) const {
    for (int group = 0; group < XkbNumKbdGroups; ++group) {
      const KeySym found = group == present ? NoSymbol : symbol(code, group, 0);
      if (found >= 'a' && found <= 'z') return found;
    }
    return NoSymbol;
  }
  PressedKey facts(const XKeyEvent& event, KeySym given) const {
    const int group = XkbGroupForCoreState(event.state);
    return {given, symbol(event.keycode, group, 0), symbol(event.keycode, group, 1), latin(event.keycode, group),
            position(event.keycode)};
  }

  /// What the key writes; `given` becomes its symbol.
  std::string text(XKeyEvent& event, KeySym& given) const {
    std::array<char, 256> letters{};
    int count = 0;
    Status status = 0;
    if (context != nullptr) {
      count = Xutf8LookupString(context, &event, letters.data(), static_cast<int>(letters.size()), &given, &status);
      if (status == XBufferOverflow) count = 0;
      if (status == XLookupChars) given = NoSymbol;
    } else {
      count = XLookupString(&event, letters.data(), static_cast<int>(letters.size()), &given, nullptr);
      // One letter of Latin-1.
      if (count == 1 && (letters[0] & 0x80) != 0) {
        const auto letter = static_cast<unsigned char>(letters[0]);
        letters[0] = static_cast<char>(0xc0 | (letter >> 6));
        letters[1] = static_cast<char>(0x80 | (letter & 0x3f));
        count = 2;
      }
    }
    const auto first = static_cast<unsigned char>(letters[0]);
    const bool writes = count > 0 && first >= 32 && first != 127 && (event.state & ControlMask) == 0;
    return writes ? std::string(letters.data(), static_cast<std::size_t>(count)) : std::string();
  }
};

KeyReader::KeyReader(_XDisplay* display, unsigned long window) : hidden_(std::make_unique<Hidden>(display, window)) {}
KeyReader::~KeyReader() = default;

bool KeyReader::filters(_XEvent& event) { return XFilterEvent(&event, 0) == True; }

KeyStroke KeyReader::read(_XEvent& event) {
  XKeyEvent& key = event.xkey;
  int& pressed = hidden_->pressed[key.keycode & 0xff];
  if (event.type == KeyRelease) return {std::exchange(pressed, -1), "", false};
  KeyStroke stroke;
  stroke.down = true;
  KeySym given = NoSymbol;
  stroke.text = hidden_->text(key, given);
  if (key.keycode == 0) return stroke;  // a letter that the input method has put together
  stroke.place = key_place(hidden_->facts(key, given));
  pressed = stroke.place;
  return stroke;
}

void KeyReader::set_focus(bool here) {
  if (!here) hidden_->pressed.fill(-1);
  if (hidden_->context == nullptr) return;
  if (here) {
    XSetICFocus(hidden_->context);
  } else {
    XUnsetICFocus(hidden_->context);
  }
}

}  // namespace erg::ui
