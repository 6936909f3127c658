/// Failures of `riedel biaxial`: what it reports, how it ends, and that nothing written so far is lost.
#include "apps/biaxial/keys.hpp"
#include "apps/biaxial/specimen.hpp"
#include "apps/program.hpp"
#include "apps/series.hpp"
#include "core/base/error.hpp"
#include "core/png_pixels.hpp"
#include "support/csv.hpp"
#include "support/patterns.hpp"
#include "support/schemes.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <thread>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

class BiaxialFailure : public testing::Test {
protected:
  TemporaryFolder folder_;
  fs::path out_ = folder_ / "out";

  [[nodiscard]] Outcome run_coarse(const Words& more, rlim_t largest_file = RLIM_INFINITY) const {
    return run(folder_, coarse_case(out_, more), largest_file);
  }
  [[nodiscard]] json summary() const { return json_of(out_ / "summary.json"); }
  [[nodiscard]] Table history() const { return read_csv((out_ / "history.csv").string()); }
};

/// Every listed frame is whole.
void expect_readable(const std::vector<std::unique_ptr<VtkFrame>>& frames) {
  for (const auto& frame : frames) EXPECT_EQ(frame->data()->GetNumberOfPoints(), 8 * 28);
}

bool has_whole_rows(const std::string& csv) {
  const auto commas = std::count(csv.begin(), csv.begin() + static_cast<std::ptrdiff_t>(csv.find('\n')), ',');
  return csv.ends_with('\n') &&
         std::count(csv.begin(), csv.end(), ',') == commas * std::count(csv.begin(), csv.end(), '\n');
}

} // namespace

TEST_F(BiaxialFailure, ATimeStepOverTheStableLimitWarnsAndStopsWithPointStepAndTime) {
  const Outcome outcome = run_coarse({"--set", "time.step=5e-5", "--set", "loading.final_strain=0.02", "--set",
                                      "output.frames_every_strain=1e-4", "--set", "output.every_strain=1e-4"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, StartsWith("riedel: warning: time.step = 5e-05 s is over the stable limit, 2.5"));
  EXPECT_THAT(outcome.err,
              ContainsRegex("\nriedel: error: .* point [0-9]+ at [(].*; step [0-9]+, time [0-9.e-]+ s\n$"));
  EXPECT_EQ(summary()["status"], "failed");
  EXPECT_TRUE(summary().contains("phi_peak_deg")) << "what it came to is not lost";
  EXPECT_THAT(outcome.err, HasSubstr("riedel: error: " + summary()["reason"].get<std::string>() + "\n"));
  const auto frames = read_series(out_ / "points.pvd");
  EXPECT_GT(frames.size(), 3U);
  expect_readable(frames);
  EXPECT_TRUE(has_whole_rows(file_content(out_ / "history.csv")));
  EXPECT_EQ(history().at("time_s").back(), frames.back()->listed_time());
}

TEST_F(BiaxialFailure, AnInterruptedRunWritesItsLastFrameItsSummaryAndItsPictures) {
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}}) {
    out_ = folder_ / std::to_string(code);
    Process process(folder_, coarse_case(out_, {"--set", "loading.speed=0.01", "--set", "loading.final_strain=0.5",
                                                "--set", "output.every_strain=1e-5"}));
    while (process.running() && file_content(out_ / "history.csv").size() < 2000)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    process.send(signal); // twice, as `timeout` does: to the program and to its group
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const Outcome outcome = process.finish(signal);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_EQ(summary()["status"], "interrupted");
    EXPECT_TRUE(summary().contains("phi_peak_deg"));
    const auto frames = read_series(out_ / "points.pvd");
    expect_readable(frames);
    EXPECT_GT(frames.size(), 1U);
    EXPECT_EQ(frames.back()->listed_time(), history().at("time_s").back());
    EXPECT_EQ(frames.back()->listed_time(), summary()["time_s"]);
    for (const char* name : {"history.png", "void_ratio.png", "shear_strain.png"})
      EXPECT_GT(PngPixels(out_ / name).width(), 300) << name;
  }
}

TEST_F(BiaxialFailure, AHistoryThatFillsTheDiskEndsTheRunWithWholeRows) {
  constexpr rlim_t room = 8000; // enough for the case
  const Outcome outcome = run_coarse({"--set", "output.every_strain=5e-5", "--set", "output.vtk=false"}, room);
  const fs::path history_file = out_ / "history.csv";
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("riedel: error: cannot write " + history_file.string() + ": File too large\n"));
  EXPECT_THAT(summary()["reason"].get<std::string>(), HasSubstr(history_file.string()));
  EXPECT_TRUE(has_whole_rows(file_content(history_file)));
  EXPECT_GT(history().at("step").size(), 10U);
}

TEST_F(BiaxialFailure, AFrameThatFillsTheDiskEndsTheRunAndLeavesTheEarlierOnes) {
  constexpr rlim_t room = 32000; // enough for the first frame, which compresses well, and not for the second
  const Outcome outcome = run_coarse({}, room);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, ContainsRegex("riedel: error: cannot write .*_000001.vtp: File too large\n"));
  EXPECT_EQ(summary()["status"], "failed");
  const auto frames = read_series(out_ / "points.pvd");
  ASSERT_EQ(frames.size(), 1U);
  expect_readable(frames);
  for (const auto& [name, content] : files_in(out_)) EXPECT_FALSE(name.ends_with(".part")) << name;
}

TEST_F(BiaxialFailure, AFirstFrameThatFillsTheDiskIsInTheSummary) {
  const Outcome outcome = run_coarse({}, 8000);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("points_000000.vtp: File too large"));
  ASSERT_TRUE(fs::exists(out_ / "summary.json"));
  EXPECT_EQ(summary()["status"], "failed");
}

TEST_F(BiaxialFailure, ALastFrameThatFillsTheDiskIsInTheSummary) {
  const Outcome outcome = run_coarse({"--set", "output.frames_every_strain=0.9"}, 32000);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("000001.vtp: File too large"));
  ASSERT_TRUE(fs::exists(out_ / "summary.json"));
  EXPECT_EQ(summary()["status"], "failed");
}

TEST_F(BiaxialFailure, AFolderThatCannotBeWrittenEndsBeforeTheRun) {
  folder_.file("out", "a file in the way");
  Outcome outcome = run_coarse({});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err, "riedel: error: --out " + out_.string() + ": is a file, not a folder\n");
  for (const char* nowhere : {"/proc/riedel", "/proc/self"}) {
    outcome = run(folder_, coarse_case(nowhere));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, StartsWith(std::string("riedel: error: --out ") + nowhere + ": cannot be "));
  }
  EXPECT_EQ(file_content(out_), "a file in the way");
}

TEST_F(BiaxialFailure, APictureThatCannotBeDrawnLeavesAFinishedRun) {
  fs::create_directories(out_ / "shear_strain.png" / "x");
  const Outcome outcome = run_coarse({"--force"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("riedel: warning: the pictures could not be written"),
                                 HasSubstr("shear_strain.png: Is a directory")));
  EXPECT_EQ(summary()["status"], "done");
  EXPECT_TRUE(fs::exists(out_ / "shear_strain.png" / "x"));
}

TEST_F(BiaxialFailure, ARunThatCannotBeginLeavesTheEarlierResults) {
  ASSERT_EQ(run_coarse({"--set", "output.vtk=false"}).code, 0);
  folder_.file("out/points", "in the way of frames");
  const auto before = files_in(out_);
  EXPECT_EQ(run_coarse({"--force"}).code, 2);
  EXPECT_EQ(files_in(out_), before);
}

TEST_F(BiaxialFailure, FramesGoThroughNoLink) {
  fs::create_directories(folder_ / "elsewhere");
  fs::create_directories(out_);
  fs::create_directory_symlink(folder_ / "elsewhere", out_ / "points");
  const Outcome outcome = run_coarse({});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("points: is a symbolic link"));
  EXPECT_TRUE(fs::is_empty(folder_ / "elsewhere"));
}

TEST_F(BiaxialFailure, ACaseThatIsWrongLeavesNoFolder) {
  const Outcome outcome = run_coarse({"--set", "scheme=gmip"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean 'gimp'?"));
  EXPECT_FALSE(fs::exists(out_));
}

TEST(LostPoint, IsNamedWithPlaceStepAndTime) {
  const Catalogue& known = catalogue();
  Values values(biaxial_keys(known, paper_model));
  values.set("grid.cells", std::vector<std::int64_t>{8, 28});
  for (const std::string& scheme : schemes_that([](const SchemeTraits& of) { return !of.moves_points; })) {
    values.set("scheme", scheme);
    Simulation<2> simulation = make_biaxial(BiaxialCase(values), known);
    simulation.step();
    Points<2>& points = simulation.state().bodies.front().points;
    points.position[0][points.place[17]] = 0.5;
    try {
      simulation.step();
      FAIL() << "nothing noticed with " << scheme;
    } catch (const RunError& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr("point 17 of 'specimen' left the grid at (0.5, "),
                                      HasSubstr(") m, step 1, time " + exact_text(simulation.state().time) + " s")));
    }
  }
}

TEST(LostPoint, IsNoticedWhenABodyFliesOutOfTheGrid) {
  Simulation<2> simulation(model_with<2>("gimp"),
                           elastic_state<2>({4, 4}, 0.01, 1, 3, [](const Vec<2>&) { return true; }));
  Points<2>& points = simulation.state().bodies.front().points;
  for (Index p = 0; p < points.size(); ++p) points.velocity[0][p] = 20.0;
  const auto fly = [&] {
    for (int i = 0; i < 1000; ++i) simulation.step();
  };
  EXPECT_THAT(fly,
              testing::ThrowsMessage<RunError>(ContainsRegex("point [0-9]+ of 'body' left the grid at [(]0[.]06")));
  // Over three cells, from 0.035 m to 0.065 m, where the box of the outermost point comes to the end of the grid.
  EXPECT_NEAR(simulation.state().time, 0.030 / 20, 2e-5);
}

} // namespace riedel::test
