// A file browser of our own: places, recent files, a filter, a typed path, and the question before a file is lost.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "session/app_model.h"
#include "session/folder_listing.h"

namespace erg::ui {

/// What a browser is for.
struct FileTask {
  std::string title;                 ///< "OPEN"
  std::string action;                ///< what its button says: "OPEN", "SAVE"
  std::vector<std::string> endings;  ///< of the files shown; none: all
  bool saving = false;               ///< the file need not be there; the first ending is added to its name
};

/// The browser's content, to be drawn in a window or popup.
class FileBrowser {
 public:
  explicit FileBrowser(FileTask task) : task_(std::move(task)) {}

  const FileTask& task() const { return task_; }
  void set_endings(std::vector<std::string> endings) { task_.endings = std::move(endings); }
  /// Shows the folder used last with this name typed; reads the disk anew.
  void start(const session::Settings& settings, const std::string& name);
  /// Draws it; the file that was chosen, in the frame it is, once every question is answered.
  std::optional<std::filesystem::path> draw(session::AppModel& app);
  /// CANCEL or Escape was pressed in the last frame.
  bool cancelled() const { return cancelled_; }

 private:
  void go_to(const std::filesystem::path& folder);
  void draw_places(session::AppModel& app);
  void draw_path_line();
  void draw_entries();
  std::optional<std::filesystem::path> draw_rows();  ///< a folder that was clicked
  void draw_name_line();
  void draw_question();
  void choose(const std::filesystem::path& path);

  FileTask task_;
  session::FolderListing listing_;
  std::string path_text_;
  std::string filter_;
  std::string name_;
  std::string refusal_;                ///< why the last choice was none
  std::filesystem::path asked_about_;  ///< the file that would be overwritten; empty: no question
  std::optional<std::filesystem::path> chosen_;
  bool cancelled_ = false;
};

/// A browser in a popup over everything, for a panel that needs a file.
class FilePopup {
 public:
  explicit FilePopup(FileTask task) : browser_(std::move(task)) {}

  /// Opens it in the panel's next `draw`.
  void ask(const session::Settings& settings, const std::string& name);
  void set_endings(std::vector<std::string> endings) { browser_.set_endings(std::move(endings)); }
  /// Draws it while it is open; the file that was chosen, once.
  std::optional<std::filesystem::path> draw(session::AppModel& app);

 private:
  FileBrowser browser_;
  bool opening_ = false;
};

}  // namespace erg::ui
