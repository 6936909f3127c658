#include "core/case/case_file.hpp"
#include "core/case/case_text.hpp"
#include "temporary_folder.hpp"

#include <gmock/gmock.h>

using namespace riedel;
using testing::HasSubstr;

namespace {
Keys keys() {
  return {{"specimen.width", 0.04, "m", {}, "width of the specimen"},
          {"scheme", "gimp", "", {}, "interpolation", {"gimp", "cpdi"}},
          {"material.model", "x", "", {}, "law"},
          {"specimen.cells", std::vector<std::int64_t>{24, 84}, "-", {}, "two\nlines"},
          {"specimen.size", std::vector<double>{1.0, 2.0}, "m", {}, "size"},
          {"time.step", "auto", "s", {}, "step", {"auto"}},
          {"output.vtk", true, "", {}, "write"}};
}
Values read_back(const std::string& text) {
  return CaseFile::read(TemporaryFolder().file("case.toml", text)).validate(keys());
}
} // namespace

TEST(CaseText, ReadsBackToTheSameBits) {
  for (const double x :
       {0.1 + 0.2, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, 1e22, 50e3, -0.0, 123456789012345680.0}) {
    Values values(keys());
    values.set("specimen.width", x);
    values.set("specimen.size", std::vector<double>{x, 1e-5});
    values.set("time.step", x);
    values.set("scheme", "cpdi");
    values.set("material.model", "a \"quoted\" \\ name\twith\nsigns é");
    values.set("output.vtk", false);
    const Values again = read_back(case_text(keys(), values));
    EXPECT_EQ(again.all(), values.all());
    EXPECT_EQ(std::signbit(again.number("specimen.width")), std::signbit(x));
  }
}

TEST(CaseText, ReadsBackTheDefaults) {
  EXPECT_EQ(read_back(case_text(keys(), Values(keys()))).all(), Values(keys()).all());
}

TEST(CaseText, GroupsSectionsAndExplainsEveryKey) {
  const std::string text = case_text(keys(), Values(keys()));
  EXPECT_LT(text.find("scheme = \"gimp\""), text.find("[specimen]"));
  EXPECT_EQ(text.find("[specimen]"), text.rfind("[specimen]"));
  EXPECT_THAT(text, HasSubstr("# width of the specimen [m]\n"));
  EXPECT_THAT(text, HasSubstr("# interpolation: gimp | cpdi\n"));
  EXPECT_THAT(text, HasSubstr("# two lines\n"));
}
