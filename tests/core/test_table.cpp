#include "core/base/error.hpp"
#include "core/io/table.hpp"
#include "temporary_folder.hpp"

#include <cmath>
#include <gmock/gmock.h>

namespace riedel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Tables : public testing::Test {
protected:
  [[nodiscard]] Table read(std::string_view text) const { return read_table(folder_.file("curve.csv", text)); }
  [[nodiscard]] std::string error(std::string_view text) const {
    try {
      (void)read(text);
    } catch (const InputError& error) { return error.what(); }
    return "no error";
  }
  TemporaryFolder folder_;
};

TEST_F(Tables, ReadsColumnsByName) {
  const Table table = read("# measured\neps_1, phi_mob_deg\n0,1e1\r\n\n 0.5 ,nan\n");
  EXPECT_THAT(table.names, ElementsAre("eps_1", "phi_mob_deg"));
  EXPECT_THAT(table["eps_1"], ElementsAre(0.0, 0.5));
  EXPECT_EQ(table["phi_mob_deg"][0], 10.0);
  EXPECT_TRUE(std::isnan(table["phi_mob_deg"][1]));
  EXPECT_FALSE(table.has("gamma"));
}

TEST_F(Tables, TellsFileLineAndColumnOfWhatIsNoNumber) {
  EXPECT_THAT(error("a,b\n1,2\n3, x4\n"), HasSubstr("curve.csv:3:4: 'x4' in column b is not a number"));
  EXPECT_THAT(error("a,b\n1,\n"), HasSubstr("curve.csv:2:3: '' in column b is not a number"));
  EXPECT_THAT(error("a,b\n1,2 kPa\n"), HasSubstr("curve.csv:2:3: '2 kPa' in column b is not a number"));
}

TEST_F(Tables, TellsOfRowsThatDoNotFitTheHeader) {
  EXPECT_THAT(error("a,b\n1\n"), HasSubstr("curve.csv:2:1: the row has 1 cells, the header 2"));
  EXPECT_THAT(error("a,b\n1,2,3\n"), HasSubstr("curve.csv:2:5: the row has 3 cells"));
  EXPECT_THAT(error("a,a\n"), HasSubstr("curve.csv:1:3: the header names 'a' twice"));
  EXPECT_THAT(error("a,,b\n"), HasSubstr("curve.csv:1:3: the header has a column without a name"));
  EXPECT_THAT(error("a,b\n"), HasSubstr("has a header and no row"));
  EXPECT_THAT(error(""), HasSubstr("is empty"));
}

TEST_F(Tables, TakesWhatASpreadsheetWrites) {
  const Table table = read("\xEF\xBB\xBF\"time_s\",u\r\n+1.5,2\r\n");
  EXPECT_THAT(table["time_s"], ElementsAre(1.5));
  EXPECT_THAT(error("a;b\n1,5;2\n"), HasSubstr("the row has 2 cells"));
  EXPECT_THAT(error("a;b\n1;2\n"), HasSubstr("'1;2' in column a;b is not a number; use commas between cells"));
}

TEST_F(Tables, TellsOfAFileThatIsNotThere) {
  for (const auto& path : {folder_ / "missing.csv", folder_.path()}) EXPECT_THROW((void)read_table(path), InputError);
}

} // namespace
} // namespace riedel
