/// Folders of campaigns in any condition: what is read, what is removed, what is reported.
#include "apps/campaign.hpp"
#include "support/patterns.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Collect : public CampaignTest {};

TEST_F(Collect, TellsWhichFolderIsDamaged) {
  ASSERT_EQ(compare({"--schemes", "gimp,linear,cpdi"}).code, 0);
  std::ofstream(out_ / "scheme=gimp" / "summary.json") << "{\"status\": ";
  std::ofstream(out_ / "scheme=linear" / "history.csv") << "step,time_s\n1\n";
  const Outcome outcome = run(folder_, {"collect", out_.string()});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(results()[0].at("status"), "damaged");
  EXPECT_THAT(results()[0].at("reason"), HasSubstr("scheme=gimp/summary.json: cannot be understood"));
  EXPECT_THAT(results()[1].at("reason"), HasSubstr("scheme=linear/history.csv:2:"));
  EXPECT_EQ(results()[2].at("status"), "done");
  EXPECT_THAT(outcome.err, HasSubstr("warning: scheme=gimp is damaged"));
  ASSERT_EQ(compare({"--schemes", "gimp,linear,cpdi"}).code, 0) << "damaged runs run again";
  EXPECT_EQ(results()[1].at("status"), "done");
}

/// A campaign's record with one run of this name and label, as JSON writes them.
std::string record(const std::string& name, const std::string& label = "") {
  return R"({"title":"","command":"","runs":[{"name":")" + name + R"(","label":")" + label +
         R"(","settings":{"scheme":"gimp"},"refused":"","work":1,"final_strain":1,"case":""}]})";
}

TEST_F(Collect, NoNameInARecordLeadsOutOfTheFolder) {
  fs::create_directories(folder_ / "beside");
  folder_.file("beside/summary.json", "mine");
  fs::create_directories(out_);
  for (const std::string name : {"", ".", "..", "../beside", "/etc", "..\\u0000x", "a\\u0000b", "a\\nb", "a\\u001bb",
                                 "a\\\\b", ".hidden", "campaign.json"}) {
    folder_.file("out/campaign.json", record(name));
    for (const Words& words : {Words{"collect", out_.string()}, all({"--schemes", "gimp", "--force"})}) {
      const Outcome outcome = run(folder_, words);
      EXPECT_EQ(outcome.code, 2) << name;
      EXPECT_THAT(outcome.err, HasSubstr("is not a valid run name")) << name;
    }
    EXPECT_EQ(file_content(folder_ / "beside/summary.json"), "mine") << name;
  }
  folder_.file("out/campaign.json", record(std::string(300, 'x')));
  EXPECT_EQ(run(folder_, {"collect", out_.string()}).code, 2);
}

TEST_F(Collect, ForceRemovesWhatRunsWroteAndNothingElse) {
  ASSERT_EQ(compare({"--schemes", "gimp,linear"}).code, 0);
  fs::create_directories(folder_ / "elsewhere");
  folder_.file("elsewhere/summary.json", "mine");
  folder_.file("out/scheme=gimp/notes.txt", "mine");
  fs::remove_all(out_ / "scheme=linear");
  fs::create_directory_symlink(folder_ / "elsewhere", out_ / "scheme=linear");
  ASSERT_EQ(compare({"--schemes", "cpdi", "--force"}).code, 0);
  EXPECT_EQ(file_content(folder_ / "elsewhere/summary.json"), "mine");
  EXPECT_EQ(file_content(out_ / "scheme=gimp/notes.txt"), "mine");
  EXPECT_FALSE(fs::exists(out_ / "scheme=gimp/summary.json"));
}

/// One run after another is damaged in every way; the others are reported as before.
TEST_F(Collect, OutlivesWhateverARunHolds) {
  ASSERT_EQ(compare({"--schemes", "gimp,linear", "--set", "output.vtk=false"}).code, 0);
  const Rows before = results();
  const fs::path one = out_ / "scheme=gimp";
  const std::string summary = file_content(one / "summary.json"), history = file_content(one / "history.csv");
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = summary;
    return text.replace(text.find(from), from.size(), to);
  };
  std::string deep(200'000, '[');
  const std::vector<std::pair<std::string, std::string>> damages{
      {"summary.json", ""},
      {"summary.json", "[]"},
      {"summary.json", "5"},
      {"summary.json", deep},
      {"summary.json", std::string("\0\xff\x01", 3)},
      {"summary.json", summary.substr(0, summary.size() / 2)},
      {"summary.json", with("\"done\"", "\"well\"")},
      {"summary.json", with("\"done\"", "7")},
      {"summary.json", with("\"found\": false", "\"found\": \"no\"")},
      {"summary.json", with("\"none\"", "3")},
      {"summary.json", with("phi_peak_deg", "phi")},
      {"summary.json", with("\"phi_peak_deg\": ", "\"phi_peak_deg\": 1e999")},
      {"history.csv", ""},
      {"history.csv", history.substr(0, history.find('\n') + 1)},
      {"history.csv", "step,time_s\n1,2\n"},
      {"history.csv", history.substr(0, history.size() - 30)},
      {"history.csv", std::string(5000, '\xee')},
      {"history.csv", "step,time_s,u_over_h,phi_mob_deg\n1,nan,nan,nan\n"},
      {"history.csv", "step,time_s,u_over_h,phi_mob_deg\n1,2,2,0\n2,1,1,0\n"}};
  for (const auto& [file, text] : damages) {
    SCOPED_TRACE(file + ": " + text.substr(0, 60));
    std::ofstream(one / file) << text;
    const Outcome outcome = run(folder_, {"collect", out_.string()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    ASSERT_EQ(results().size(), 2U);
    EXPECT_EQ(results()[0].at("status"), "damaged");
    EXPECT_THAT(results()[0].at("reason"), HasSubstr(file));
    EXPECT_EQ(results()[1], before[1]);
    std::ofstream(one / "summary.json") << summary;
    std::ofstream(one / "history.csv") << history;
  }
  fs::remove(one / "history.csv");
  ASSERT_EQ(::mkfifo((one / "history.csv").c_str(), 0666), 0);
  EXPECT_EQ(run(folder_, {"collect", out_.string()}).code, 0) << "and waits for nobody who writes";
}

TEST_F(Collect, OutlivesDamagedFrames) {
  ASSERT_EQ(compare({"--schemes", "gimp,linear"}).code, 0);
  const fs::path index = out_ / "scheme=gimp" / "domains.pvd", frame = out_ / "scheme=gimp/domains/domains_000000.vtp";
  const std::string listed = file_content(index), content = file_content(frame);
  const auto collected = [&](const std::string& reason) {
    const Outcome outcome = run(folder_, {"collect", out_.string()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(file_content(out_ / "report.html"), HasSubstr("scheme=linear"));
    EXPECT_THAT(outcome.err, HasSubstr(reason));
    EXPECT_EQ(results()[0].at("status"), "done");
  };
  for (std::size_t at = 0; at < content.size(); at += content.size() / 5) {
    for (const auto& entry : fs::directory_iterator(frame.parent_path()))
      std::ofstream(entry.path()) << content.substr(0, at) + std::string(40, '\x7f') + content.substr(at);
    collected("");
  }
  std::ofstream(index) << replaced(listed, "file=\"domains/", "file=\"../../../domains/");
  collected("cannot be understood");
  fs::remove_all(frame.parent_path());
  std::ofstream(index) << listed;
  collected("is missing");
}

TEST_F(Collect, CellsOfTheTableAreNoFormulas) {
  ASSERT_EQ(compare({"--schemes", "gimp", "--vary", "imperfection.centre=[0.5,0.5]"}).code, 0);
  std::string text = file_content(out_ / "campaign.json");
  text = replaced(text, "\"imperfection.centre\": \"[^\"]*\"", "\"=cmd()\": \"@SUM(1)\", \"negative\": \"-1.5e-3\"");
  std::ofstream(out_ / "campaign.json") << text;
  ASSERT_EQ(run(folder_, {"collect", out_.string()}).code, 0);
  EXPECT_EQ(results()[0].at("'=cmd()"), "'@SUM(1)");
  EXPECT_EQ(results()[0].at("negative"), "-1.5e-3");
}

TEST_F(Collect, RefusesWhatIsNoCampaign) {
  EXPECT_THAT(run(folder_, {"collect", folder_.path().string()}).err, HasSubstr("the folder holds no campaign"));
  folder_.file("campaign.json", "{\"runs\": 1}");
  const Outcome outcome = run(folder_, {"collect", folder_.path().string()});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("campaign.json: is damaged"));
  folder_.file(
      "campaign.json",
      R"({"title":"","command":"","runs":[{"name":"../x","label":"","settings":{},"refused":"","work":1,"final_strain":1,"case":""}]})");
  EXPECT_THAT(run(folder_, {"collect", folder_.path().string()}).err, HasSubstr("\"../x\" is not a valid run name"));
}

} // namespace
} // namespace riedel::test
