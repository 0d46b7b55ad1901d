// What is drawn over the terrain in the window: legend, wind, captions, lines on the ground.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "picture/camera.h"
#include "render/look.h"
#include "session/snapshot.h"
#include "ui/land/terrain_camera.h"
#include "ui/land/terrain_panes.h"
#include "ui/panels/panel.h"

namespace erg::ui {

/// One run's part of the window with what is seen in it.
struct TerrainPane {
  WindowPart part;
  const session::RunSnapshot* run = nullptr;
  const TerrainGround* ground = nullptr;  ///< null until it has been drawn once
};

/// The place in the picture of a point of the terrain as pixels of the window; none behind the camera.
std::optional<ImVec2> to_window(const Eigen::Vector3d& point, const picture::Camera& camera, const WindowPart& part);
/// The place of a pixel in the picture.
render::PicturePoint to_picture(ImVec2 pixel, const WindowPart& part);

/// The legend of what a look shows, at the left edge. Nothing for materials without contour lines.
void draw_legend(const TerrainPane& pane, const render::Look& look);
/// The wind's arrow and north, in the upper right corner, turned as the camera is.
void draw_wind_rose(const TerrainPane& pane, const picture::Camera& camera);
/// Lines on the ground.
void draw_marks(const TerrainPane& pane, const picture::Camera& camera, double exaggeration,
                const std::vector<TerrainMark>& marks);
/// A line of text on a plate, its lower left corner at a point.
void draw_plate(ImVec2 low_left, const std::string& text, const ImVec4& colour);

}  // namespace erg::ui
