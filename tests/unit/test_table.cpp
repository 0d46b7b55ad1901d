#include "io/formats/table.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/errors.h"
#include "temporary_folder.h"

namespace erg {

using io::TableFile;

namespace {

const io::Provenance origin{"{\n  \"title\": \"a\"\n}\n", 3, 0, "werner", "1.0", "cpu"};

std::string without_comments(const std::string& text) {
  std::string rows;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start) + 1;
    if (text[start] != '#') rows += text.substr(start, end - start);
    start = end;
  }
  return rows;
}

TEST(Table, HasCommentsOneHeaderAndExactNumbers) {
  const TemporaryFolder folder;
  TableFile table(folder / "t.csv", {"step", "height"}, origin);
  table.add(std::array{0.0, 0.1});
  table.add(std::array{10.0, 1.0 / 3});
  table.add(std::array{20.0, std::nan("")});
  const std::string text = read_bytes(folder / "t.csv");  // each row is there before the table is closed
  EXPECT_EQ(without_comments(text), "step,height\n0,0.1\n10,0.3333333333333333\n20,\n");
  EXPECT_TRUE(text.starts_with("# erg:version: 1.0\n# erg:model: werner\n# erg:seed: 3\n"));
  EXPECT_NE(text.find("\n#   \"title\": \"a\"\n"), std::string::npos);
}

TEST(Table, AResumedRunGoesOnWithoutDoubleRows) {
  const TemporaryFolder folder;
  {
    TableFile table(folder / "t.csv", {"step", "height"}, origin);
    for (const double step : {0.0, 10.0, 20.0, 30.0}) table.add(std::array{step, 1.0});
  }
  TableFile table = TableFile::resume(folder / "t.csv", {"step", "height"}, origin, 20);
  EXPECT_EQ(table.last(), 10);
  table.add(std::array{20.0, 2.0});
  EXPECT_EQ(without_comments(read_bytes(folder / "t.csv")), "step,height\n0,1\n10,1\n20,2\n");
}

TEST(Table, RowsThatAreNotWholeAreDroppedOnResuming) {
  const TemporaryFolder folder;
  { TableFile(folder / "t.csv", {"step", "height"}, origin).add(std::array{0.0, 1.0}); }
  // What a full disk left of "10,1.25" and of "120,1".
  write_bytes(folder / "t.csv", read_bytes(folder / "t.csv") + "10\n12,1.2");
  TableFile::resume(folder / "t.csv", {"step", "height"}, origin, 120).add(std::array{120.0, 2.0});
  EXPECT_EQ(without_comments(read_bytes(folder / "t.csv")), "step,height\n0,1\n120,2\n");
}

TEST(Table, ResumingWithoutAFileStartsOne) {
  const TemporaryFolder folder;
  TableFile::resume(folder / "t.csv", {"step"}, origin, 5).add(std::array{5.0});
  EXPECT_EQ(without_comments(read_bytes(folder / "t.csv")), "step\n5\n");
}

TEST(Table, OtherColumnsAreRefused) {
  const TemporaryFolder folder;
  TableFile table(folder / "t.csv", {"step", "height"}, origin);
  EXPECT_THROW(TableFile::resume(folder / "t.csv", {"step", "width"}, origin, 0), InputError);
  EXPECT_THROW(TableFile("/no/such/folder/t.csv", {"step"}, origin), InputError);
  EXPECT_THROW(table.add(std::array{1.0}), std::logic_error);
}

}  // namespace
}  // namespace erg
