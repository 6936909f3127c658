/// `riedel biaxial` in three dimensions: the same files, numbers per metre of depth, frames with boxes as domains, and
/// pictures of the plane.
#include "apps/program.hpp"
#include "apps/series.hpp"
#include "core/analysis/depth_mean.hpp"
#include "core/png_pixels.hpp"
#include "support/csv.hpp"
#include "support/patterns.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::ElementsAre;

constexpr int in_plane = 8 * 28; ///< points of the coarse case

class BiaxialSlab : public testing::Test {
protected:
  fs::path results(const std::string& name, Words more) const {
    more.insert(more.end(), {"--set", "output.frames_every_strain=0.002"});
    const Outcome outcome = run(folder_, coarse_case(folder_ / name, more));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return folder_ / name;
  }
  TemporaryFolder folder_;
};

TEST_F(BiaxialSlab, LeavesTheNumbersOfPlaneStrainPerMetreOfDepth) {
  const Words few{"--set", "output.vtk=false", "--set", "output.plots=false"};
  Words thick = few;
  thick.insert(thick.end(), {"--set", "grid.dimensions=3", "--set", "specimen.depth_cells=2"});
  const fs::path plane = results("plane", few), slab = results("slab", thick);
  const Table a = read_csv((plane / "history.csv").string()), b = read_csv((slab / "history.csv").string());
  for (const char* column :
       {"phi_mob_deg", "force_N_per_m", "kinetic_J_per_m", "internal_J_per_m", "external_J_per_m"}) {
    ASSERT_EQ(a.at(column).size(), b.at(column).size());
    for (std::size_t i = 0; i < a.at(column).size(); ++i)
      EXPECT_NEAR(b.at(column)[i], a.at(column)[i], 1e-5 * std::abs(a.at(column)[i]) + 1e-9) << column << ", row " << i;
  }
  const json summary = json_of(slab / "summary.json");
  EXPECT_EQ(summary["points"], 2 * in_plane);
  EXPECT_EQ(summary["status"], "done");
  EXPECT_LT(std::abs(summary["mass_error"].get<double>()), 1e-12);
}

TEST_F(BiaxialSlab, LeavesFramesOfBoxesThatVtkReadsAndPicturesOfThePlane) {
  const fs::path out = results("out", {"--set", "grid.dimensions=3", "--set", "scheme=cpdi"});
  const auto points = read_series(out / "points.pvd");
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points.back()->data()->GetNumberOfPoints(), in_plane);
  EXPECT_DOUBLE_EQ(points.back()->data()->GetPoint(0)[2], 0.0025); // half of a cell
  EXPECT_NE(points.back()->at_points("polar_rotation"), nullptr);

  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((out / "domains/domains_000002.vtu").c_str());
  reader->Update();
  vtkUnstructuredGrid* boxes = reader->GetOutput();
  ASSERT_EQ(boxes->GetNumberOfCells(), in_plane);
  EXPECT_EQ(boxes->GetCellType(0), VTK_HEXAHEDRON);
  EXPECT_NEAR(boxes->GetBounds()[4], 0.0, 1e-12);
  EXPECT_NEAR(boxes->GetBounds()[5], 0.005, 1e-12);
  EXPECT_EQ(boxes->GetCellData()->GetArray("void_ratio")->GetNumberOfTuples(), in_plane);

  for (const char* name : {"history.png", "void_ratio.png", "shear_strain.png"})
    EXPECT_GT(PngPixels(out / name).width(), 300) << name;
}

/// Two points one behind the other.
TEST(MeanOverDepth, IsAFrameOfThePlane) {
  Frame slab{.dimension = 3, .position = {1, 2, 0.5, 3, 4, 1.5}, .corners = {}, .fields = {}};
  for (const double z : {0.0, 1.0})
    for (const double face : {z, z + 1})
      for (const auto& [x, y] : {std::pair{0, 1}, {2, 1}, {2, 3}, {0, 3}})
        slab.corners.insert(slab.corners.end(), {x + z, y + z, face});
  slab.fields = {{"id", 1, "-", {0, 1}, true},
                 {"volume", 1, "m3", {6, 10}},
                 {"volume_ratio", 1, "-", {1, 1}},
                 {"velocity", 3, "m/s", {1, 2, 3, 5, 6, 7}},
                 {"displacement", 3, "m", {0, 0, 0, 2, 2, 0}}};
  slab.check();
  EXPECT_DOUBLE_EQ(depth_of(slab), 2.0);
  const Frame plane = mean_over_depth(slab, 2.0);
  plane.check();
  EXPECT_EQ(plane.dimension, 2);
  EXPECT_THAT(plane.position, ElementsAre(2, 3, 0));
  EXPECT_THAT(plane.corners, ElementsAre(0.5, 1.5, 0, 2.5, 1.5, 0, 2.5, 3.5, 0, 0.5, 3.5, 0));
  EXPECT_THAT(plane.field("volume").values, ElementsAre(8)); // 16 m³ over 2 m
  EXPECT_EQ(plane.field("volume").unit, "m2");
  EXPECT_THAT(plane.field("velocity").values, ElementsAre(3, 4, 5));
  EXPECT_FALSE(plane.has("id"));
}

/// Two layers of 3 × 2 points, the second body's last: what counts is where the points stood, not their order.
TEST(MeanOverDepth, FindsThePointsBehindOneAnotherInAnyOrder) {
  Frame slab{.dimension = 3, .position = {}, .corners = {}, .fields = {}};
  Field e{"void_ratio", 1, "-", {}}, u{"displacement", 3, "m", {}};
  for (const bool second : {false, true})
    for (const double z : {0.0, 1.0})
      for (int i = 0; i < 6; ++i) {
        const double x = i % 3, y = i / 3;
        if ((x == 1) != second) continue;
        slab.position.insert(slab.position.end(), {x + 0.4 * y + 0.1 * z, y, z});
        u.values.insert(u.values.end(), {0.4 * y + 0.1 * z, 0.0, 0.0});
        e.values.push_back(x + 10 * y + 100 * z);
        for (const double face : {z, z + 1})
          for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
            slab.corners.insert(slab.corners.end(), {x + a, y + b, face});
      }
  const std::vector<double> ones(slab.points(), 1.0);
  slab.fields = {e, u, {"volume", 1, "m3", ones}, {"volume_ratio", 1, "-", ones}};
  const Frame plane = mean_over_depth(slab, 2.0);
  ASSERT_EQ(plane.points(), 6U);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(plane.field("void_ratio").values[i],
                std::round(plane.position[3 * i] - 0.4 * plane.position[3 * i + 1] - 0.05) +
                    10 * plane.position[3 * i + 1] + 50,
                1e-12);
}

} // namespace
} // namespace riedel::test
