/// Folders in place of a picture, a report or a file of numbers.
#include "apps/campaign.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class InTheWay : public CampaignTest {
protected:
  void put(const std::string& name) const { fs::create_directories(out_ / name / "x"); }
  /// The command succeeds, and names what it could not write.
  [[nodiscard]] std::string done_without(const std::string& name, const Words& words) const {
    const Outcome outcome = run(folder_, words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("riedel: warning: the "), HasSubstr(name + ": Is a directory")));
    EXPECT_TRUE(fs::exists(out_ / name / "x"));
    return outcome.out;
  }
};

TEST_F(InTheWay, OfAPictureAnElementTestIsDone) {
  put("stress_strain.png");
  (void)done_without("stress_strain.png",
                     {"element", "triaxial", "--out", out_.string(), "--force", "--set", "loading.final_strain=0.01"});
  EXPECT_THAT(file_content(out_ / "summary.json"), HasSubstr("phi_peak_deg"));
}

TEST_F(InTheWay, OfAPictureAVerificationIsDone) {
  put("convergence.png");
  EXPECT_THAT(
      done_without("convergence.png", {"verify", "--problems", "patch", "--schemes", "gimp", "--out", out_.string()}),
      HasSubstr("verify.md, verify.csv, summary.json\n"));
  EXPECT_TRUE(fs::exists(out_ / "verify.csv"));
}

TEST_F(InTheWay, OfTheReportACampaignIsDone) {
  put("report.html");
  EXPECT_THAT(done_without("report.html", all({"--schemes", "gimp"})), HasSubstr(": results.csv, curves.png"));
  EXPECT_EQ(results()[0].at("status"), "done");
}

TEST_F(InTheWay, OfAPictureAReproductionIsDone) {
  put("figure_2b.png");
  (void)done_without("figure_2b.png", {"reproduce", "--figure", "2", "--out", out_.string()});
  EXPECT_TRUE(fs::exists(out_ / "verdicts.md"));
}

TEST_F(InTheWay, OfTheNumbersOfABenchmarkIsToldBeforeAnythingIsMeasured) {
  put("bench.json");
  for (const fs::path& file : {out_ / "bench.json", folder_ / "nowhere" / "bench.json"}) {
    const Outcome outcome = run(folder_, {"bench", "--points", "1e9", "--json", file.string()});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--json " + file.string() + ": "));
  }
}

} // namespace
} // namespace riedel::test
