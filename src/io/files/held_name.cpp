#include "io/files/held_name.h"

#include <unistd.h>

#include <cerrno>

#include "core/errors.h"
#include "io/files/atomic_file.h"

namespace erg::io {

HeldName::HeldName(const std::filesystem::path& path)
    : lock_(unfinished_name(path.parent_path() / ("." + path.filename().string()))), file_(open_alone(lock_)) {
  if (file_.is_open() || errno != EWOULDBLOCK) return;
  throw InputError(path.string(), "another run is writing files of this name",
                   "give another folder with --out, or wait until it has ended");
}

HeldName::~HeldName() {
  // Before it is closed and another may have it.
  if (file_.is_open()) ::unlink(lock_.c_str());
}

}  // namespace erg::io
