// `erg render` and `erg run --frames` as a person uses them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

#include "io/formats/png.h"
#include "io/formats/png_reader.h"
#include "program.h"

namespace erg::test {
namespace {

// Width and height of a PNG, from its header, and its kind of colour (2: RGB, 6: RGB with opacity).
struct Header {
  int width = 0, height = 0, colour = 0;
};
Header png_header(const std::string& path) {
  const std::string bytes = read_bytes(path);
  if (bytes.size() < 26 || bytes.substr(1, 3) != "PNG") return {};
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t byte = at; byte < at + 4; ++byte) value = 256 * value + static_cast<unsigned char>(bytes[byte]);
    return value;
  };
  return {number(16), number(20), bytes[25]};
}

// Sets a variable of the environment for a while.
class Surroundings {
 public:
  Surroundings(const char* name, const char* value) : name_(name) {
    if (const char* const before = std::getenv(name)) before_ = before;
    setenv(name, value, 1);
  }
  ~Surroundings() {
    if (before_) {
      setenv(name_, before_->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

TEST(Render, DrawsAConfigAndACheckpointAlike) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(12));
  const Ended first = run_erg(folder, {"render", config, "--out", "a.png", "--size", "120x80", "--supersample", "1"});
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  EXPECT_NE(first.output.find("wrote a.png"), std::string::npos) << first.output;
  const Header header = png_header(folder.file("a.png"));
  EXPECT_EQ(header.width, 120);
  EXPECT_EQ(header.height, 80);
  EXPECT_EQ(header.colour, 2);

  ASSERT_EQ(run_erg(folder, {"run", config, "--out", "out", "--format", "checkpoint", "--quiet"}).exit_code, 0);
  const Ended second = run_erg(folder, {"render", "out/small-000012.checkpoint", "--out", "b.png", "--size", "120x80",
                                        "--supersample", "1", "--quiet"});
  ASSERT_EQ(second.exit_code, 0) << second.errors;
  EXPECT_EQ(second.output, "");
  EXPECT_EQ(read_bytes(folder.file("a.png")), read_bytes(folder.file("b.png")));
  bool told = false;
  for (const auto& [name, text] : io::read_png_metadata(folder.file("b.png")))
    told |= name == "erg:step" && text == "12";
  EXPECT_TRUE(told) << "the picture says what it shows";
}

TEST(Render, StepsAndLooksAreAsAskedFor) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(12));
  const auto draw = [&](const std::string& out, std::vector<std::string> more) {
    std::vector<std::string> words{"render", config, "--out", out, "--size", "64x48", "--supersample", "1", "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = run_erg(folder, words);
    EXPECT_EQ(ended.exit_code, 0) << ended.errors;
    return read_bytes(folder.file(out));
  };
  const std::string usual = draw("usual.png", {});
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{{"--steps", "0"},
                                                                                    {"--look", "snow"},
                                                                                    {"--look", "shadow"},
                                                                                    {"--look", "elevation"},
                                                                                    {"--look", "flux"},
                                                                                    {"--sun", "W,60"},
                                                                                    {"--camera", "top"},
                                                                                    {"--copies", "0"}}) {
    EXPECT_NE(draw("other.png", more), usual) << more[0] << " " << more[1];
  }
  draw("clear.png", {"--transparent"});
  EXPECT_EQ(png_header(folder.file("clear.png")).colour, 6);
}

TEST(Render, DrawsTheWaysOfGrains) {
  const ScratchFolder folder;
  const std::string config = folder.write("ripples.json", R"({
    "erg": 1, "model": "grains", "grid": {"nx": 16, "ny": 16, "cell_size": 0.01}, "scene": {"kind": "flat", "sand": 50},
    "wind": {"bearing": "W", "strength": 10}, "run": {"steps": 1}})");
  const auto draw = [&](const std::string& paths) {
    const Ended ended = run_erg(folder, {"render", config, "--out", "a.png", "--size", "64x48", "--supersample", "1",
                                         "--paths", paths, "--quiet"});
    EXPECT_EQ(ended.exit_code, 0) << ended.errors;
    return read_bytes(folder.file("a.png"));
  };
  const std::string without = draw("0");
  EXPECT_EQ(png_header(folder.file("a.png")).width, 64);
  EXPECT_NE(draw("50"), without);
}

TEST(Render, TakesACameraFile) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(3));
  folder.write("view.json", R"({"target": [24, 16, 1], "bearing": 200, "altitude": 30, "distance": 40})");
  folder.write("wrong.json", R"({"target": [24, 16, 1], "distence": 40})");
  const std::vector<std::string> common{"render", config, "--out", "a.png", "--size", "64x48", "--camera"};
  auto with = [&](const std::string& camera) {
    std::vector<std::string> words = common;
    words.push_back(camera);
    return run_erg(folder, words);
  };
  EXPECT_EQ(with("view.json").exit_code, 0);
  const Ended wrong = with("wrong.json");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.errors.find("wrong.json:1"), std::string::npos) << wrong.errors;
  EXPECT_NE(wrong.errors.find("did you mean \"distance\""), std::string::npos) << wrong.errors;
}

TEST(Render, WrongUseWritesNothing) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(3));
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--size", "big"}, "1920x1080"},       {{"--size", "0x10"}, "1920x1080"},
      {{"--camera", "obligue"}, "oblique"},   {{"--look", "elevatoin"}, "elevation"},
      {{"--palette", "cividas"}, "cividis"},  {{"--sun", "west"}, "285,24"},
      {{"--sun", "W,-3"}, "altitude"},        {{"--supersample", "9"}, "1 to 4"},
      {{"--size", "16000x16000"}, "at most"},
  };
  for (const auto& [options, word] : cases) {
    std::vector<std::string> words{"render", config, "--out", "a.png"};
    words.insert(words.end(), options.begin(), options.end());
    const Ended ended = run_erg(folder, words);
    EXPECT_EQ(ended.exit_code, 2) << options[1];
    EXPECT_NE(ended.errors.find(word), std::string::npos) << options[1] << ": " << ended.errors;
    EXPECT_FALSE(std::filesystem::exists(folder.file("a.png"))) << options[1];
  }
}

TEST(Render, TheFluxNeedsStepsToBeSeenIn) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(12));
  ASSERT_EQ(run_erg(folder, {"run", config, "--out", "out", "--format", "checkpoint", "--quiet"}).exit_code, 0);
  const std::vector<std::string> words{
      "render", "out/small-000012.checkpoint", "--out", "a.png", "--size", "64x48", "--look", "flux"};
  const Ended without = run_erg(folder, words);
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_NE(without.errors.find("--steps 32"), std::string::npos) << without.errors;
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.png")));
  std::vector<std::string> more = words;
  more.insert(more.end(), {"--steps", "14"});
  EXPECT_EQ(run_erg(folder, more).exit_code, 0);
}

TEST(Render, AMissingContextSaysWhatToInstall) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(1));
  const auto draw = [&](const std::string& context) {
    return run_erg(folder, {"render", config, "--out", "a.png", "--size", "64x48", "--context", context});
  };
  const Surroundings no_driver("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent");
  const Surroundings too_old("MESA_GL_VERSION_OVERRIDE", "2.1");
  for (const auto& [context, package] :
       {std::pair{"egl", "libegl1"}, {"osmesa", "libosmesa6"}, {"auto", ERG_HAS_OSMESA ? "libosmesa6" : "libegl1"}}) {
    const Ended ended = draw(context);
    EXPECT_EQ(ended.exit_code, 2) << context;
    EXPECT_NE(ended.errors.find(package), std::string::npos) << context << ": " << ended.errors;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.png")));
}

TEST(Film, FramesAreDrawnAsTheRunGoesOn) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(10));
  const Ended ended =
      run_erg(folder, {"run", config, "--frames", "4", "--size", "64x48", "--supersample", "1", "--quiet"});
  ASSERT_EQ(ended.exit_code, 0) << ended.errors;
  for (const char* frame : {"000000", "000001", "000002"}) {
    EXPECT_EQ(png_header(folder.file(std::string("out/small-frames/") + frame + ".png")).width, 64) << frame;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.file("out/small-frames/000003.png")));
}

Ended film(const ScratchFolder& folder) {
  const std::string config = folder.write("small.json", small_config(8));
  return run_erg(folder, {"run", config, "--frames", "2", "--size", "65x47", "--supersample", "1", "--quiet"});
}

TEST(Film, FramesAreJoinedByFfmpeg) {
  if (std::system("command -v ffmpeg > /dev/null") != 0) GTEST_SKIP() << "ffmpeg is not installed: no film to look at";
  const ScratchFolder folder;
  const Ended ended = film(folder);
  ASSERT_EQ(ended.exit_code, 0) << ended.errors;
  EXPECT_EQ(ended.errors.find("No film"), std::string::npos) << ended.errors;
  const std::string movie = read_bytes(folder.file("out/small.mp4"));
  ASSERT_GT(movie.size(), 500u);
  EXPECT_EQ(movie.substr(4, 4), "ftyp") << "how an MP4 file begins";
  // The box `stts` counts the frames: five, of one length. Its fields: version, entries, frames, length.
  const std::size_t times = movie.find("stts");
  ASSERT_NE(times, std::string::npos);
  EXPECT_EQ(movie.substr(times + 8, 4), std::string("\0\0\0\1", 4));
  EXPECT_EQ(movie.substr(times + 12, 4), std::string("\0\0\0\5", 4));
}

TEST(Film, FramesOfAnEarlierLongerRunAreNotInIt) {
  const ScratchFolder folder;
  // Stands in for ffmpeg and writes down what it was asked for.
  folder.write("ffmpeg", "#!/bin/sh\necho \"$@\" > asked.txt\nfor film; do :; done\n: > \"$film\"\n");
  std::filesystem::permissions(folder.path() / "ffmpeg", std::filesystem::perms::owner_all);
  const Surroundings only("PATH", folder.path().c_str());
  const std::string longer = folder.write("small.json", small_config(12));
  ASSERT_EQ(run_erg(folder, {"run", longer, "--frames", "2", "--size", "65x47", "--quiet"}).exit_code, 0);
  const Ended ended = film(folder);
  ASSERT_EQ(ended.exit_code, 0) << ended.errors;
  EXPECT_TRUE(std::filesystem::exists(folder.file("out/small-frames/000006.png"))) << "of the longer run";
  EXPECT_NE(read_bytes(folder.file("asked.txt")).find(" -frames:v 5 "), std::string::npos);
}

TEST(Film, WithoutFfmpegTheFramesStayAndSayWhatIsMissing) {
  const ScratchFolder folder;
  const Surroundings nothing("PATH", "/nonexistent");
  const Ended ended = film(folder);
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_NE(ended.errors.find("apt-get install ffmpeg"), std::string::npos) << ended.errors;
  EXPECT_TRUE(std::filesystem::exists(folder.file("out/small-frames/000004.png")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("out/small.mp4")));
}

TEST(Gallery, MakesTheFoldersOfItsPictures) {
  const ScratchFolder folder;
  const std::string name = "thesis/snow_ripples";
  const Ended ended = run_erg(folder, {"gallery", name, "--out", "cards", "--quiet"});
  ASSERT_EQ(ended.exit_code, 0) << ended.errors;
  const std::string picture = folder.file("cards/gallery/" + name + ".jpg");
  EXPECT_TRUE(read_bytes(picture).starts_with("\xff\xd8\xff")) << "a JPEG";
  // One that is there is left alone where only the missing are wanted.
  write_bytes(picture, "mine");
  EXPECT_EQ(run_erg(folder, {"gallery", name, "--out", "cards", "--quiet", "--missing"}).exit_code, 0);
  EXPECT_EQ(read_bytes(picture), "mine");
}

}  // namespace
}  // namespace erg::test
