#include "session/folder_listing.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <ctime>
#include <string_view>
#include <system_error>

#include "session/surroundings.h"

namespace erg::session {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

std::string lowered(std::string_view text) {
  std::string low(text);
  std::ranges::transform(low, low.begin(), lower);
  return low;
}

/// The digits that stand at `at`, leading zeros dropped, and where they end.
std::string_view number_at(std::string_view text, std::size_t& at) {
  std::size_t begin = at;
  while (at < text.size() && is_digit(text[at])) ++at;
  while (begin + 1 < at && text[begin] == '0') ++begin;
  return text.substr(begin, at - begin);
}

/// As people sort names: without case, "dune2" before "dune10".
bool sorts_before(std::string_view a, std::string_view b) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    if (is_digit(a[i]) && is_digit(b[j])) {
      const std::string_view left = number_at(a, i);
      const std::string_view right = number_at(b, j);
      if (left.size() != right.size()) return left.size() < right.size();
      if (left != right) return left < right;
    } else {
      if (lower(a[i]) != lower(b[j])) return lower(a[i]) < lower(b[j]);
      ++i;
      ++j;
    }
  }
  if (a.size() - i != b.size() - j) return a.size() - i < b.size() - j;
  return a < b;  // names that differ in case or zeros only still have an order
}

std::string changed_text(const fs::directory_entry& entry) {
  std::error_code failed;
  const fs::file_time_type changed = entry.last_write_time(failed);
  if (failed) return {};
  const auto on_clock = std::chrono::file_clock::to_sys(changed);
  const std::time_t seconds =
      std::chrono::system_clock::to_time_t(std::chrono::time_point_cast<std::chrono::system_clock::duration>(on_clock));
  return local_time("%Y-%m-%d %H:%M", seconds);
}

bool ends_in_one_of(const std::string& name, const std::vector<std::string>& endings) {
  if (endings.empty()) return true;
  const std::string low = lowered(name);
  return std::ranges::any_of(endings, [&](const std::string& ending) { return low.ends_with(lowered(ending)); });
}

}  // namespace

FolderListing list_folder(const fs::path& folder, const std::vector<std::string>& endings, const std::string& filter) {
  FolderListing listing;
  std::error_code failed;
  listing.folder = fs::absolute(folder.empty() ? fs::path(".") : folder, failed).lexically_normal();
  if (!listing.folder.has_filename() && listing.folder.has_relative_path()) {
    listing.folder = listing.folder.parent_path();  // without a slash at its end
  }
  fs::directory_iterator entry(listing.folder, failed);
  if (failed) {
    listing.problem = "this folder cannot be read: " + failed.message();
    return listing;
  }
  const std::string wanted = lowered(filter);
  for (const fs::directory_iterator end; !failed && entry != end; entry.increment(failed)) {
    FolderEntry found;
    found.path = entry->path();
    found.name = found.path.filename().string();
    if (found.name.starts_with('.') && !wanted.starts_with('.')) continue;
    std::error_code unknown;
    found.folder = entry->is_directory(unknown);
    if (!found.folder) {
      if (!ends_in_one_of(found.name, endings) || lowered(found.name).find(wanted) == std::string::npos) continue;
      found.bytes = entry->is_regular_file(unknown) ? entry->file_size(unknown) : 0;
      if (unknown) found.bytes = 0;
    }
    found.changed = changed_text(*entry);
    listing.entries.push_back(std::move(found));
  }
  std::ranges::sort(listing.entries, [](const FolderEntry& a, const FolderEntry& b) {
    return a.folder != b.folder ? a.folder : sorts_before(a.name, b.name);
  });
  return listing;
}

std::vector<Place> places(const fs::path& presets) {
  std::vector<Place> found;
  std::error_code failed;
  const auto add = [&](const std::string& label, const fs::path& path) {
    if (!path.empty() && fs::is_directory(path, failed)) found.push_back({label, path});
  };
  const fs::path home = path_from_environment("HOME");
  add("Home", home);
  if (!home.empty()) {
    add("Documents", home / "Documents");
    add("Desktop", home / "Desktop");
  }
  add("Working folder", fs::current_path(failed));
  add("Presets", presets);
  add("Computer", "/");
  return found;
}

fs::path typed_path(const std::string& text, const fs::path& folder) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return folder;
  const std::string trimmed = text.substr(first, text.find_last_not_of(" \t") - first + 1);
  const fs::path home = path_from_environment("HOME");
  if (!home.empty() && trimmed == "~") return home;
  if (!home.empty() && trimmed.starts_with("~/")) return (home / trimmed.substr(2)).lexically_normal();
  return (folder / trimmed).lexically_normal();  // an absolute path stands for itself
}

fs::path with_ending(fs::path path, const std::string& ending) {
  if (path.has_filename() && !lowered(path.filename().string()).ends_with(lowered(ending))) path += ending;
  return path;
}

SaveQuestion save_question(const fs::path& path) {
  std::error_code failed;
  if (!path.has_filename()) return fs::is_directory(path, failed) ? SaveQuestion::is_folder : SaveQuestion::no_name;
  if (fs::is_directory(path, failed)) return SaveQuestion::is_folder;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, failed)) return SaveQuestion::no_folder;
  return fs::exists(path, failed) ? SaveQuestion::overwrite : SaveQuestion::none;
}

}  // namespace erg::session
