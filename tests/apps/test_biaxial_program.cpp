/// `riedel biaxial` as a user runs it: every promised file, its content, and identical bits in a second run.
#include "apps/program.hpp"
#include "apps/series.hpp"
#include "core/png_pixels.hpp"
#include "support/csv.hpp"
#include "support/patterns.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <set>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::IsSubsetOf;
using testing::IsSupersetOf;
using testing::StartsWith;

class BiaxialProgram : public testing::Test {
protected:
  /// Runs the coarse case into a folder of that name; the run must succeed.
  fs::path results(const std::string& name, const Words& more = {}) const {
    const Outcome outcome = run(folder_, coarse_case(folder_ / name, more));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return folder_ / name;
  }
  TemporaryFolder folder_;
};

std::vector<std::string> keys_of(const json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

/// Runs that compute the same write the same files, except for the summary, which holds the time they took.
void expect_same_results(const fs::path& one, const fs::path& other) {
  auto first = files_in(one), second = files_in(other);
  EXPECT_GT(first.size(), 1U);
  for (auto* files : {&first, &second}) files->erase("summary.json");
  for (const auto& [name, content] : first)
    EXPECT_TRUE(second.contains(name) && second.at(name) == content) << name << " differs in " << other;
  EXPECT_EQ(first.size(), second.size());
}

TEST_F(BiaxialProgram, LeavesEveryFileThatItPromises) {
  const Outcome outcome = run(folder_, coarse_case(folder_ / "out"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::vector<std::string> names;
  for (const auto& [name, content] : files_in(folder_ / "out")) names.push_back(name);
  EXPECT_THAT(names,
              IsSupersetOf({"case.toml", "history.csv", "summary.json", "points.pvd", "domains.pvd",
                            "points/points_000000.vtp", "domains/domains_000000.vtp", "history.png", "history.svg",
                            "void_ratio.png", "shear_strain.png", "mean_pressure.png", "rate_norm.png"}));
  for (const std::string& name : names) EXPECT_FALSE(name.ends_with(".part")) << name;
  EXPECT_THAT(outcome.out, HasSubstr("peak"));
  EXPECT_THAT(outcome.err, HasSubstr("100 %"));
}

TEST_F(BiaxialProgram, HistoryBeginsWithThePromisedColumnsAndEndsAtTheFinalStrain) {
  const fs::path out = results("out", {"--set", "output.vtk=false", "--set", "output.plots=false"});
  EXPECT_THAT(file_content(out / "history.csv"),
              StartsWith("step,time_s,u_over_h,phi_mob_deg,force_N_per_m,kinetic_J_per_m,internal_J_per_m,"));
  const Table history = read_csv((out / "history.csv").string());
  const auto &step = history.at("step"), &u = history.at("u_over_h"), &time = history.at("time_s");
  EXPECT_EQ(step.front(), 0.0);
  EXPECT_EQ(history.at("force_N_per_m").front(), 50e3 * 0.040); // at rest the platen carries the lateral pressure
  EXPECT_TRUE(std::ranges::is_sorted(u) && std::ranges::is_sorted(time));
  EXPECT_GE(u.back(), 0.004);
  EXPECT_LT(u.back(), 0.0041);
  EXPECT_EQ(u.size(), 9U); // every 0.0005 and the start
}

TEST_F(BiaxialProgram, SummaryHasThePromisedKeysAndAgreesWithTheHistory) {
  const fs::path out = results("out", {"--set", "output.vtk=false", "--set", "output.plots=false"});
  const json summary = json_of(out / "summary.json");
  EXPECT_THAT(keys_of(summary),
              IsSupersetOf({"case", "scheme", "material", "points", "nodes", "steps", "dt_s", "wall_s",
                            "ns_per_point_step", "threads", "phi_peak_deg", "u_over_h_at_peak", "phi_residual_deg",
                            "kinetic_over_internal_max", "mass_error", "band"}));
  EXPECT_THAT(keys_of(summary["band"]), IsSupersetOf({"found", "kind", "inclination_deg", "thickness_m",
                                                      "thickness_fwhm_m", "thickness_over_lc", "void_ratio_inside"}));
  const Table history = read_csv((out / "history.csv").string());
  const auto& phi = history.at("phi_mob_deg");
  const auto peak = std::ranges::max_element(phi);
  EXPECT_EQ(summary["case"], "biaxial");
  EXPECT_EQ(summary["status"], "done");
  EXPECT_EQ(summary["scheme"], "gimp");
  EXPECT_EQ(summary["points"], 8 * 28);
  EXPECT_EQ(summary["threads"], 1);
  EXPECT_EQ(summary["steps"], history.at("step").back());
  EXPECT_EQ(summary["phi_peak_deg"], *peak);
  EXPECT_EQ(summary["u_over_h_at_peak"], history.at("u_over_h")[static_cast<std::size_t>(peak - phi.begin())]);
  EXPECT_LT(std::abs(summary["mass_error"].get<double>()), 1e-12);
  EXPECT_FALSE(summary["band"]["found"]);
  EXPECT_EQ(summary["band"]["kind"], "none");
}

TEST_F(BiaxialProgram, PointsAndDomainsAreReadByVtkWithEveryField) {
  const fs::path out = results("out", {"--set", "output.plots=false"});
  const auto points = read_series(out / "points.pvd"), domains = read_series(out / "domains.pvd");
  ASSERT_EQ(points.size(), 5U); // every 0.001 and the start
  ASSERT_EQ(domains.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(points[i]->data()->GetNumberOfPoints(), 8 * 28);
    ASSERT_EQ(domains[i]->data()->GetNumberOfCells(), 8 * 28);
    for (const auto& [field, components] : {std::pair{"id", 1},
                                            {"void_ratio", 1},
                                            {"shear_strain", 1},
                                            {"stress", 6},
                                            {"mean_pressure", 1},
                                            {"rate_norm", 1},
                                            {"averaged", 1},
                                            {"velocity", 3},
                                            {"volume", 1},
                                            {"mass", 1},
                                            {"volume_ratio", 1},
                                            {"polar_rotation", 1}})
      for (vtkDataArray* array : {points[i]->at_points(field), domains[i]->at_cells(field)}) {
        ASSERT_NE(array, nullptr) << field;
        EXPECT_EQ(array->GetNumberOfComponents(), components) << field;
        EXPECT_EQ(array->GetNumberOfTuples(), 8 * 28) << field;
      }
    for (vtkIdType p = 0; p < 8 * 28; ++p) ASSERT_EQ(points[i]->at_points("id")->GetComponent(p, 0), p);
  }
}

TEST_F(BiaxialProgram, TheFirstFrameIsTheSpecimenAtRest) {
  const fs::path out = results("out", {"--set", "output.plots=false"});
  const auto frames = read_series(out / "points.pvd");
  ASSERT_FALSE(frames.empty());
  VtkFrame& start = *frames.front();
  double area = 0.0, loose = 0.0;
  for (vtkIdType p = 0; p < 8 * 28; ++p) {
    area += start.at_points("volume")->GetComponent(p, 0);
    loose += start.at_points("void_ratio")->GetComponent(p, 0) > 0.89 ? 1 : 0;
    EXPECT_NEAR(start.at_points("stress")->GetComponent(p, 0), -50e3, 0.01);
    EXPECT_NEAR(start.at_points("stress")->GetComponent(p, 3), 0.0, 0.01); // xy
  }
  EXPECT_NEAR(area, 0.040 * 0.140, 1e-8);
  EXPECT_EQ(loose, 1); // cells of 5 mm: the patch is one of them
  EXPECT_NEAR(start.at_points("stress")->GetComponent(0, 1), -50e3 - 2650 / 1.55 * 9.81 * 0.1375, 0.1);
}

TEST_F(BiaxialProgram, TimesOfFramesRiseAndAreTimesOfTheHistory) {
  const fs::path out = results("out", {"--set", "output.plots=false"});
  const Table history = read_csv((out / "history.csv").string());
  const auto &time = history.at("time_s"), &u = history.at("u_over_h");
  double before = -1.0;
  for (const char* pvd : {"points.pvd", "domains.pvd"}) {
    before = -1.0;
    for (const auto& frame : read_series(out / pvd)) {
      EXPECT_GT(frame->listed_time(), before);
      before = frame->listed_time();
      EXPECT_EQ(frame->number("TimeValue"), frame->listed_time());
      const auto row = std::ranges::find(time, frame->listed_time()); // every second row has a frame
      ASSERT_NE(row, time.end()) << frame->listed_time();
      EXPECT_EQ(frame->number("u_over_h"), u[static_cast<std::size_t>(row - time.begin())]);
    }
    EXPECT_EQ(before, time.back());
  }
}

TEST_F(BiaxialProgram, PicturesAreValidAndNotBlank) {
  const fs::path out = results("out", {"--set", "output.vtk=false"});
  for (const char* name : {"history.png", "void_ratio.png", "shear_strain.png", "mean_pressure.png", "rate_norm.png"}) {
    PngPixels picture(out / name);
    ASSERT_GT(picture.width(), 300) << name;
    ASSERT_GT(picture.height(), 300) << name;
    std::set<unsigned> colours;
    for (int y = 0; y < picture.height(); y += 3)
      for (int x = 0; x < picture.width(); x += 3) colours.insert(picture.at(x, y));
    EXPECT_GT(colours.size(), 10U) << name;
  }
  EXPECT_THAT(file_content(out / "history.svg"), HasSubstr("<polyline"));
}

TEST_F(BiaxialProgram, LeavesOutWhatIsNotWanted) {
  const fs::path out = results("out", {"--set", "output.vtk=false", "--set", "output.plots=false"});
  std::vector<std::string> names;
  for (const auto& [name, content] : files_in(out)) names.push_back(name);
  EXPECT_THAT(names, testing::UnorderedElementsAre("case.toml", "history.csv", "summary.json"));
}

TEST_F(BiaxialProgram, ItsOwnCaseGivesTheSameBitsAgain) {
  const fs::path first = results("first", {"--set", "scheme=cpdi", "--set", "specimen.width='41 mm'", "--set",
                                           "specimen.void_ratio=0.5512345678901234", "--set", "time.flip=0.97", "--set",
                                           "output.plots=false"});
  const Outcome again = run(
      folder_, {"biaxial", (first / "case.toml").string(), "--out", (folder_ / "again").string(), "--threads", "1"});
  ASSERT_EQ(again.code, 0) << again.err;
  expect_same_results(first, folder_ / "again");
}

TEST_F(BiaxialProgram, ThreadsAndSearchesDoNotChangeABit) {
  const Words shared{"--set", "grid.cells=[16,56]",        "--set", "output.plots=false",
                     "--set", "loading.final_strain=0.002"};
  const auto with = [&](const std::string& name, const Words& more) {
    Words words = shared;
    words.insert(words.end(), more.begin(), more.end());
    return results(name, words);
  };
  const fs::path one = with("one", {});
  expect_same_results(one, with("two", {"--threads", "2"}));
  expect_same_results(one, with("four", {"--threads", "4"}));
  const fs::path cells = with("cells", {"--set", "nonlocal.search=cell_list"});
  fs::remove(one / "case.toml"); // it names the search
  fs::remove(cells / "case.toml");
  expect_same_results(one, cells);
}

TEST_F(BiaxialProgram, KeepsResultsUnlessForced) {
  const fs::path out = results("out");
  const auto before = files_in(out);
  const Words shorter = coarse_case(out, {"--set", "loading.final_strain=0.001", "--set", "output.plots=false"});
  const Outcome refused = run(folder_, shorter);
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("riedel: error: --out " + out.string() + ": holds results already"));
  EXPECT_THAT(refused.err, HasSubstr("--force"));
  EXPECT_EQ(files_in(out), before);

  Words forced = shorter;
  forced.push_back("--force");
  EXPECT_EQ(run(folder_, forced).code, 0);
  std::vector<std::string> names;
  for (const auto& [name, content] : files_in(out)) names.push_back(name);
  EXPECT_THAT(names, testing::UnorderedElementsAre("case.toml", "history.csv", "summary.json", "points.pvd",
                                                   "domains.pvd", "points/points_000000.vtp",
                                                   "points/points_000001.vtp", "domains/domains_000000.vtp",
                                                   "domains/domains_000001.vtp")); // no old frame, no old picture
  EXPECT_EQ(read_csv((out / "history.csv").string()).at("step").size(), 3U);
}

} // namespace
} // namespace riedel::test
