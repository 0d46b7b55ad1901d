#include "io/formats/png_reader.h"

#include <png.h>

#include <bit>
#include <cerrno>
#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <new>
#include <vector>

#include "core/errors.h"

namespace erg::io {

// libpng reports an error by jumping back, so nothing in a function that calls setjmp may need a destructor.
struct PngReader::Library {
  png_structp png = nullptr;
  png_infop before = nullptr;  // what stands before the pixels
  png_infop behind = nullptr;
  bool out_of_memory = false;
  char problem[160] = "";

  Library() = default;
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() { png_destroy_read_struct(&png, &before, &behind); }

  bool start(std::FILE* file);
  bool read_header();
  bool prepare_rows();
  bool read_row(png_bytep row);
  bool read_all(png_bytepp rows);
  bool read_end();

  static Library& of(png_voidp pointer) { return *static_cast<Library*>(pointer); }
  [[noreturn]] static void jump_back(png_structp png, png_const_charp problem);
  static void ignore_warning(png_structp, png_const_charp) {}
  static png_voidp take_memory(png_structp png, png_alloc_size_t bytes);
  static void give_memory(png_structp, png_voidp memory) { std::free(memory); }
  static void read_bytes(png_structp png, png_bytep to, std::size_t count);
};

void PngReader::Library::jump_back(png_structp png, png_const_charp problem) {
  Library& library = of(png_get_error_ptr(png));
  std::snprintf(library.problem, sizeof library.problem, "%s", problem);
  png_longjmp(png, 1);
}

png_voidp PngReader::Library::take_memory(png_structp png, png_alloc_size_t bytes) {
  void* const taken = std::malloc(bytes);
  if (taken == nullptr) of(png_get_mem_ptr(png)).out_of_memory = true;
  return taken;
}

void PngReader::Library::read_bytes(png_structp png, png_bytep to, std::size_t count) {
  auto* const file = static_cast<std::FILE*>(png_get_io_ptr(png));
  if (std::fread(to, 1, count, file) == count) return;
  png_error(png, std::ferror(file) != 0 ? "it cannot be read to its end" : "it ends too early");
}

bool PngReader::Library::start(std::FILE* file) {
  png =
      png_create_read_struct_2(PNG_LIBPNG_VER_STRING, this, jump_back, ignore_warning, this, take_memory, give_memory);
  if (png == nullptr) return false;
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  before = png_create_info_struct(png);
  behind = png_create_info_struct(png);
  if (before == nullptr || behind == nullptr) return false;
  png_set_read_fn(png, file, read_bytes);
  return true;
}

bool PngReader::Library::read_header() {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // the constructor has a limit of its own
  png_set_benign_errors(png, 0);                               // or pixels whose checksum is wrong are only warned of
  // Chunks that say how colours look on a screen matter to no height, and many programs write them wrongly.
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  static constexpr png_byte texts[] = "tEXt\0zTXt\0iTXt";
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_AS_DEFAULT, texts, 3);
  png_read_info(png, before);
  return true;
}

bool PngReader::Library::prepare_rows() {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_expand_16(png);  // palettes to colours, tRNS to opacity, 1 to 8 bits to 16
  if (std::endian::native == std::endian::little) png_set_swap(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, before);
  return true;
}

bool PngReader::Library::read_row(png_bytep row) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_row(png, row, nullptr);
  return true;
}

bool PngReader::Library::read_all(png_bytepp rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_image(png, rows);
  return true;
}

bool PngReader::Library::read_end() {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_end(png, behind);
  return true;
}

PngReader::PngReader(const std::filesystem::path& path)
    : path_(path), file_(std::fopen(path.c_str(), "rb"), std::fclose), library_(std::make_unique<Library>()) {
  if (!file_)
    refuse("the picture cannot be opened", std::string(std::strerror(errno)) + "; check the name and the permissions");
  if (!library_->start(file_.get())) throw std::bad_alloc();
  png_byte signature[8] = {};
  const std::size_t read = std::fread(signature, 1, sizeof signature, file_.get());
  if (read != sizeof signature || png_sig_cmp(signature, 0, sizeof signature) != 0) {
    refuse("this is no PNG", "give an 8- or 16-bit grey PNG");
  }
  png_set_sig_bytes(library_->png, sizeof signature);
  if (!library_->read_header()) fail();
  const png_structp png = library_->png;
  const png_infop info = library_->before;
  width_ = static_cast<int>(png_get_image_width(png, info));
  height_ = static_cast<int>(png_get_image_height(png, info));
  if (width_ > largest_png_side || height_ > largest_png_side) {
    refuse("the picture has " + std::to_string(width_) + " x " + std::to_string(height_) + " pixels",
           "give one of at most " + std::to_string(largest_png_side) + " on a side");
  }
  const int colour_type = png_get_color_type(png, info);
  if (!library_->prepare_rows()) fail();
  channels_ = png_get_channels(png, info);
  opacity_ = channels_ % 2 == 0;
  colours_ = colour_type == PNG_COLOR_TYPE_PALETTE       ? PngColours::palette
             : (colour_type & PNG_COLOR_MASK_COLOR) != 0 ? PngColours::colour
                                                         : PngColours::grey;
  interlaced_ = png_get_interlace_type(png, info) != PNG_INTERLACE_NONE;
}

PngReader::~PngReader() = default;

void PngReader::refuse(const std::string& problem, const std::string& remedy) const {
  throw InputError(path_.string(), problem, remedy);
}

void PngReader::fail() const {
  if (library_->out_of_memory) throw std::bad_alloc();
  refuse(std::string("the picture is damaged (") + library_->problem + ")", "fetch or make it anew");
}

std::uint64_t PngReader::held_bytes() const {
  const auto row = static_cast<std::uint64_t>(width_) * static_cast<std::uint64_t>(channels_) * sizeof(std::uint16_t);
  return interlaced_ ? row * static_cast<std::uint64_t>(height_) : row;
}

void PngReader::read_rows(const std::function<void(int, std::span<const std::uint16_t>)>& take) {
  const std::size_t samples = static_cast<std::size_t>(width_) * static_cast<std::size_t>(channels_);
  std::vector<std::uint16_t> held(held_bytes() / sizeof(std::uint16_t));
  const auto bytes_at = [&](std::size_t row) { return reinterpret_cast<png_bytep>(held.data() + row * samples); };
  if (interlaced_) {
    std::vector<png_bytep> rows(static_cast<std::size_t>(height_));
    for (std::size_t row = 0; row < rows.size(); ++row) rows[row] = bytes_at(row);
    if (!library_->read_all(rows.data())) fail();
  }
  for (int row = 0; row < height_; ++row) {
    const std::size_t place = interlaced_ ? static_cast<std::size_t>(row) : 0;
    if (!interlaced_ && !library_->read_row(bytes_at(0))) fail();
    take(row, {held.data() + place * samples, samples});
  }
  if (!library_->read_end()) fail();
}

MetadataEntries PngReader::text() const {
  MetadataEntries entries;
  for (const png_infop info : {library_->before, library_->behind}) {
    png_textp chunks = nullptr;
    const int count = png_get_text(library_->png, info, &chunks, nullptr);
    for (int index = 0; index < count; ++index) entries.emplace_back(chunks[index].key, chunks[index].text);
  }
  return entries;
}

MetadataEntries read_png_metadata(const std::filesystem::path& path) { return PngReader(path).text(); }

}  // namespace erg::io
