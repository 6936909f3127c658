// Every rule finds its offence in an artificial file, and does not report a correct one.
#include "architecture/rules.hpp"

#include <gmock/gmock.h>

namespace riedel::architecture {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(RuleOnIncludes, FindsAnArrowThatRunsUpAndSaysWhere) {
  const SourceFile up{"core/base/types.hpp", "#pragma once\n#include \"core/state/grid.hpp\"\n"};
  EXPECT_THAT(includes_that_run_up(up), ElementsAre(HasSubstr("core/base/types.hpp:2: ")));
}

TEST(RuleOnIncludes, AllowsAnArrowThatRunsDownOrStaysInTheRoom) {
  const SourceFile down{"core/step/musl.cpp", "#include \"core/state/grid.hpp\"\n#include \"core/step/musl.hpp\"\n"};
  EXPECT_THAT(includes_that_run_up(down), IsEmpty());
}

TEST(RuleOnIncludes, KeepsEveryRoomFromThoseItMustNotSee) {
  const auto offences = [](const std::string& from, const std::string& to) {
    return includes_that_run_up({from + "/a.hpp", "#include \"" + to + "/b.hpp\"\n"});
  };
  const std::vector<std::pair<std::string, std::string>> forbidden = {
      {"core/base", "core/io"},
      {"core/state", "core/interface"},
      {"core/interface", "core/step"},
      {"core/step", "core/io"},
      {"core/step", "materials"},
      {"core/io", "apps"},
      {"core/io", "nonlocal"},
      {"shapefunctions", "core/step"},
      {"shapefunctions", "materials"},
      {"materials", "core/state"},
      {"materials", "core/step"},
      {"materials", "nonlocal"},
      {"nonlocal", "core/state"},
      {"nonlocal", "shapefunctions"},
      {"nonlocal", "core/io"},
      {"materials/kit", "materials"},
      {"materials", "materials/element"},
      {"materials/umat", "materials"},
      {"shapefunctions/kit", "shapefunctions"},
      {"nonlocal/kit", "nonlocal"},
  };
  for (const auto& [from, to] : forbidden) EXPECT_THAT(offences(from, to), SizeIs(1)) << from << " sees " << to;
}

TEST(RuleOnIncludes, TakesAFolderThatIsNoRoomForAPartOfTheOneAboveIt) {
  EXPECT_THAT(includes_that_run_up({"core/step/kernels/a.hpp", "#include \"core/step/b.hpp\"\n"}), IsEmpty());
  EXPECT_THAT(includes_that_run_up({"core/step/kernels/a.hpp", "#include \"core/io/b.hpp\"\n"}), SizeIs(1));
  EXPECT_THAT(includes_that_run_up({"materials/a.cpp", "#include \"materials/kit/b.hpp\"\n"}), IsEmpty());
}

TEST(RuleOnIncludes, LetsAppsAndTestsSeeEverything) {
  EXPECT_THAT(includes_that_run_up({"apps/biaxial/biaxial.cpp", "#include \"materials/register.hpp\"\n"}), IsEmpty());
  EXPECT_THAT(includes_that_run_up({"tests/core/test_grid.cpp", "#include \"apps/biaxial/specimen.hpp\"\n"}),
              IsEmpty());
}

TEST(RuleOnIncludes, KeepsTheFoldersOfAppsApart) {
  const auto offences = [](const std::string& from, const std::string& to) {
    return includes_of_other_apps({from, "#include \"" + to + "\"\n"});
  };
  EXPECT_THAT(offences("apps/reproduce/figures.cpp", "apps/element/pictures.hpp"), SizeIs(1));
  EXPECT_THAT(offences("apps/element/incremental/a.cpp", "apps/biaxial/keys.hpp"), SizeIs(1));
  EXPECT_THAT(offences("apps/element/incremental/a.cpp", "apps/element/path.hpp"), IsEmpty());
  EXPECT_THAT(offences("apps/reproduce/figures.cpp", "apps/kinds.hpp"), IsEmpty());
  EXPECT_THAT(offences("apps/kinds.cpp", "apps/biaxial/keys.hpp"), IsEmpty());
}

TEST(RuleOnIncludes, FindsANameThatDoesNotStartAtTheTopOfTheTree) {
  EXPECT_THAT(includes_that_run_up({"core/base/types.hpp", "#include \"error.hpp\"\n"}), SizeIs(1));
}

TEST(RuleOnIncludes, FindsAFileInAnUnknownRoom) {
  EXPECT_THAT(includes_that_run_up({"core/cellar/wine.hpp", ""}), SizeIs(1));
}

TEST(RuleOnCircles, FindsTwoFilesThatIncludeEachOther) {
  const SourceFile a{"core/base/a.hpp", "#include \"core/base/b.hpp\"\n"};
  const SourceFile b{"core/base/b.hpp", "#include \"core/base/a.hpp\"\n"};
  const SourceFile above{"core/base/above.hpp", "#include \"core/base/a.hpp\"\n"};
  const SourceFile below{"core/base/below.hpp", ""};
  EXPECT_THAT(circles_of_includes({a, b, above, below}), ElementsAre(HasSubstr("a.hpp"), HasSubstr("b.hpp")));
}

TEST(RuleOnCircles, AllowsTwoWaysToTheSameFile) {
  const SourceFile a{"a/a.hpp", "#include \"a/b.hpp\"\n#include \"a/c.hpp\"\n"};
  const SourceFile b{"a/b.hpp", "#include \"a/c.hpp\"\n"};
  EXPECT_THAT(circles_of_includes({a, b, {"a/c.hpp", ""}}), IsEmpty());
}

TEST(RuleOnLibraries, FindsEachLibraryOutsideItsFiles) {
  const auto offences = [](const std::string& path, const std::string& header) {
    return libraries_out_of_place({path, "#include <" + header + ">\n"});
  };
  EXPECT_THAT(offences("nonlocal/cell_list.cpp", "CGAL/Kd_tree.h"), SizeIs(1));
  EXPECT_THAT(offences("core/io/vtk_writer.hpp", "vtkPoints.h"), SizeIs(1));
  EXPECT_THAT(offences("apps/biaxial/biaxial.cpp", "toml++/toml.h"), SizeIs(1));
  EXPECT_THAT(offences("core/case/case_file.cpp", "boost/program_options.hpp"), SizeIs(1));
  EXPECT_THAT(offences("apps/command_line.hpp", "boost/program_options.hpp"), SizeIs(1));
}

TEST(RuleOnLibraries, AllowsEachLibraryInItsFiles) {
  const auto offences = [](const std::string& path, const std::string& header) {
    return libraries_out_of_place({path, "#include <" + header + ">\n"});
  };
  EXPECT_THAT(offences("nonlocal/cgal_kd_tree.cpp", "CGAL/Kd_tree.h"), IsEmpty());
  EXPECT_THAT(offences("core/draw/picture.cpp", "vtkImageData.h"), IsEmpty());
  EXPECT_THAT(offences("core/case/toml_reader.cpp", "toml++/toml.h"), IsEmpty());
  EXPECT_THAT(offences("core/io/plugin_loader.cpp", "boost/dll.hpp"), IsEmpty());
  EXPECT_THAT(offences("tests/core/test_vtk.cpp", "vtkPoints.h"), IsEmpty());
}

TEST(RuleOnNames, TakesTheDistinctWordsOfTheFilesAndQuotesEverydayOnes) {
  const std::vector<SourceFile> files = {{"materials/sand_castle.hpp", ""},
                                         {"materials/register.cpp", ""},
                                         {"shapefunctions/linear.hpp", ""},
                                         {"core/base/types.hpp", ""},
                                         {"shapefunctions/kit/tensor_product.hpp", ""}};
  EXPECT_THAT(names_of_plugged_in(files), ElementsAre("\"linear\"", "castle", "sand"));
}

TEST(RuleOnNames, FindsANameInCoreInCodeAndInComments) {
  const auto offences = [](const std::string& text) {
    return names_in_core({"core/step/musl.cpp", text}, {"castle", "\"linear\""});
  };
  EXPECT_THAT(offences("// as in Castle (1996)\n"), SizeIs(1));
  EXPECT_THAT(offences("SandCastle law;\n"), SizeIs(1));
  EXPECT_THAT(offences("sand_castle(x);\n"), SizeIs(1));
  EXPECT_THAT(offences("scheme = \"linear\";\n"), SizeIs(1));
}

TEST(RuleOnNames, AllowsOtherWordsAndOtherRooms) {
  EXPECT_THAT(names_in_core({"core/step/musl.cpp", "linear momentum of castles"}, {"castle", "\"linear\""}), IsEmpty());
  EXPECT_THAT(names_in_core({"apps/biaxial/biaxial.cpp", "castle"}, {"castle"}), IsEmpty());
}

TEST(RuleOnLength, FindsALineTooMany) {
  EXPECT_THAT(files_too_long({"core/base/a.hpp", std::string(141, '\n')}), SizeIs(1));
  EXPECT_THAT(files_too_long({"core/base/a.cpp", std::string(281, '\n')}), SizeIs(1));
  EXPECT_THAT(files_too_long({"core/base/a.hpp", std::string(140, '\n')}), IsEmpty());
  EXPECT_THAT(files_too_long({"core/base/a.cpp", std::string(280, '\n')}), IsEmpty());
}

// Written in halves, so that the rules find nothing to complain about in this file.
TEST(RuleOnUnfinishedWork, FindsEveryKindOfNote) {
  const std::vector<std::pair<std::string, std::string>> halves = {
      {"TO", "DO"}, {"FIX", "ME"}, {"XX", "X"}, {"HA", "CK"}};
  for (const auto& [first, second] : halves)
    EXPECT_THAT(unfinished_work({"a/a.hpp", "// " + first + second + ": later\n"}), SizeIs(1)) << first + second;
  EXPECT_THAT(unfinished_work({"a/a.hpp", "// nothing to do\n"}), IsEmpty());
}

TEST(RuleOnPaths, FindsAnAbsolutePathButNoRelativeOne) {
  const std::string root = "/"; // apart from what follows it, so that the rules find nothing in this file
  EXPECT_THAT(paths_of_a_machine({"a/a.cpp", "open(\"" + root + "home/ann/case.toml\");\n"}), SizeIs(1));
  EXPECT_THAT(paths_of_a_machine({"a/a.cpp", "// see " + root + "work/notes\n"}), SizeIs(1));
  EXPECT_THAT(paths_of_a_machine({"a/a.cpp", "open(\"cases/usr/case.toml\"); x = a/opt/b;\n"}), IsEmpty());
}

} // namespace
} // namespace riedel::architecture
