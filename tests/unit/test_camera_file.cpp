#include "io/formats/camera_file.h"

#include <gtest/gtest.h>

#include "core/errors.h"
#include "temporary_folder.h"

namespace erg::test {

using io::parse_camera;
using io::read_camera;

namespace {

TEST(CameraFile, ComesBackAsItWas) {
  const TemporaryFolder folder;
  const picture::Camera camera{.target = {1.25, -3, 4e3},
                               .bearing = 359.5,
                               .altitude = -12,
                               .distance = 77.125,
                               .opening = 50,
                               .orthographic = true};
  io::write_camera(folder.path() / "view.json", camera);
  EXPECT_EQ(read_camera(folder.path() / "view.json"), camera);
}

TEST(CameraFile, EveryMistakeIsReportedWithItsLine) {
  try {
    parse_camera("{\n\"target\": [1, 2],\n\"bearng\": 10,\n\"opening\": 500\n}", "view.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.mistakes().size(), 4u);
    EXPECT_EQ(error.mistakes()[0].place, "view.json:2");
    EXPECT_EQ(error.mistakes()[1].place, "view.json:3");
    EXPECT_NE(error.mistakes()[1].text().find("did you mean \"bearing\""), std::string::npos);
    EXPECT_EQ(error.mistakes()[2].place, "view.json:4");
    EXPECT_NE(error.mistakes()[3].problem.find("\"distance\" is missing"), std::string::npos);
  }
}

TEST(CameraFile, AnythingElseIsRefused) {
  EXPECT_THROW(parse_camera("[1]", "a"), InputError);
  EXPECT_THROW(parse_camera("{", "a"), InputError);
  EXPECT_THROW(parse_camera("", "a"), InputError);
  EXPECT_THROW(read_camera("/nowhere/view.json"), InputError);
  EXPECT_THROW(read_camera("/dev/zero"), InputError) << "it has no end";
}

}  // namespace
}  // namespace erg::test
