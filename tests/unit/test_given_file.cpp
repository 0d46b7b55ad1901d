// Files as people give them: in other encodings, under names a little off, behind links.
#include "io/files/given_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "io/config/config_file.h"
#include "io/files/text_encoding.h"
#include "message.h"
#include "temporary_folder.h"

namespace erg {

using io::file_trouble;
using io::nearest_path;
using io::parse_config;
using io::read_config;
using io::utf8_text;

namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// ASCII in units of `bytes`, the value at `place` in each.
std::string widened(const std::string& text, std::size_t bytes, std::size_t place) {
  std::string wide;
  for (const char c : text) {
    std::string unit(bytes, '\0');
    unit[place] = c;
    wide += unit;
  }
  return wide;
}

TEST(TextEncoding, OthersThanUtf8AreNamedWithWhatConvertsThem) {
  const std::string config = "{\"erg\": 1}\r\n";
  const std::vector<std::pair<std::string, std::string>> texts{{"\xff\xfe" + widened(config, 2, 0), "UTF-16"},
                                                               {"\xfe\xff" + widened(config, 2, 1), "UTF-16"},
                                                               {widened(config, 2, 0), "UTF-16LE"},
                                                               {widened(config, 2, 1), "UTF-16BE"},
                                                               {"\xff\xfe\0\0"s + widened(config, 4, 0), "UTF-32"},
                                                               {"\0\0\xfe\xff"s + widened(config, 4, 3), "UTF-32"},
                                                               {widened(config, 4, 0), "UTF-32LE"},
                                                               {widened(config, 4, 3), "UTF-32BE"}};
  for (const auto& [text, name] : texts) {
    EXPECT_EQ(message([&text = text] { utf8_text(text, "a.json"); }),
              "a.json: this text is " + name + ", not UTF-8; save it as UTF-8, or convert it: iconv -f " + name +
                  " -t UTF-8 IN > OUT");
  }
}

TEST(TextEncoding, Latin1IsNamedWithItsLine) {
  const std::string said = message([] { utf8_text("{\n\"erg\": 1,\n\"title\": \"D\xfcne\"}", "a.json"); });
  EXPECT_EQ(said,
            "a.json:3: this text is not UTF-8 (byte 0xFC); it looks like Latin-1 or Windows-1252; save it as UTF-8, or "
            "convert it: iconv -f WINDOWS-1252 -t UTF-8 IN > OUT");
}

TEST(TextEncoding, Utf8IsTakenWithAndWithoutItsMark) {
  for (const std::string& text : {""s, "{}"s, "D\xc3\xbcne \xe6\xb2\x99\xe4\xb8\x98 \xf0\x9f\x8f\x9c"s}) {
    EXPECT_EQ(utf8_text(text, "a"), text);
    EXPECT_EQ(utf8_text("\xef\xbb\xbf" + text, "a"), text);
  }
  // Too long, halves of pairs, beyond the last character, cut.
  for (const std::string& text :
       {"\xc0\x80"s, "\xe0\x80\x80"s, "\xed\xa0\x80"s, "\xf4\x90\x80\x80"s, "\xc3"s, "\x80"s}) {
    EXPECT_NE(message([&] { utf8_text(text, "a"); }), "no error");
  }
}

TEST(GivenFile, AConfigWithAMarkOfUtf8IsRead) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.json", "\xef\xbb\xbf{\"erg\": 1, \"model\": \"werner\"}");
  EXPECT_EQ(read_config(folder / "a.json").model, "werner");
}

/// A folder to be in while a test lasts.
class InFolder : public ::testing::Test {
 protected:
  InFolder() { fs::current_path(folder_.path()); }
  ~InFolder() override { fs::current_path(before_); }

  fs::path before_ = fs::current_path();
  TemporaryFolder folder_;
};

TEST_F(InFolder, APathALittleOffIsMetByTheOneThatIsThere) {
  fs::create_directories("Maps/north");
  write_bytes("Maps/north/Hills.png", "");
  for (const std::string off : {"maps/north/hills.PNG", "Maps\\north\\Hills.png", "maps\\North\\hills.png",
                                "/Maps/north/Hills.png", "Maps/nort/Hils.png"}) {
    const auto trouble = file_trouble(off, "picture");
    ASSERT_TRUE(trouble.has_value()) << off;
    EXPECT_EQ(trouble->remedy, "did you mean \"Maps/north/Hills.png\"?") << off;
  }
  const fs::path whole = folder_ / "Maps/north/Hills.png";
  EXPECT_EQ(nearest_path(whole.string().substr(1)), whole.string()) << "a slash is missing before it";
  EXPECT_EQ(nearest_path("Maps/north/quite_another_name.png"), "");
}

TEST_F(InFolder, FoldersAndLinksThatLeadNowhereAreCalledWhatTheyAre) {
  fs::create_directory("folder");
  fs::create_symlink("loop", "loop");
  fs::create_symlink("b", "a");
  fs::create_symlink("a", "b");
  fs::create_symlink("gone.png", "dangling");
  const auto problem = [](const char* path) {
    const auto trouble = file_trouble(path, "picture");
    return trouble ? trouble->problem + "; " + trouble->remedy : "none";
  };
  EXPECT_EQ(problem("folder"), "this is a folder; give the name of a picture");
  EXPECT_EQ(problem("loop"), "this is a link that leads back to itself; mend the link");
  EXPECT_EQ(problem("a"), "this is a link that leads back to itself; mend the link");
  EXPECT_EQ(problem("dangling"), "this is a link to \"gone.png\", and nothing is there; mend the link");
  write_bytes("gone.png", "");
  EXPECT_EQ(problem("dangling"), "none");
}

TEST_F(InFolder, APictureThatIsNotThereIsLookedForWhereItMayBeMeant) {
  fs::create_directory("configs");
  write_bytes("hills.png", "");
  const auto told = [](const std::string& image) {
    write_bytes("configs/a.json",
                R"({"erg": 1, "model": "werner", "scene": {"kind": "image", "image": ")" + image + "\"}}");
    return message([] { read_config("configs/a.json"); });
  };
  EXPECT_TRUE(holds(told("hills.png"), "relative to the config's folder: from there it is \"../hills.png\""));
  EXPECT_TRUE(holds(told("../Hills.PNG"), "did you mean \"hills.png\"?")) << told("../Hills.PNG");
  EXPECT_TRUE(holds(told("..\\\\hills.png"), "did you mean")) << told("..\\\\hills.png");
  EXPECT_TRUE(holds(told("../configs"), "this is a folder")) << told("../configs");
}

TEST(Comments, AreReadOverAndNotKept) {
  const TemporaryFolder folder;
  const std::string text =
      "// dunes\n{ /* the\nversion */ \"erg\": 1,\n\"title\": \"no // comment\", // a comment\n\"model\": "
      "\"werner\"/**/,\n"
      "\"grid\": {\"nx\": 12/* cells */, \"ny\": 0}}// end";
  EXPECT_EQ(message([&] { parse_config(text, "a.json"); }),
            "a.json:6: ny is 0; expected a whole number, 1 to 16384 cells")
      << "lines are counted through comments";
  write_bytes(folder / "a.json", text.substr(0, text.find(", \"ny\"")) + "}}");
  std::vector<std::string> notes;
  const sim::Config config = read_config(folder / "a.json", &notes);
  EXPECT_EQ(config.title, "no // comment");
  EXPECT_EQ(config.grid.integer("nx"), 12);
  EXPECT_EQ(notes,
            std::vector<std::string>{(folder / "a.json").string() + ": its comments are not kept in what is written"});
  notes.clear();
  io::write_config(folder / "b.json", config);
  EXPECT_EQ(read_config(folder / "b.json", &notes), config);
  EXPECT_TRUE(notes.empty()) << "a // in a text is no comment";
  EXPECT_TRUE(holds(message([] { parse_config("{\n# dunes\n\"erg\": 1}", "a.json"); }), "a comment begins with //"));
  EXPECT_TRUE(holds(message([] { parse_config("{\"erg\": 1 /* dunes", "a.json"); }), "syntax error"));
}

TEST(CellSize, InDegreesIsExplained) {
  for (const char* degrees : {"0.000277777778", "0.000833", "9.2592592592e-05"}) {
    const std::string said = message([&] {
      parse_config(R"({"erg": 1, "model": "werner", "grid": {"cell_size": )" + std::string(degrees) + "}}", "a.json");
    });
    EXPECT_TRUE(holds(said, "expected 0.001 to 1000 m")) << said;
    EXPECT_TRUE(holds(said, "in degrees")) << said;
  }
  const std::string said =
      message([] { parse_config(R"({"erg": 1, "model": "werner", "grid": {"cell_size": -3}})", "a.json"); });
  EXPECT_FALSE(holds(said, "degrees")) << said;
}

}  // namespace
}  // namespace erg
