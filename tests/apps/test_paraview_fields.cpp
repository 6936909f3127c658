/// docs/paraview.md lists exactly the arrays that a run writes for ParaView; other programs read the files.
#include "apps/program.hpp"
#include "apps/series.hpp"
#include "core/io/snapshot.hpp"
#include "core/setup/weak_zone.hpp"
#include "support/patterns.hpp"
#include "support/problems.hpp"

#include <gmock/gmock.h>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;

/// A row of the table, or an array that is written.
struct Array {
  int components = 0;
  std::set<std::string> units;
  bool operator==(const Array&) const = default;
};
using Arrays = std::map<std::string, Array>;

void PrintTo(const Array& array, std::ostream* out) {
  *out << array.components;
  for (const std::string& unit : array.units) *out << " " << unit;
}

Arrays documented() {
  const std::string text = file_content(fs::path(SOURCE_DIR) / "docs/paraview.md");
  const std::string row = R"re(\n\| `(\w+)` \| (\d) \| ([^|]+) \| [^|]*\|)re";
  Arrays arrays;
  for (const auto& match : matches_in(text, row)) {
    Array& array = arrays[match[1]];
    array.components = std::stoi(match[2]);
    for (const auto& unit : matches_in(match[3], "[^, ]+")) array.units.insert(unit[0]);
  }
  return arrays;
}

constexpr auto everywhere = [](const auto&) { return true; };

/// Adds the arrays of a body of that law.
template <int Dim>
void add_arrays(Arrays& arrays, const std::shared_ptr<const Material>& law) {
  Counts<Dim> cells;
  cells.fill(2);
  State<Dim> state = elastic_state<Dim>(cells, 0.01, 1, 3, everywhere);
  Body<Dim>& body = state.bodies.front();
  body.material = law;
  fill<Dim>(body.points, cells, 0.01, 1, 1700.0, state_components(law->states()), everywhere);
  const std::vector<double> initial = law->initial_state();
  for (std::size_t s = 0; s < initial.size(); ++s) body.points.state.fill(static_cast<int>(s), initial[s]);
  if (const int e = state_column(law->states(), "void_ratio"); e >= 0) body.points.state.fill(e, 0.7);
  for (int c = 0; c < 3; ++c) body.points.stress.fill(c, -50e3);
  body.averager =
      catalogue().in<Dim>().averagers.find("gauss").make(0.01, catalogue().in<Dim>().searches.entries()[0].make());
  const Simulation<Dim> simulation(model_with<Dim>("gimp"), std::move(state));
  for (const Field& field : snapshot(simulation, places_of(simulation)).fields) {
    Array& array = arrays[field.name];
    array.components = field.components;
    array.units.insert(field.unit);
  }
}

TEST(ParaViewPage, NamesEveryArrayThatIsWrittenAndNoOther) {
  Arrays written;
  for (const std::string& name : law_names()) {
    add_arrays<2>(written, material(name));
    add_arrays<3>(written, material(name));
  }
  add_arrays<2>(written, material("gudehus_bauer", {{"intergranular_strain", true}}));
  const auto& weak = catalogue().materials.find("mohr_coulomb");
  const Values parameters(weak.description.parameters);
  add_arrays<2>(written, std::make_shared<WeakZoneLaw>(weak.make(parameters), weak.make(parameters)));
  EXPECT_EQ(written, documented());
}

TEST(ParaViewPage, SpeaksOfWhatEveryFileHolds) {
  const TemporaryFolder folder;
  ASSERT_EQ(
      run(folder, coarse_case(folder / "out", {"--set", "loading.final_strain=0.002", "--set", "output.plots=false"}))
          .code,
      0);
  const Arrays known = documented();
  const std::string text = file_content(fs::path(SOURCE_DIR) / "docs/paraview.md");
  const auto frames = read_series(folder / "out" / "domains.pvd");
  vtkPolyData* last = frames.back()->data();
  EXPECT_GT(last->GetCellData()->GetNumberOfArrays(), 15);
  for (int a = 0; a < last->GetCellData()->GetNumberOfArrays(); ++a)
    EXPECT_TRUE(known.contains(last->GetCellData()->GetArrayName(a))) << last->GetCellData()->GetArrayName(a);
  for (int a = 0; a < last->GetFieldData()->GetNumberOfArrays(); ++a)
    EXPECT_THAT(text, testing::HasSubstr("`" + std::string(last->GetFieldData()->GetArrayName(a)) + "`"));
  const double u = last->GetCellData()->GetArray("displacement")->GetComponent(last->GetNumberOfCells() - 1, 1);
  EXPECT_LT(u, -1e-4) << "the platen has pressed the top down";
}

TEST(OtherPrograms, ReadTheFramesOfThreeDimensions) {
  const std::string python = "/usr/bin/python3 -c 'import meshio' 2>/dev/null";
  if (std::system(python.c_str()) != 0) GTEST_SKIP() << "no meshio (Debian: python3-meshio) here";
  const TemporaryFolder folder;
  ASSERT_EQ(run(folder, coarse_case(folder / "out", {"--set", "grid.dimensions=3", "--set",
                                                     "loading.final_strain=0.001", "--set", "output.plots=false"}))
                .code,
            0);
  const std::string script = folder.file("read.py", R"(
import meshio, sys
mesh = meshio.read(sys.argv[1])
assert mesh.cells[0].type == "hexahedron", mesh
data = {name: values[0] for name, values in mesh.cell_data.items()}
assert list(data["id"]) == list(range(8 * 28)), data["id"]
assert data["id"].dtype == "int64", data["id"].dtype
assert data["stress"].shape == (8 * 28, 6) and data["deformation_gradient"].shape == (8 * 28, 9)
assert abs(data["void_ratio"].mean() - 0.55) < 0.01, data["void_ratio"]
assert 0 < mesh.field_data["u_over_h"][0] < 0.002, mesh.field_data
)");
  EXPECT_EQ(
      std::system(("/usr/bin/python3 " + script + " " + (folder / "out/domains/domains_000001.vtu").string()).c_str()),
      0);
}

} // namespace
} // namespace riedel::test
