// The commands that run nothing: what they print is derived from the declarations.
#include <gtest/gtest.h>

#include <cstdlib>

#include "program.h"

namespace erg::test {
namespace {

TEST(Commands, ModelsListsEveryModelAndModelItsParameters) {
  const ScratchFolder folder;
  const Ended models = run_erg(folder, {"models"});
  EXPECT_EQ(models.exit_code, 0);
  for (const std::string key : {"werner", "momiji", "bishop"}) {
    EXPECT_NE(models.output.find("\n" + key), std::string::npos) << models.output;
    const Ended model = run_erg(folder, {"model", key});
    EXPECT_EQ(model.exit_code, 0);
    EXPECT_NE(model.output.find("\np_sand "), std::string::npos) << model.output;
  }
  EXPECT_EQ(run_erg(folder, {"model", "wernr"}).exit_code, 2);
}

TEST(Commands, AModelIsExplainedForTheCellsThatItStartsWith) {
  const ScratchFolder folder;
  EXPECT_NE(run_erg(folder, {"model", "grains"}).output.find("cells of 0.01 m"), std::string::npos);
  EXPECT_NE(run_erg(folder, {"model", "werner"}).output.find("cells of 1 m"), std::string::npos);
}

TEST(Commands, ManualPagesAreWhatTheProgramPrints) {
  const ScratchFolder folder;
  for (const std::string key :
       {"werner", "momiji", "bishop", "nield_baas", "snow_packing", "snow_sintering", "grains"}) {
    const Ended page = run_erg(folder, {"model", key, "--markdown"});
    ASSERT_EQ(page.exit_code, 0);
    const std::string row = key == "grains"           ? "| splash | 4 | 0 to 100 |"
                            : key == "snow_sintering" ? "| slab_height | "
                                                      : "| p_sand | 0.6 | 0 to 1 |";
    EXPECT_NE(page.output.find(row), std::string::npos) << page.output;
    const std::string committed = read_bytes(std::string(ERG_SOURCE_DIR) + "/docs/models/" + key + ".md");
    EXPECT_NE(committed.find(page.output), std::string::npos)
        << "docs/models/" << key << ".md is out of date: run `erg model " << key << " --markdown`";
  }
}

TEST(Commands, AStartLoadsNoRasteriserAndNoCompiler) {
  const ScratchFolder folder;
  // The loader lists what it would load, and runs nothing.
  const Ended listed = run_erg(folder, {"--version"}, [] { ::setenv("LD_TRACE_LOADED_OBJECTS", "1", 1); });
  EXPECT_NE(listed.output.find("libc.so"), std::string::npos) << listed.output;
  for (const char* const large : {"OSMesa", "LLVM", "_dri"}) {
    EXPECT_EQ(listed.output.find(large), std::string::npos) << listed.output;
  }
}

TEST(Commands, EveryPresetIsGood) {
  const ScratchFolder folder;
  const Ended presets = run_erg(folder, {"presets"});
  ASSERT_EQ(presets.exit_code, 0) << presets.errors;
  int checked = 0;
  const std::filesystem::path source = std::filesystem::path(ERG_SOURCE_DIR) / "cfg";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source)) {
    if (entry.path().extension() != ".json") continue;
    const std::string name = entry.path().lexically_relative(source).replace_extension().generic_string();
    EXPECT_NE(presets.output.find("\n" + name + " "), std::string::npos) << name << " is not listed";
    const Ended check = run_erg(folder, {"check", name});
    EXPECT_EQ(check.exit_code, 0) << check.errors;
    ++checked;
  }
  EXPECT_GE(checked, 10);
}

TEST(Commands, SchemaIsJson) {
  const ScratchFolder folder;
  const Ended schema = run_erg(folder, {"schema"});
  ASSERT_EQ(schema.exit_code, 0);
  EXPECT_TRUE(nlohmann::json::parse(schema.output).is_object());
  EXPECT_TRUE(schema.output.ends_with("}\n"));
}

TEST(Commands, ValidatePrintsTheSectionAskedFor) {
  const ScratchFolder folder;
  const Ended section = run_erg(folder, {"validate", "--section", "identities"});
  ASSERT_EQ(section.exit_code, 0) << section.errors;
  EXPECT_EQ(section.output.find("## Identities\n"), 0u) << section.output;
  EXPECT_EQ(section.output.find("\n## "), std::string::npos) << "no other section";
  EXPECT_EQ(run_erg(folder, {"validate", "--section", "identity"}).exit_code, 2);
  EXPECT_EQ(run_erg(folder, {"validate", "--scene", "snow_ripples"}).exit_code, 2) << "a row of which section";
  const Ended other = run_erg(folder, {"validate", "--section", "identities", "--scene", "snow_ripples"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_EQ(other.errors, "--scene snow_ripples: is a row of the section published; add --section published\n");
  EXPECT_EQ(run_erg(folder, {"validate", "--law", "ripples"}).errors,
            "--law ripples: is a table of the section nature; add --section nature\n");
  EXPECT_EQ(run_erg(folder, {"validate", "--section", "nature", "--law", "gravity"}).exit_code, 2);
}

TEST(Commands, ValidateReplacesTheSectionAskedForInAPage) {
  const ScratchFolder folder;
  const std::string identities = run_erg(folder, {"validate", "--section", "identities"}).output;
  const std::string before = "# Validation\n\n## Sand\n\nkept\n\n";
  const std::string after = "\n## Snow\n\nkept too\n";
  folder.write("page.md", before + "## Identities\n\nold\n\n### with a part\n\nold\n" + after);
  ASSERT_EQ(run_erg(folder, {"validate", "--section", "identities", "--out", "page.md"}).exit_code, 0);
  EXPECT_EQ(read_bytes(folder / "page.md"), before + identities + after);
  folder.write("page.md", "# Validation\n");
  ASSERT_EQ(run_erg(folder, {"validate", "--section", "identities", "--out", "page.md"}).exit_code, 0);
  EXPECT_EQ(read_bytes(folder / "page.md"), "# Validation\n\n" + identities) << "added where it is missing";
  ASSERT_EQ(run_erg(folder, {"validate", "--section", "identities", "--out", "new.md"}).exit_code, 0);
  EXPECT_EQ(read_bytes(folder / "new.md"), identities);
}

TEST(Commands, BenchWritesARowForEachExecutor) {
  const ScratchFolder folder;
  const Ended bench =
      run_erg(folder, {"bench", "--grid", "64", "--model", "werner", "--threads", "2", "--sweeps", "8", "--json"});
  ASSERT_EQ(bench.exit_code, 0) << bench.errors;
  const nlohmann::json rows = nlohmann::json::parse(bench.output);
  std::string cpu_hash;
  int serial_rows = 0;
  int cpu_rows = 0;
  for (const nlohmann::json& row : rows) {
    EXPECT_EQ(row.at("model"), "werner");
    EXPECT_EQ(row.at("nx"), 64);
    EXPECT_EQ(row.at("ny"), 64);
    EXPECT_GT(row.at("polls_per_second"), 0);
    serial_rows += row.at("executor") == "serial" ? 1 : 0;
    if (row.at("executor") != "cpu") continue;
    EXPECT_EQ(row.at("sweeps"), 8);
    if (row.at("scene") != "dunes") continue;
    ++cpu_rows;
    if (cpu_hash.empty()) cpu_hash = row.at("state_hash");
    EXPECT_EQ(row.at("state_hash"), cpu_hash) << "one and two threads give the same bits";
  }
  EXPECT_EQ(cpu_rows, 2);
  EXPECT_EQ(serial_rows, 4) << "straight wind, swinging wind, oblique wind, obstacles";
}

TEST(Commands, BenchSplitsAFrameIntoItsParts) {
  const ScratchFolder folder;
  const Ended bench = run_erg(folder, {"bench", "--frames", "--grid", "64"});
  ASSERT_EQ(bench.exit_code, 0) << bench.errors;
  for (const std::string part : {"settling", "copying", "ranges", "reading", "comparing", "uploading", "whole"}) {
    EXPECT_NE(bench.output.find(part), std::string::npos) << bench.output;
  }
  EXPECT_NE(bench.output.find("\n64  "), std::string::npos) << bench.output;
}

}  // namespace
}  // namespace erg::test
