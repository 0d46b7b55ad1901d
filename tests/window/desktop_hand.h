// The real window on a display of its own (Xvfb), with a hand on mouse and keys (xdotool).
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "../ui/monkey.h"

namespace erg::test {

/// A display without a screen, gone afterwards.
class Display {
 public:
  /// Throws std::runtime_error when Xvfb does not start.
  explicit Display(const std::string& size = "1000x760x24");
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  const std::string& name() const { return name_; }
  /// Takes it away, as a lost connection does.
  void kill();

 private:
  pid_t process_ = -1;
  std::string name_;
};

/// The program at work on a display, in a folder that also holds its settings.
class DesktopHand {
 public:
  DesktopHand(const Display& display, const std::filesystem::path& folder, const std::vector<std::string>& arguments,
              const std::map<std::string, std::string>& environment = {});
  ~DesktopHand();
  DesktopHand(const DesktopHand&) = delete;
  DesktopHand& operator=(const DesktopHand&) = delete;

  /// Waits until a widget is there (and can be used, unless `any`). Throws std::runtime_error with all names when it
  /// does not come.
  void wait_for(const std::string& name, bool any = false) const;

  /// Waits until a file is there.
  void wait_for_file(const std::filesystem::path& path) const;

  void click(const std::string& name) const;
  /// Presses on a widget, moves by so many pixels, lets go.
  void drag(const std::string& name, int right, int down) const;
  /// Keys as xdotool names them: "ctrl+s", "space".
  void key(const std::string& keys) const;
  /// Keys by their numbers, and other words of xdotool that press some.
  void raw(const std::string& words) const;
  void type(const std::string& text) const;
  /// Opens an entry or a slider for typing, all of it selected.
  void edit(const std::string& name) const;
  /// Replaces what an entry or a slider holds.
  void enter(const std::string& name, const std::string& text) const;
  /// Moves the window to a place of the screen, "x y".
  void move_window(const std::string& place) const;
  /// Pixels from top to bottom of a widget.
  int height(const std::string& name) const;
  /// Waits until that holds; false where it does not come about.
  bool comes_true(const std::function<bool()>& holds) const;
  /// What the screen shows, as a picture.
  void picture(const std::filesystem::path& path) const;

  /// What a monkey does. Nothing waits for the window to answer.
  void carry_out(const Deed& deed) const;
  /// The widgets of now.
  std::vector<Spot> spots() const;
  /// Whether the program is still there.
  bool runs();
  /// MiB of memory that it holds now; 0 when it is gone.
  double memory() const;
  /// Asks it to end, as a session manager does.
  void terminate() const;
  /// Lets go of every button, closes dialogs and quits, as often as it takes.
  void quit();

  /// Waits for the program's end; its exit code, or -1 when a signal ended it.
  int wait();
  std::string errors() const;

 private:
  struct Place {
    int left = 0, top = 0, right = 0, bottom = 0;
    bool enabled = false;
    bool operator==(const Place&) const = default;
  };
  std::map<std::string, Place> places() const;
  /// Where it lies once it moves no more.
  Place place(const std::string& name) const;
  /// Frames drawn so far.
  std::uint64_t frames() const;
  bool has_ended() const;
  /// Gives input with xdotool, and waits for the frames that show what it did: one for each press of a button or key
  /// and each button let go, and those in which everything settles.
  void hand(const std::string& words, std::uint64_t presses) const;
  void move_to(const std::string& name) const;
  void command(const std::string& words) const;
  static int code_of(int status);

  std::string display_;
  mutable std::string pointer_;  // where it is, as xdotool has it
  std::filesystem::path map_;
  std::filesystem::path errors_;
  pid_t process_ = -1;
  int ended_with_ = -1;  ///< when `runs` has seen its end
};

/// Writes the config of a terrain of few cells, "small.json", into a folder; its path.
std::string write_small_terrain(const std::filesystem::path& folder);

}  // namespace erg::test
