// The architecture rules, applied to the project itself.
#include "architecture/rules.hpp"

#include <algorithm>
#include <gmock/gmock.h>

namespace riedel::architecture {
namespace {

using testing::IsEmpty;

const std::vector<SourceFile>& house() {
  static const std::vector<SourceFile> files = read_tree(SOURCE_DIR);
  return files;
}

/// The offences that `rule` finds in all files together.
template <class Rule>
Offences offences(const Rule& rule) {
  Offences all;
  for (const SourceFile& file : house())
    for (const std::string& offence : rule(file)) all.push_back(offence);
  return all;
}

TEST(House, IsRead) {
  const auto holds = [](const std::string& path) {
    return std::ranges::any_of(house(), [&](const SourceFile& f) { return f.path == path && !f.text.empty(); });
  };
  EXPECT_TRUE(holds("core/base/types.hpp"));
  EXPECT_TRUE(holds("tests/architecture/test_includes.cpp"));
}

TEST(House, HasIncludesThatRunDownOnly) { EXPECT_THAT(offences(includes_that_run_up), IsEmpty()); }

TEST(House, HasAppsThatKnowNothingOfOneAnother) { EXPECT_THAT(offences(includes_of_other_apps), IsEmpty()); }

TEST(House, HasNoCircleOfIncludes) { EXPECT_THAT(circles_of_includes(house()), IsEmpty()); }

TEST(House, KeepsEveryLibraryInItsFiles) { EXPECT_THAT(offences(libraries_out_of_place), IsEmpty()); }

TEST(House, NamesNoSchemeAndNoLawInCore) {
  const std::vector<std::string> names = names_of_plugged_in(house());
  EXPECT_THAT(names, testing::Not(IsEmpty()));
  EXPECT_THAT(offences([&](const SourceFile& file) { return names_in_core(file, names); }), IsEmpty());
}

TEST(House, KnowsAKindOfBoundaryConditionInItsPairOfFilesAndTheRegisterAlone) {
  EXPECT_THAT(offences([](const SourceFile& file) { return kinds_of_boundaries_known(file, house()); }), IsEmpty());
  for (const std::string name : {"prescribed_velocity", "rigid_body", "friction_wall"})
    EXPECT_THAT(kinds_of_boundaries_known(
                    {"core/step/musl.cpp", "#include \"core/step/boundaries/" + name + ".hpp\"\n"}, house()),
                testing::SizeIs(1));
}

TEST(House, HasShortFiles) { EXPECT_THAT(offences(files_too_long), IsEmpty()); }

TEST(House, HasNoUnfinishedWork) { EXPECT_THAT(offences(unfinished_work), IsEmpty()); }

TEST(House, NamesNoPathOfAMachine) { EXPECT_THAT(offences(paths_of_a_machine), IsEmpty()); }

} // namespace
} // namespace riedel::architecture
