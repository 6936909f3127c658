#include "apps/bench/table.hpp"

#include "core/io/version.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace riedel {

namespace {

/// Millimetres, 0 for local.
std::string length_text(const BenchResult& r) {
  if (r.of.length == 0.0) return "0";
  return short_text(1e3 * r.of.length) + " " + r.of.averager + "/" + r.of.search;
}

constexpr std::size_t names = 4; ///< columns of a row's head that are not numbers
const Row head_of_names{"scheme", "law", "order", "l_c [mm]", "dim", "points", "threads"};
Row row_of_names(const BenchResult& r) {
  return {r.of.scheme + (r.of.transfer == "flip" ? "" : ", " + r.of.transfer) +
              (r.of.filter == 0 ? "" : ", filter/" + std::to_string(r.of.filter)) +
              (r.of.stencils == "auto" ? "" : ", " + r.of.stencils),
          r.of.material,
          r.of.order,
          length_text(r),
          std::to_string(r.of.dimension),
          std::to_string(r.points),
          std::to_string(r.of.threads)};
}

/// What a step must move and compute for a point, counted in docs/benchmarks.md.
struct Demand {
  const char* name;
  double bytes, flops;
};
constexpr std::array<Demand, 4> demands{
    {{"linear 2-D", 296, 202}, {"gimp 2-D", 328, 447}, {"cpdi 2-D", 360, 728}, {"gimp 3-D", 528, 2008}}};

/// Moving and computing overlap: the larger of the two is the minimum time of a step.
std::string bounds_table(const MachineLimits& m) {
  std::vector<Row> rows;
  for (const Demand& d : demands) {
    const double memory = d.bytes / m.triad_memory, arithmetic = d.flops / m.fma;
    rows.push_back({d.name, fixed_text(d.bytes, 0), fixed_text(d.flops, 0), figure(memory), figure(arithmetic),
                    figure(std::max(memory, arithmetic + m.bare_law().pack))});
  }
  return markdown_table({"scheme", "bytes", "flops", "memory ns", "flops ns", "bound ns, with one rate"}, rows, 1);
}

} // namespace

std::string results_table(const std::vector<BenchResult>& results) {
  Row head = head_of_names;
  head.insert(head.end(), {"ns", "least", "most", "bytes", "of bare kernel"});
  std::vector<Row> rows;
  for (const BenchResult& r : results) {
    Row& row = rows.emplace_back(row_of_names(r));
    row.insert(row.end(), {figure(r.ns.median), figure(r.ns.minimum), figure(r.ns.maximum),
                           fixed_text(r.bytes_per_point, 0), r.ns_of_bare_kernel > 0.0 ? figure(r.ratio()) : "–"});
  }
  return markdown_table(head, rows, names);
}

std::string phases_table(const std::vector<BenchResult>& results) {
  Row head = head_of_names;
  for (const std::string_view name : phase_names) head.emplace_back(name);
  std::vector<Row> rows;
  for (const BenchResult& r : results) {
    Row& row = rows.emplace_back(row_of_names(r));
    for (const double ns : r.phases) row.push_back(ns == 0.0 ? "–" : fixed_text(ns, 1));
  }
  return markdown_table(head, rows, names);
}

std::string machine_tables(const MachineLimits& m, const BareKernelTimes& bare) {
  const auto rate = [](double x, const std::string& unit) { return figure(x) + " " + unit; };
  std::vector<Row> limits{{"triad from memory", rate(m.triad_memory, "GB/s"), "–"},
                          {"triad in L2", rate(m.triad_l2, "GB/s"), "–"},
                          {"multiply-adds", rate(m.fma, "GFLOP/s"), "–"},
                          {"exp", rate(m.exp_pack, "ns"), rate(m.exp_scalar, "ns")},
                          {"pow", rate(m.pow_pack, "ns"), rate(m.pow_scalar, "ns")}};
  for (const LawTimes& t : m.laws) limits.push_back({"one rate of " + t.law, rate(t.pack, "ns"), rate(t.scalar, "ns")});
  const std::string one = markdown_table({"limit, one core", "packs", "scalar"}, limits, 1);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < BareKernelTimes::points.size(); ++i)
    rows.push_back({std::to_string(BareKernelTimes::points[i]), figure(bare.linear[i]), figure(bare.gimp[i])});
  return one + "\nBare kernel, ns per point and step (2-D, usl, gudehus_bauer, one thread)\n\n" +
         markdown_table({"points", "linear", "gimp"}, rows, 0) +
         "\nLower bounds, ns per point and step, points in memory\n\n" + bounds_table(m);
}

nlohmann::ordered_json results_json(const std::vector<BenchResult>& results) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  const std::string machine = processor_name();
  for (const BenchResult& r : results) {
    nlohmann::ordered_json phases;
    for (std::size_t i = 0; i < phase_names.size(); ++i) phases[phase_names[i]] = r.phases[i];
    nlohmann::ordered_json row{{"scheme", r.of.scheme},
                               {"law", r.of.material},
                               {"dimension", r.of.dimension},
                               {"points", r.points},
                               {"threads", r.of.threads},
                               {"nonlocal_length", r.of.length},
                               {"order", r.of.order},
                               {"transfer", r.of.transfer},
                               {"ns_per_point_step", r.ns.median},
                               {"ns_min", r.ns.minimum},
                               {"ns_max", r.ns.maximum},
                               {"bytes_per_point", r.bytes_per_point},
                               {"phases", phases},
                               {"averager", r.of.averager},
                               {"search", r.of.search},
                               {"stencils", r.of.stencils},
                               {"filter_steps", r.of.filter},
                               {"points_per_cell", power(r.of.per_cell, r.of.dimension)},
                               {"steps_per_repeat", r.steps},
                               {"substepped_share", r.substepped_share}};
    row["ratio_to_bare_kernel"] = nullptr;
    if (r.ns_of_bare_kernel > 0.0) row["ratio_to_bare_kernel"] = r.ratio();
    row["machine"] = machine;
    row["instruction_set"] = instruction_set();
    row["version"] = version();
    all.push_back(row);
  }
  return all;
}

nlohmann::ordered_json machine_json(const MachineLimits& m, const BareKernelTimes& bare) {
  nlohmann::ordered_json kernels = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < BareKernelTimes::points.size(); ++i)
    kernels.push_back(
        {{"points", BareKernelTimes::points[i]}, {"linear_ns", bare.linear[i]}, {"gimp_ns", bare.gimp[i]}});
  nlohmann::ordered_json laws = nlohmann::ordered_json::array();
  for (const LawTimes& t : m.laws) laws.push_back({{"law", t.law}, {"pack_ns", t.pack}, {"scalar_ns", t.scalar}});
  return {{"machine", processor_name()},
          {"instruction_set", instruction_set()},
          {"version", version()},
          {"triad_memory_GB_per_s", m.triad_memory},
          {"triad_l2_GB_per_s", m.triad_l2},
          {"fma_GFLOP_per_s", m.fma},
          {"exp_pack_ns", m.exp_pack},
          {"exp_scalar_ns", m.exp_scalar},
          {"pow_pack_ns", m.pow_pack},
          {"pow_scalar_ns", m.pow_scalar},
          {"law_pack_ns", m.bare_law().pack},
          {"law_scalar_ns", m.bare_law().scalar},
          {"laws", laws},
          {"bare_kernel", kernels}};
}

} // namespace riedel
