// Pictures of a run as it goes on, and a film of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "app/cli/picture_options.h"
#include "render/gl_context.h"

namespace erg::app {

/// The frames of one run, and the film that they are joined to.
class Film {
 public:
  /// Frames go into `folder`/`name`-frames (made when missing), one every `every` steps. Throws InputError for wrong
  /// picture options, a size that no film can have, where nothing can be drawn, and where it cannot write.
  Film(const std::filesystem::path& folder, const std::string& name, std::int64_t every, const PictureRequest& request,
       sim::Simulation& simulation);

  /// Draws the present state. The camera stays where it was planned at first.
  void add_frame(sim::Simulation& simulation);

  /// Joins the frames to `folder`/`name`.mp4 with ffmpeg, or says that ffmpeg is missing. Throws WriteError when it
  /// fails; an older film is then untouched.
  void finish(bool quiet) const;

 private:
  std::string frame_name(const sim::Simulation& simulation) const;

  std::filesystem::path frames_;
  std::filesystem::path movie_;
  std::int64_t every_;
  std::unique_ptr<render::GlContext> context_;
  std::unique_ptr<render::Renderer> renderer_;
  PicturePlan plan_;
  std::int64_t first_ = -1;  // number of the first frame
  std::int64_t last_ = -1;   // and of the last one
};

}  // namespace erg::app
