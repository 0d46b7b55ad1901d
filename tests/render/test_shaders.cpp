// Shaders that are wrong or missing say where.
#include <gtest/gtest.h>

#include <fstream>

#include "../unit/temporary_folder.h"
#include "core/errors.h"
#include "render/gl_context.h"
#include "render/shader_program.h"
#include "scene.h"

namespace erg::test {

using render::has_osmesa;
using render::make_offscreen_context;

namespace {

class Shaders : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_.path() / name) << text; }

  std::vector<Mistake> mistakes() const {
    try {
      render::ShaderProgram(folder_.path(), "a.vert", "a.frag");
    } catch (const InputError& error) {
      return error.mistakes();
    }
    return {};
  }

  TemporaryFolder folder_;
  std::unique_ptr<render::GlContext> context_ = make_offscreen_context(usual_context());
  const std::string vertex_ = "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n";
};

TEST_F(Shaders, AMistakeIsReportedWithFileLineAndMessage) {
  write("a.vert", vertex_);
  write("a.frag", "#version 330 core\nout vec4 colour;\nvoid main() {\n  colour = vec4(wetness);\n}\n");
  const std::vector<Mistake> found = mistakes();
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].place, (folder_.path() / "a.frag").string() + ":4");
  EXPECT_NE(found[0].problem.find("wetness"), std::string::npos) << found[0].problem;
}

TEST_F(Shaders, AMistakeInAnIncludeIsReportedThere) {
  write("a.vert", vertex_);
  write("a.frag",
        "#version 330 core\nout vec4 colour;\n#include \"b.glsl\"\nvoid main() {\n  colour = vec4(b());\n}\n");
  write("b.glsl", "// b\n\nfloat b() {\n  return missing_word;\n}\n");
  std::vector<Mistake> found = mistakes();
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].place, (folder_.path() / "b.glsl").string() + ":4");
  // Lines after an include keep their numbers.
  write("b.glsl", "float b() { return 1.0; }\n");
  EXPECT_TRUE(mistakes().empty());
  write("a.frag",
        "#version 330 core\nout vec4 colour;\n#include \"b.glsl\"\nvoid main() {\n  colour = vec4(c());\n}\n");
  found = mistakes();
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].place, (folder_.path() / "a.frag").string() + ":5");
}

TEST_F(Shaders, AMissingFileIsNamed) {
  write("a.vert", vertex_);
  write("a.frag", "#version 330 core\n#include \"nowhere.glsl\"\n");
  const std::vector<Mistake> found = mistakes();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].place, (folder_.path() / "a.frag").string() + ":2");
  EXPECT_NE(found[0].problem.find("nowhere.glsl"), std::string::npos);
}

TEST(Contexts, AWrongKindNamesTheRightOnes) {
  try {
    make_offscreen_context("osmessa");
    FAIL() << "made";
  } catch (const InputError& error) {
    EXPECT_NE(error.mistakes().front().text().find("did you mean \"osmesa\""), std::string::npos);
  }
}

TEST(Contexts, SayWhatDraws) {
  const auto context = make_offscreen_context(usual_context());
  EXPECT_EQ(context->kind(), usual_context());
  EXPECT_NE(context->renderer(), "");
  EXPECT_TRUE(context->is_software() || !has_osmesa()) << context->renderer();
}

TEST(Contexts, OsmesaDrawsOrSaysThatItIsNotHere) {
  try {
    EXPECT_EQ(make_offscreen_context("osmesa")->kind(), "osmesa");
    EXPECT_TRUE(has_osmesa());
  } catch (const InputError& error) {
    EXPECT_FALSE(has_osmesa()) << error.what();
    EXPECT_NE(error.mistakes().front().text().find("built without it"), std::string::npos) << error.what();
  }
  EXPECT_EQ(make_offscreen_context("auto")->kind(), "egl");
}

}  // namespace
}  // namespace erg::test
