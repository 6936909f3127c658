#include "apps/bench/options.hpp"
#include "apps/bench/peers.hpp"
#include "apps/bench/table.hpp"
#include "program.hpp"
#include "support/patterns.hpp"
#include "support/problems.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <thread>

namespace riedel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class Bench : public testing::Test {
protected:
  [[nodiscard]] Outcome bench(Words words) const {
    words.insert(words.begin(), "bench");
    return run(folder_, words);
  }
  TemporaryFolder folder_;
};

template <int Dim>
void expect_gentle_motion(const BenchCase& wanted) {
  SCOPED_TRACE(wanted.scheme + ", " + wanted.material + ", " + wanted.order);
  Simulation<Dim> simulation = make_block<Dim>(wanted, catalogue());
  const Points<Dim>& points = simulation.state().bodies.front().points;
  simulation.step();
  const double dt = simulation.time_step();
  double middle = 0.0;
  for (Index p = 0; p < points.size(); ++p) middle += points.rate_norm[0][p] * dt / points.size();
  EXPECT_NEAR(middle, bench_block::strain_per_step, 0.3 * bench_block::strain_per_step); // edges lag behind
  for (int i = 0; i < 40; ++i) simulation.step();
  set_in_motion(simulation);
  for (int i = 0; i < 20; ++i) simulation.step();
  EXPECT_EQ(simulation.state().report.substepped, 0);
  EXPECT_EQ(simulation.state().report.low_pressure + simulation.state().report.separated, 0);
  for (Index p = 0; p < points.size(); ++p) {
    ASSERT_NEAR(-(points.stress[0][p] + points.stress[1][p] + points.stress[2][p]) / 3.0, bench_block::pressure,
                0.1 * bench_block::pressure);
    ASSERT_LT(points.rate_norm[0][p] * dt, 10 * bench_block::strain_per_step);
    ASSERT_TRUE(points.position_of(p).allFinite() && points.velocity_of(p).allFinite());
  }
}

TEST(BenchBlock, ShearsGentlyUnderEverySchemeLawAndOrder) {
  for (const std::string& scheme : scheme_names())
    for (const std::string& law : law_names())
      for (const std::string& order : step_orders()) {
        expect_gentle_motion<2>({.scheme = scheme, .material = law, .order = order, .points = 1000});
        expect_gentle_motion<3>({.scheme = scheme, .material = law, .order = order, .points = 500});
      }
}

TEST(BenchBlock, HasNearlyAsManyPointsAsWishedFor) {
  for (const Index wanted : {2'000, 10'000, 100'000, 1'000'000}) {
    const Counts<2> flat = block_cells<2>(wanted, 2);
    EXPECT_NEAR(4.0 * flat[0] * flat[1], wanted, 0.02 * wanted);
    const Counts<3> solid = block_cells<3>(wanted, 2);
    EXPECT_NEAR(8.0 * solid[0] * solid[1] * solid[2], wanted, 0.06 * wanted);
  }
  EXPECT_EQ(block_cells<2>(1, 4), (Counts<2>{1, 1}));
}

TEST(BenchSpread, TellsMedianLeastAndMost) {
  const Spread odd = spread_of({3, 1, 10}), even = spread_of({4, 1, 2, 3});
  EXPECT_EQ(odd.median, 3);
  EXPECT_EQ(odd.minimum, 1);
  EXPECT_EQ(odd.maximum, 10);
  EXPECT_EQ(even.median, 2.5);
}

TEST(BenchMeasure, AddsUpPhasesAndCountsMemory) {
  const BenchEffort effort{.repeats = 3, .seconds = 1e-4};
  const auto result = measure({.points = 400, .length = 1.5e-3, .search = "cell_list"}, catalogue(), effort);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->points, 400);
  EXPECT_GT(result->steps, 0);
  EXPECT_LE(result->ns.minimum, result->ns.median);
  EXPECT_LE(result->ns.median, result->ns.maximum);
  EXPECT_GT(result->phases[static_cast<std::size_t>(Phase::law)], 0.0);
  EXPECT_GT(result->phases[static_cast<std::size_t>(Phase::averaging)], 0.0);
  // 27 columns of points at least, and a weight for each of about 60 neighbours.
#if !defined(__SANITIZE_ADDRESS__) // whose heap is not the one that is counted
  EXPECT_GT(result->bytes_per_point, 27 * 8 + 30 * 12);
#endif
  EXPECT_LT(result->bytes_per_point, 20'000);
}

TEST(BenchMeasure, TellsWhatTheStressFilterTakesOverWholeRounds) {
  const BenchEffort effort{.repeats = 1, .seconds = 1e-4};
  const auto without = measure({.points = 100}, catalogue(), effort);
  const auto with = measure({.points = 100, .filter = 7}, catalogue(), effort);
  ASSERT_TRUE(without && with);
  EXPECT_EQ(without->phases[static_cast<std::size_t>(Phase::filter)], 0.0);
  EXPECT_GT(with->phases[static_cast<std::size_t>(Phase::filter)], 0.0);
  EXPECT_EQ(with->steps % 70, 0);
  EXPECT_THAT(results_table({*with}), testing::HasSubstr("gimp, filter/7 "));
}

TEST(BenchMeasure, LeavesWhenAsked) {
  int questions = 0;
  const BenchEffort effort{.stop = [&] { return ++questions > 25; }};
  EXPECT_FALSE(measure({.points = 100}, catalogue(), effort));
  EXPECT_EQ(questions, 26);
}

TEST(BenchPeers, AreMeasuredInTheCasesThatTheirFiguresBelongTo) {
  std::vector<BenchResult> results;
  for (const BenchCase& each : peer_cases()) {
    const Counts<2> flat = block_cells<2>(each.points, each.per_cell);
    const Counts<3> solid = block_cells<3>(each.points, each.per_cell);
    const Index points = each.dimension == 2 ? 4 * flat[0] * flat[1] : 8 * solid[0] * solid[1] * solid[2];
    EXPECT_EQ(points, each.points);
    results.push_back({.of = each, .points = points});
  }
  const std::string table = peers_table(results);
  for (const char* theirs : {"1648", "1254", "2655", "731", "193", "1083", "1061", "2982"})
    EXPECT_THAT(table, HasSubstr(" " + std::string(theirs) + " |"));
}

TEST(BenchTable, StandsInColumns) {
  EXPECT_EQ(markdown_table({"a", "µs"}, {{"one", "1"}, {"2", "–"}}, 1),
            "| a   | µs |\n| --- | -: |\n| one |  1 |\n| 2   |  – |\n");
  EXPECT_EQ(figure(1.234), "1.23");
  EXPECT_EQ(figure(12.34), "12.3");
  EXPECT_EQ(figure(123.4), "123");
}

TEST_F(Bench, WritesAnObjectForEveryCase) {
  const std::string file = (folder_ / "bench.json").string();
  const Outcome outcome =
      bench({"--scheme", "linear,cpdi", "--points", "64,2e2", "--material", "gudehus_bauer,linear_elastic", "--length",
             "0,1.5mm", "--search", "cell_list,cgal_kd_tree", "--repeats", "1", "--seconds", "1e-4", "--json", file});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = json_of(file);
  ASSERT_EQ(rows.size(), 16U); // the elastic law knows no length, and no length no search
  for (const auto& row : rows) {
    for (const char* key : {"scheme", "law", "dimension", "points", "threads", "nonlocal_length", "order",
                            "ns_per_point_step", "ns_min", "ns_max", "bytes_per_point", "phases"})
      EXPECT_TRUE(row.contains(key)) << key;
    EXPECT_EQ(row["phases"].size(), phase_names.size());
    EXPECT_GT(row["ns_per_point_step"], 0.0);
    EXPECT_GT(row["ratio_to_bare_kernel"], 0.0);
  }
  EXPECT_EQ(rows[0]["nonlocal_length"], 0.0);
  EXPECT_EQ(rows[4]["nonlocal_length"], 0.0015);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("| scheme |"), HasSubstr("| cpdi "), HasSubstr("averaging")));
}

TEST_F(Bench, EndsWithTwoWhenTheInputIsWrong) {
  const std::vector<std::pair<Words, std::string>> wrong{
      {{"--scheme", "cpid"}, "--scheme cpid: unknown (did you mean 'cpdi'?); known: linear, gimp"},
      {{"--scheme", "gimp,,cpdi"}, "empty"},
      {{"--material", "sand"}, "known: linear_elastic, gudehus_bauer"},
      {{"--order", "mul"}, "known: musl, usl, usf"},
      {{"--search", "tree"}, "known: cgal_kd_tree, cell_list"},
      {{"--averager", "none"}, "known: gauss"},
      {{"--points", "0"}, "--points 0: allowed: an integer in [1, "},
      {{"--points", "-1e3"}, "allowed"},
      {{"--points", "10.5"}, "allowed: an integer"},
      {{"--points", "many"}, "allowed: an integer"},
      {{"--threads", "0"}, "allowed"},
      {{"--per-cell", "0"}, "allowed"},
      {{"--repeats", "0"}, "allowed"},
      {{"--seconds", "0"}, "allowed"},
      {{"--dimension", "1"}, "allowed: an integer in [2, 3]"},
      {{"--length", "-1"}, "allowed"},
      {{"--length", "-1mm"}, "allowed"},
      {{"--length", "3kg"}, "unit of another kind"},
      {{"--length", "1mm", "--material", "linear_elastic"}, "none of the laws"},
      {{"--peers", "--scheme", "gimp"}, "--peers has cases of its own"},
      {{"--peers", "--machine"}, "one at a time"},
  };
  for (const auto& [words, text] : wrong) {
    const Outcome outcome = bench(words);
    EXPECT_EQ(outcome.code, 2) << words.back();
    EXPECT_THAT(outcome.err, AllOf(StartsWith("riedel: error: "), HasSubstr(text)));
    EXPECT_THAT(outcome.out, IsEmpty());
  }
}

TEST_F(Bench, TellsWhatTheMachineCanDo) {
  const std::string file = (folder_ / "machine.json").string();
  const Outcome outcome = bench({"--machine", "--repeats", "1", "--seconds", "1e-5", "--json", file});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("triad"), HasSubstr("pow"), HasSubstr("102400")));
  const auto machine = json_of(file).at(0);
  EXPECT_GT(machine["fma_GFLOP_per_s"], 0.0);
  EXPECT_GT(machine["bare_kernel"][1]["gimp_ns"], 0.0);
  ASSERT_EQ(machine["laws"].size(), 4U); // both sands, with intergranular strain and without
  for (const auto& law : machine["laws"]) {
    EXPECT_GT(law["pack_ns"], 0.0) << law["law"];
    EXPECT_GT(law["scalar_ns"], 0.0) << law["law"];
    EXPECT_THAT(outcome.out, HasSubstr("one rate of " + law["law"].get<std::string>() + " "));
  }
}

TEST_F(Bench, LeavesCleanlyWhenInterrupted) {
  Process program(folder_, {"bench", "--points", "1e4", "--seconds", "0.02", "--repeats", "1000"});
  while (program.running() && file_content(folder_ / "stderr").empty())
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(program.finish(SIGINT).code, 130);
}

} // namespace
} // namespace riedel::test
