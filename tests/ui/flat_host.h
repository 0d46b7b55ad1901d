// A host without OpenGL for the shell: the ground is a flat plane, and what was asked for is written down.
#pragma once

#include <new>
#include <vector>

#include "ui/window/shell.h"

namespace erg::test {

/// Ground at height 0 under the terrain of a run.
class FlatGround final : public ui::TerrainGround {
 public:
  explicit FlatGround(render::TerrainBox box) : box_(box) {}
  render::TerrainBox box() const override { return box_; }
  std::optional<Eigen::Vector3d> under(const picture::Camera& camera, render::PicturePoint point,
                                       double aspect) const override {
    const render::Sight line = render::sight(camera, point, aspect);
    if (line.direction.z() >= 0) return std::nullopt;
    const Eigen::Vector3d place = line.from - line.from.z() / line.direction.z() * line.direction;
    const bool inside = place.x() >= 0 && place.y() >= 0 && place.x() <= box_.east && place.y() <= box_.north;
    return inside ? std::optional(place) : std::nullopt;
  }
  double height(double, double) const override { return 0; }

 private:
  render::TerrainBox box_;
};

class FlatHost final : public ui::Host {
 public:
  FlatGround flat{{32, 24, 0, 4}};
  std::vector<ui::PictureOrder> orders;
  bool closed = false;
  bool has_memory = true;

  const ui::TerrainGround* ground(std::size_t) override { return &flat; }
  ImTextureID picture(const std::filesystem::path&) override { return nullptr; }
  void save_picture(const ui::PictureOrder& order) override {
    if (!has_memory) throw std::bad_alloc();
    orders.push_back(order);
  }
  float frames_per_second() const override { return 60; }
  double suggested_scale() const override { return 1; }
  void close() override { closed = true; }
};

}  // namespace erg::test
