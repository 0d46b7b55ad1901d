#include "ui/land/view_state.h"

#include <algorithm>

#include "core/errors.h"
#include "io/formats/camera_file.h"

namespace erg::ui {

namespace fs = std::filesystem;

Bookmarks::Bookmarks(fs::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_, error)) {
    if (entry.path().extension() != ".json") continue;
    try {
      entries_.push_back({entry.path().stem().string(), io::read_camera(entry.path())});
    } catch (const InputError&) {
      // A file that is no camera is no bookmark.
    }
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.name < b.name; });
}

std::string Bookmarks::plain(std::string name) {
  std::replace(name.begin(), name.end(), '/', '-');
  name.erase(0, name.find_first_not_of(' '));
  name.erase(name.find_last_not_of(' ') + 1);
  return name;
}

fs::path Bookmarks::path_of(const std::string& name) const {
  return folder_.empty() ? fs::path() : folder_ / (plain(name) + ".json");
}

bool Bookmarks::has(const std::string& name) const {
  return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.name == plain(name); });
}

void Bookmarks::keep(const std::string& wanted, const picture::Camera& camera) {
  std::string name = plain(wanted);
  if (name.empty()) name = free_name();
  if (!folder_.empty()) {
    std::error_code error;
    fs::create_directories(folder_, error);
    io::write_camera(path_of(name), camera);
  }
  const auto same = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.name == name; });
  if (same != entries_.end()) {
    same->camera = camera;
  } else {
    entries_.push_back({name, camera});
  }
}

void Bookmarks::remove(const std::string& name) {
  std::error_code error;
  if (!folder_.empty()) fs::remove(path_of(name), error);
  std::erase_if(entries_, [&](const Entry& entry) { return entry.name == name; });
}

std::string Bookmarks::free_name() const {
  for (int number = 1;; ++number) {
    const std::string name = "view " + std::to_string(number);
    if (!has(name)) return name;
  }
}

}  // namespace erg::ui
