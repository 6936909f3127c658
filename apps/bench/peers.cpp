#include "apps/bench/peers.hpp"

#include "apps/bench/table.hpp"

#include <nlohmann/json.hpp>

namespace riedel {

namespace {

constexpr Index many = 102'400, few = 4'096, solid = 97'336; ///< points of a case; the last in three dimensions
constexpr std::array<std::string_view, 5> programs{"Uintah", "cb-geo", "NairnMPM", "Karamelo", "Matter"};

/// Nanoseconds per point and step, one thread, medians, measured on two Zen 5 cores with AVX-512, each program built
/// with g++ 12 -O3 -march=native; 4 points a cell in the plane, 8 in space. 0: not measured.
struct PeerTimes {
  std::string_view scheme, material;
  int dimension;
  Index points;
  std::array<double, programs.size()> ns;
};
constexpr std::array<PeerTimes, 14> peers{{
    {"linear", "linear_elastic", 2, many, {473, 842, 352, 331, 193}},
    {"linear", "linear_elastic", 2, few, {488, 370, 247, 175, 225}},
    {"gimp", "linear_elastic", 2, many, {736, 1648, 494}},
    {"gimp", "linear_elastic", 2, few, {842, 1254, 380}},
    {"cpdi", "linear_elastic", 2, many, {2655, 0, 731, 721}},
    {"cpdi", "linear_elastic", 2, few, {2678, 0, 534, 405}},
    {"linear", "gudehus_bauer", 2, many, {672}},
    {"linear", "gudehus_bauer", 2, few, {726}},
    {"gimp", "gudehus_bauer", 2, many, {952}},
    {"gimp", "gudehus_bauer", 2, few, {1070}},
    {"cpdi", "gudehus_bauer", 2, many, {2978}},
    {"cpdi", "gudehus_bauer", 2, few, {2982}},
    {"gimp", "linear_elastic", 3, solid, {859, 0, 1061}},
    {"gimp", "gudehus_bauer", 3, solid, {1083}},
}};

const PeerTimes* times_for(const BenchResult& r) {
  for (const PeerTimes& peer : peers)
    if (peer.scheme == r.of.scheme && peer.material == r.of.material && peer.dimension == r.of.dimension &&
        peer.points == r.of.points)
      return &peer;
  return nullptr;
}

} // namespace

std::vector<BenchCase> peer_cases() {
  std::vector<BenchCase> cases;
  for (const char* material : {"linear_elastic", "gudehus_bauer"})
    for (const Index points : {many, few})
      for (const char* scheme : {"linear", "gimp", "cpgimp", "cpdi"})
        for (const char* order : {"usl", "musl"})
          cases.push_back({.scheme = scheme, .material = material, .order = order, .points = points});
  for (const char* material : {"linear_elastic", "gudehus_bauer"})
    cases.push_back({.scheme = "gimp", .material = material, .order = "usl", .dimension = 3, .points = solid});
  return cases;
}

std::string peers_table(const std::vector<BenchResult>& results) {
  Row head{"scheme", "law", "order", "dim", "points", "Riedel", "of bare kernel"};
  head.insert(head.end(), programs.begin(), programs.end());
  std::vector<Row> rows;
  for (const BenchResult& r : results) {
    Row& row = rows.emplace_back(Row{r.of.scheme, r.of.material, r.of.order, std::to_string(r.of.dimension),
                                     std::to_string(r.points), figure(r.ns.median),
                                     r.ns_of_bare_kernel > 0.0 ? figure(r.ratio()) : "–"});
    const PeerTimes* peer = times_for(r);
    for (std::size_t i = 0; i < programs.size(); ++i)
      row.push_back(peer && peer->ns[i] > 0 ? figure(peer->ns[i]) : "–");
  }
  return markdown_table(head, rows, 3) +
         "\nThe other programs' figures come from another machine (Zen 5, AVX-512, g++ 12 -O3 -march=native, one "
         "thread;\n"
         "laws of their own, gudehus_bauer standing for Uintah's hypoplastic one). There the bare kernel took 19 to 21 "
         "ns\n"
         "with linear and 45 to 47 ns with gimp: compare ratios rather than times. Order of the step: usl as a rule.\n";
}

void add_peers(nlohmann::ordered_json& rows, const std::vector<BenchResult>& results) {
  for (std::size_t i = 0; i < results.size(); ++i) {
    nlohmann::ordered_json theirs = nlohmann::ordered_json::object();
    if (const PeerTimes* peer = times_for(results[i]))
      for (std::size_t k = 0; k < programs.size(); ++k)
        if (peer->ns[k] > 0) theirs[std::string(programs[k])] = peer->ns[k];
    rows[i]["peers_ns"] = theirs;
  }
}

} // namespace riedel
