#include "io/formats/camera_file.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/files/atomic_file.h"
#include "io/files/given_file.h"
#include "io/files/json_print.h"
#include "io/files/json_tree.h"

namespace erg::io {

using picture::Camera;

namespace {

// A number of a camera: its key, where it stands, and the range that makes sense.
struct CameraNumber {
  const char* key;
  double Camera::*place;
  double minimum;
  double maximum;
};

constexpr double farthest = 1e7;  // m
constexpr CameraNumber camera_numbers[] = {{"bearing", &Camera::bearing, -360, 360},
                                           {"altitude", &Camera::altitude, -90, 90},
                                           {"distance", &Camera::distance, 1e-3, farthest},
                                           {"opening", &Camera::opening, 1, 120}};

class CameraReader {
 public:
  CameraReader(const JsonNode& root, std::string name) : name_(std::move(name)) {
    const JsonNode::Object* object = root.object();
    if (object == nullptr) {
      complain(root.line, "a camera is an object, this is " + root.shown(), "write {\"target\": [x, y, z], ...}");
      return;
    }
    for (const JsonMember& member : *object) read(member);
    for (const std::string needed : {"target", "distance"}) {
      if (std::find(seen_.begin(), seen_.end(), needed) == seen_.end()) {
        complain(root.line, "\"" + needed + "\" is missing", "say where the camera looks and from how far");
      }
    }
  }

  Camera result() {
    if (!mistakes_.empty()) throw InputError(std::move(mistakes_));
    return camera_;
  }

 private:
  void read(const JsonMember& member) {
    seen_.push_back(member.key);
    if (member.key == "target") return read_target(member);
    if (member.key == "orthographic") {
      const bool* value = std::get_if<bool>(&member.node.value);
      if (value == nullptr) return complain(member.line, "\"orthographic\" is " + member.node.shown(), "true or false");
      camera_.orthographic = *value;
      return;
    }
    for (const CameraNumber& number : camera_numbers) {
      if (member.key == number.key) return read_number(member, number);
    }
    const std::vector<std::string> known{"target", "bearing", "altitude", "distance", "opening", "orthographic"};
    complain(member.line, "unknown key " + quote(member.key), suggestion(member.key, known));
  }

  void read_number(const JsonMember& member, const CameraNumber& number) {
    const std::optional<double> value = member.node.number();
    if (value && *value >= number.minimum && *value <= number.maximum) {
      camera_.*number.place = *value;
      return;
    }
    complain(member.line, "\"" + member.key + "\" is " + member.node.shown(),
             "expected " + value_text(number.minimum) + " to " + value_text(number.maximum));
  }

  void read_target(const JsonMember& member) {
    const JsonNode::Array* list = member.node.array();
    bool good = list != nullptr && list->size() == camera_.target.size();
    for (std::size_t part = 0; good && part < list->size(); ++part) {
      const std::optional<double> value = (*list)[part].number();
      good = value && std::abs(*value) <= farthest;
      if (good) camera_.target[part] = *value;
    }
    if (!good) complain(member.line, "\"target\" is no point", "three numbers: m east, m north, m up");
  }

  void complain(int line, std::string problem, std::string remedy) {
    mistakes_.push_back({name_ + ":" + std::to_string(line), std::move(problem), std::move(remedy)});
  }

  std::string name_;
  Camera camera_;
  std::vector<std::string> seen_;
  std::vector<Mistake> mistakes_;
};

}  // namespace

Camera parse_camera(std::string_view text, const std::string& name) {
  JsonTree tree = read_json(text, name);
  if (tree.broken) throw InputError({*tree.broken});
  return CameraReader(tree.root, name).result();
}

Camera read_camera(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw InputError(path.string(), "no such camera file", "give a JSON file, or top, oblique, block or side");
  }
  return parse_camera(read_text_file(path, "camera file"), path.string());
}

std::string camera_text(const Camera& camera) {
  nlohmann::ordered_json object;
  object["target"] = camera.target;
  for (const CameraNumber& number : camera_numbers) object[number.key] = camera.*number.place;
  object["orthographic"] = camera.orthographic;
  return pretty_json(object);
}

void write_camera(const std::filesystem::path& path, const Camera& camera) {
  write_file_atomically(path, camera_text(camera));
}

}  // namespace erg::io
