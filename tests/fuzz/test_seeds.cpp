/// Every input that a reader once failed on, and a few plain ones, read again.
#include "fuzz/targets.hpp"
#include "temporary_folder.hpp"

namespace riedel::fuzz {
namespace {

class Readers : public testing::TestWithParam<Target> {};

TEST_P(Readers, TakeOrRefuseEverySeed) {
  int seeds = 0;
  const std::filesystem::path folder = std::filesystem::path(SOURCE_DIR) / "tests/fuzz/seeds" / GetParam().name;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    ++seeds;
    EXPECT_NO_THROW(GetParam().read(file_content(entry.path()))) << entry.path();
  }
  EXPECT_GT(seeds, 0);
}

INSTANTIATE_TEST_SUITE_P(OfWhatIsNotOurs, Readers, testing::ValuesIn(targets),
                         [](const auto& reader) { return std::string(reader.param.name); });

} // namespace
} // namespace riedel::fuzz
