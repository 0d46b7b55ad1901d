#include "io/checkpoint/checkpoint.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>
#include <limits>

#include "core/errors.h"
#include "core/random.h"
#include "limits.h"
#include "message.h"
#include "temporary_folder.h"

namespace erg {

using io::read_checkpoint;
using io::Saved;
using io::write_checkpoint;
using sim::Config;
using sim::RunState;

namespace {

Config small_config() {
  Config config;
  config.title = "Zwölf Dünen";
  config.grid.set("nx", std::int64_t{9});
  config.grid.set("ny", std::int64_t{7});
  config.grid.set("boundary", std::string("open"));
  config.run.set("seed", std::int64_t{42});
  return config;
}

RunState some_state() {
  RunState state;
  state.terrain = Terrain({9, 7}, 1.0, 1.0 / 3, Boundary::open);
  state.terrain.set_inflow(0.25);
  for (std::size_t cell = 0; cell < 63; ++cell) {
    state.terrain.edit_mobile()[cell] = static_cast<std::int32_t>(random_below({3, 1}, 0, cell, 0, 20));
    state.terrain.edit_bedrock()[cell] = -static_cast<std::int32_t>(cell);
  }
  Field plants{{"grass", "Grass", "", -0.5, 1.5, "vegetation", "cover of grass"}, Grid<float>({9, 7}, 0.1f)};
  plants.values(4, 4) = 0.7f;
  state.terrain.edit_fields().push_back(plants);
  state.terrain.open_ledger();
  state.terrain.ledger().in += 5;
  state.terrain.ledger().out += 5;
  state.step = 123456789012;
  state.totals = {1000, 900, 12345.75, 5, 5, true, "frozen on day 98"};
  return state;
}

std::string saved_bytes(const TemporaryFolder& folder) {
  write_checkpoint(folder / "a.erg", small_config(), some_state());
  return read_bytes(folder / "a.erg");
}

// Puts the right checksum at the end, so that what lies behind it is tested.
std::string with_checksum(std::string bytes) {
  const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
  const auto crc = static_cast<std::uint32_t>(crc32(crc32(0, nullptr, 0), data, static_cast<uInt>(bytes.size() - 4)));
  std::memcpy(bytes.data() + bytes.size() - 4, &crc, 4);
  return bytes;
}

std::string refusal(const TemporaryFolder& folder, const std::string& bytes) {
  write_bytes(folder / "b.erg", bytes);
  return message([&] { read_checkpoint(folder / "b.erg"); });
}

TEST(Checkpoint, ComesBackWhole) {
  const TemporaryFolder folder;
  saved_bytes(folder);
  const Saved saved = read_checkpoint(folder / "a.erg");
  const RunState state = some_state();
  EXPECT_EQ(saved.config, small_config());
  EXPECT_EQ(saved.state.step, state.step);
  EXPECT_EQ(saved.state.totals.polls, 1000);
  EXPECT_EQ(saved.state.totals.lifts, 900);
  EXPECT_EQ(saved.state.totals.travel, 12345.75);
  EXPECT_TRUE(saved.state.totals.finished);
  EXPECT_EQ(saved.state.totals.why_finished, "frozen on day 98");
  EXPECT_EQ(saved.state.terrain.ledger(), state.terrain.ledger());
  EXPECT_EQ(saved.state.terrain.bedrock(), state.terrain.bedrock());
  EXPECT_EQ(saved.state.terrain.mobile(), state.terrain.mobile());
  EXPECT_EQ(saved.state.terrain.boundary(), Boundary::open);
  EXPECT_EQ(saved.state.terrain.inflow(), 0.25);
  EXPECT_EQ(saved.state.terrain.quantum(), 1.0 / 3);
  ASSERT_EQ(saved.state.terrain.fields().size(), 1u);
  EXPECT_EQ(saved.state.terrain.fields()[0].values, state.terrain.fields()[0].values);
  EXPECT_EQ(saved.state.terrain.fields()[0].info.key, "grass");
  EXPECT_EQ(saved.state.terrain.fields()[0].info.minimum, -0.5);
  EXPECT_EQ(state_hash(saved.state.terrain), state_hash(state.terrain));
}

TEST(Checkpoint, CutFilesAreRefused) {
  const TemporaryFolder folder;
  const std::string bytes = saved_bytes(folder);
  for (std::size_t length = 0; length < bytes.size(); length += 3) {
    EXPECT_NE(refusal(folder, bytes.substr(0, length)), "no error") << length;
  }
}

TEST(Checkpoint, AChangedByteIsRefused) {
  const TemporaryFolder folder;
  const std::string bytes = saved_bytes(folder);
  for (std::size_t place = 0; place < bytes.size(); place += 3) {
    std::string changed = bytes;
    changed[place] = static_cast<char>(changed[place] ^ 0x10);
    EXPECT_NE(refusal(folder, changed), "no error") << place;
  }
}

// A file with a right checksum is no friend either: no length in it may allocate more than the file holds.
TEST(Checkpoint, WrongLengthsUnderARightChecksumAreRefused) {
  const TemporaryFolder folder;
  const std::string bytes = saved_bytes(folder);
  const std::uint64_t huge = std::numeric_limits<std::uint64_t>::max() / 2;
  for (std::size_t place = 12; place + 12 < bytes.size(); place += 5) {
    std::string changed = bytes;
    std::memcpy(changed.data() + place, &huge, sizeof huge);
    write_bytes(folder / "b.erg", with_checksum(changed));
    try {
      const Saved saved = read_checkpoint(folder / "b.erg");  // a number was hit, which may be anything
      EXPECT_EQ(saved.state.terrain.total_mobile(), saved.state.terrain.ledger().expected());
    } catch (const InputError&) {
      SUCCEED();
    }
  }
}

TEST(Checkpoint, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string bytes = saved_bytes(folder);
  EXPECT_NE(refusal(folder, "").find("no checkpoint"), std::string::npos);
  EXPECT_NE(refusal(folder, std::string(500, 'x')).find("no checkpoint"), std::string::npos);
  EXPECT_NE(refusal(folder, bytes.substr(0, bytes.size() - 9)).find("checksum"), std::string::npos);
  EXPECT_NE(refusal(folder, with_checksum(bytes + "more")).find("follows its end"), std::string::npos);
  std::string newer = bytes;
  newer[8] = 2;
  EXPECT_NE(refusal(folder, with_checksum(newer)).find("newer erg"), std::string::npos);
  EXPECT_THROW(read_checkpoint(folder / "absent.erg"), InputError);
  EXPECT_THROW(read_checkpoint(folder.path()), InputError);
}

TEST(Checkpoint, SandThatDoesNotAddUpIsRefused) {
  const TemporaryFolder folder;
  RunState state = some_state();
  state.terrain.edit_mobile()[0] += 1;
  write_checkpoint(folder / "c.erg", small_config(), state);
  EXPECT_THROW(read_checkpoint(folder / "c.erg"), InputError);
}

#if !defined(ERG_SANITIZE_ADDRESS) && !defined(ERG_SANITIZE_THREAD)  // these take memory of their own

TEST(Checkpoint, OneWhoseRunWouldNotFitIsRefusedBeforeItsLayersAreRead) {
  const TemporaryFolder folder;
  saved_bytes(folder);
  const test::LimitRestored restored(RLIMIT_AS);
  test::limit_memory(rlim_t{64} << 20);
  const std::string said = message([&] { read_checkpoint(folder / "a.erg"); });
  EXPECT_TRUE(said.starts_with("grid: 9 x 7 cells need ")) << said;
}

#endif

TEST(Checkpoint, AnUnwritablePlaceIsAnInputError) {
  EXPECT_THROW(write_checkpoint("/no/such/folder/a.erg", small_config(), some_state()), InputError);
}

}  // namespace
}  // namespace erg
