// Cameras as JSON: bookmarks of views.
//
//   {"target": [256, 256, 4], "bearing": 160, "altitude": 24, "distance": 600, "opening": 32, "orthographic": false}
//
// Lengths in m, angles in degrees, as in picture/camera.h. Only target and distance must be there.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "picture/camera.h"

namespace erg::io {

/// Reads a camera. Throws one InputError with every mistake in the file, each at `file:line`.
picture::Camera read_camera(const std::filesystem::path& path);

/// The same from text; `name` stands for the file in mistakes.
picture::Camera parse_camera(std::string_view text, const std::string& name);

/// The camera as the text of a file: parse_camera gives the same camera back.
std::string camera_text(const picture::Camera& camera);

/// Writes the camera, whole or not at all. Throws InputError when it cannot.
void write_camera(const std::filesystem::path& path, const picture::Camera& camera);

}  // namespace erg::io
