// A stage without OpenGL for the shell: the ground is a flat plane, and what was asked for is written down.
#pragma once

#include <new>
#include <vector>

#include "ui/window/shell.h"

namespace erg::test {

/// Ground at height 0 under the land of a run.
class FlatGround final : public LandGround {
 public:
  explicit FlatGround(LandBox box) : box_(box) {}
  LandBox box() const override { return box_; }
  std::optional<Eigen::Vector3d> under(const Camera& camera, PicturePoint point, double aspect) const override {
    const Sight line = sight(camera, point, aspect);
    if (line.direction.z() >= 0) return std::nullopt;
    const Eigen::Vector3d place = line.from - line.from.z() / line.direction.z() * line.direction;
    const bool inside = place.x() >= 0 && place.y() >= 0 && place.x() <= box_.east && place.y() <= box_.north;
    return inside ? std::optional(place) : std::nullopt;
  }
  double height(double, double) const override { return 0; }

 private:
  LandBox box_;
};

class FlatStage final : public Stage {
 public:
  FlatGround flat{{32, 24, 0, 4}};
  std::vector<PictureOrder> orders;
  bool closed = false;
  bool has_memory = true;

  const LandGround* ground(std::size_t) override { return &flat; }
  ImTextureID picture(const std::filesystem::path&) override { return nullptr; }
  void save_picture(const PictureOrder& order) override {
    if (!has_memory) throw std::bad_alloc();
    orders.push_back(order);
  }
  float frames_per_second() const override { return 60; }
  double suggested_scale() const override { return 1; }
  void close() override { closed = true; }
};

}  // namespace erg::test
