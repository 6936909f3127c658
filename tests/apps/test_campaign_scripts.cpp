/// Scripts that run a campaign elsewhere.
#include "apps/campaign.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Scripts : public CampaignTest {};

TEST_F(Scripts, RunTheSameCampaignElsewhere) {
  const Words words{"--schemes", "gimp,linear"};
  ASSERT_EQ(compare(words).code, 0);
  const Rows wanted = results();
  fs::rename(out_, folder_ / "whole");
  for (const std::string kind : {"slurm", "parallel"}) {
    ASSERT_EQ(compare({"--schemes", "gimp,linear", "--script", kind, "--force"}).code, 0);
    EXPECT_FALSE(fs::exists(out_ / "scheme=gimp" / "history.csv"));
    const std::string script = (out_ / ("campaign." + kind)).string();
    const std::string call =
        kind == "slurm" ? "for SLURM_ARRAY_TASK_ID in 0 1; do export SLURM_ARRAY_TASK_ID; bash " + script + "; done"
                        : "sh " + script;
    ASSERT_EQ(std::system(("(" + call + ") >" + (folder_ / "log").string() + " 2>&1").c_str()), 0)
        << file_content(folder_ / "log");
    ASSERT_EQ(run(folder_, {"collect", out_.string()}).code, 0);
    EXPECT_EQ(results(), wanted) << kind;
  }
}

/// Words that a shell would execute, and line ends, in the names of folders and of the program.
TEST_F(Scripts, HoldEveryNameAsAWord) {
  const fs::path place = folder_ / "a b;touch hit\n'touch hit'$(touch hit)`touch hit`\"", program = place / "riedel";
  fs::create_directories(place);
  fs::copy_file(RIEDEL_PROGRAM, program);
  out_ = place / "out";
  Words words = all({"--schemes", "gimp,linear"});
  for (const std::string kind : {"slurm", "parallel"}) {
    std::string line = "cd '" + folder_.path().string() + "'; exec \"$PROGRAM\"";
    ::setenv("PROGRAM", program.c_str(), 1);
    ::setenv("OUT", out_.c_str(), 1);
    words[2] = "$OUT";
    for (const std::string& word : words) line += word == "$OUT" ? " \"$OUT\"" : " '" + word + "'";
    ASSERT_EQ(
        std::system(("sh " + folder_.file("call", line + " --force --script " + kind + "\n") + " >/dev/null").c_str()),
        0);
    ::setenv("SCRIPT", (out_ / ("campaign." + kind)).c_str(), 1);
    const std::string carry_out =
        kind == "slurm" ? "for SLURM_ARRAY_TASK_ID in 0 1; do export SLURM_ARRAY_TASK_ID; bash \"$SCRIPT\"; done"
                        : "while IFS= read -r line; do sh -c \"$line\"; done < \"$SCRIPT\""; // as GNU parallel does
    const std::string script = folder_.file("carry_out", "cd '" + folder_.path().string() + "'\n" + carry_out + "\n");
    ASSERT_EQ(std::system(("bash " + script + " >/dev/null 2>" + (folder_ / "log").string()).c_str()), 0)
        << file_content(folder_ / "log");
    for (const char* run : {"scheme=gimp", "scheme=linear"})
      EXPECT_TRUE(fs::exists(out_ / run / "summary.json")) << kind << file_content(folder_ / "log");
    EXPECT_FALSE(fs::exists(folder_ / "hit")) << kind;
  }
}

} // namespace
} // namespace riedel::test
