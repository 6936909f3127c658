#include "core/base/error.hpp"
#include "core/io/vtk_writer.hpp"
#include "support/patterns.hpp"

#include <csignal>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <fstream>

namespace riedel {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// A directory of its own for each test.
class VtkWriter : public testing::Test {
protected:
  void SetUp() override {
    directory = fs::path(testing::TempDir()) /
                (std::string("riedel_vtk_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(directory);
  }
  void TearDown() override { fs::remove_all(directory); }

  fs::path directory;
};

/// Two skewed domains side by side.
Frame two_points(double time) {
  Frame frame;
  frame.time = time;
  frame.scalars = {{"u_over_h", 0.02}, {"load_N", -5.0}};
  frame.position = {0.5, 0.5, 0, 1.5, 0.5, 0};
  frame.corners = {0, 0, 0, 1, 0.1, 0, 1, 1.1, 0, 0, 1, 0, 1, 0.1, 0, 2, 0.2, 0, 2, 1.2, 0, 1, 1.1, 0};
  frame.fields = {{"void_ratio", 1, "-", {0.625, 0.75}},
                  {"velocity", 3, "m/s", {1, 2, 0, -3, 4.5, time}},
                  {"id", 1, "-", {16777216, 16777217}, true}}; // not distinguishable as floats
  return frame;
}

Frame one_hexahedron() {
  Frame frame;
  frame.dimension = 3;
  frame.position = {0.5, 0.5, 1};
  frame.corners = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 2, 1, 0, 2, 1, 1, 2, 0, 1, 2};
  frame.fields = {{"void_ratio", 1, "-", {0.625}}};
  return frame;
}

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

template <class Reader>
vtkNew<Reader> read(const fs::path& path) {
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader;
}

std::vector<double> values_of(vtkDataArray* array) {
  std::vector<double> values;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    for (int c = 0; c < array->GetNumberOfComponents(); ++c) values.push_back(array->GetComponent(i, c));
  return values;
}

std::vector<double> times_in(const fs::path& pvd) {
  const std::string text = text_of(pvd);
  const std::string entry = R"re(<DataSet timestep="([^"]+)" part="0" file="[^"]+"/>)re";
  std::vector<double> times;
  for (const auto& match : test::matches_in(text, entry)) times.push_back(std::stod(match[1]));
  return times;
}

void expect_fields(vtkDataSetAttributes* data, const Frame& frame) {
  ASSERT_EQ(data->GetNumberOfArrays(), static_cast<int>(frame.fields.size()));
  for (const Field& field : frame.fields) {
    vtkDataArray* array = data->GetArray(field.name.c_str());
    ASSERT_NE(array, nullptr) << field.name;
    EXPECT_EQ(array->GetNumberOfComponents(), field.components);
    EXPECT_EQ(array->GetDataType(), field.whole ? VTK_TYPE_INT64 : VTK_FLOAT) << field.name;
    EXPECT_EQ(values_of(array), field.values) << field.name;
  }
}

TEST_F(VtkWriter, KeepsPointsAndEveryField) {
  const Frame frame = two_points(0.25);
  SeriesWriter(directory).write(frame);

  const auto reader = read<vtkXMLPolyDataReader>(directory / "points/points_000000.vtp");
  vtkPolyData* points = reader->GetOutput();
  ASSERT_EQ(points->GetNumberOfPoints(), 2);
  EXPECT_EQ(points->GetNumberOfVerts(), 2);
  EXPECT_EQ(values_of(points->GetPoints()->GetData()), frame.position);
  expect_fields(points->GetPointData(), frame);
  EXPECT_EQ(points->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0), 0.25);
  EXPECT_EQ(points->GetFieldData()->GetArray("u_over_h")->GetComponent(0, 0), 0.02);
  EXPECT_EQ(points->GetFieldData()->GetArray("load_N")->GetComponent(0, 0), -5.0);
}

TEST_F(VtkWriter, KeepsDomainsAsQuadrilateralsWithTheFieldsAsCellData) {
  const Frame frame = two_points(0.25);
  SeriesWriter(directory).write(frame);

  const auto reader = read<vtkXMLPolyDataReader>(directory / "domains/domains_000000.vtp");
  vtkPolyData* domains = reader->GetOutput();
  ASSERT_EQ(domains->GetNumberOfPolys(), 2);
  EXPECT_EQ(values_of(domains->GetPoints()->GetData()), frame.corners);
  for (vtkIdType corner = 0; corner < 4; ++corner)
    EXPECT_EQ(domains->GetCell(1)->GetPointId(static_cast<int>(corner)), 4 + corner);
  expect_fields(domains->GetCellData(), frame);
}

TEST_F(VtkWriter, KeepsDomainsAsHexahedraInThreeDimensions) {
  const Frame frame = one_hexahedron();
  SeriesWriter(directory).write(frame);

  const auto reader = read<vtkXMLUnstructuredGridReader>(directory / "domains/domains_000000.vtu");
  vtkUnstructuredGrid* domains = reader->GetOutput();
  ASSERT_EQ(domains->GetNumberOfCells(), 1);
  EXPECT_EQ(domains->GetCellType(0), VTK_HEXAHEDRON);
  EXPECT_EQ(values_of(domains->GetPoints()->GetData()), frame.corners);
  expect_fields(domains->GetCellData(), frame);
}

TEST_F(VtkWriter, WritesBinaryAndNotAppendedData) {
  SeriesWriter writer(directory);
  writer.write(two_points(0));
  for (const char* file : {"points/points_000000.vtp", "domains/domains_000000.vtp"}) {
    const std::string text = text_of(directory / file);
    EXPECT_THAT(text, HasSubstr("format=\"binary\"")) << file;
    EXPECT_THAT(text, HasSubstr("vtkZLibDataCompressor")) << file;
    EXPECT_THAT(text, Not(HasSubstr("appended"))) << file;
  }
}

TEST_F(VtkWriter, NamesTheComponentsOfVectorsAndTensors) {
  Frame frame = two_points(0);
  frame.fields.push_back({"stress", 6, "Pa", std::vector<double>(12)});
  frame.fields.push_back({"deformation_gradient", 9, "-", std::vector<double>(18)});
  SeriesWriter(directory).write(frame);
  const auto reader = read<vtkXMLPolyDataReader>(directory / "points/points_000000.vtp");
  const auto names = [&](const char* field) {
    vtkDataArray* array = reader->GetOutput()->GetPointData()->GetArray(field);
    std::string text;
    for (int c = 0; array->HasAComponentName() && c < array->GetNumberOfComponents(); ++c)
      text += std::string(c == 0 ? "" : " ") + array->GetComponentName(c);
    return text;
  };
  EXPECT_EQ(names("velocity"), "X Y Z");
  EXPECT_EQ(names("stress"), "XX YY ZZ XY YZ XZ");
  EXPECT_EQ(names("deformation_gradient"), "XX XY XZ YX YY YZ ZX ZY ZZ");
  EXPECT_EQ(names("void_ratio"), "");
}

TEST_F(VtkWriter, ListsEveryTimeExactlyAndKeepsTheFirstFrame) {
  SeriesWriter writer(directory);
  writer.write(two_points(0));
  const std::string first = text_of(directory / "points/points_000000.vtp");
  writer.write(two_points(0.1));
  writer.write(two_points(1.0 / 3.0));

  EXPECT_EQ(writer.frames(), 3);
  for (const char* pvd : {"points.pvd", "domains.pvd"})
    EXPECT_EQ(times_in(directory / pvd), (std::vector<double>{0, 0.1, 1.0 / 3.0})) << pvd;
  EXPECT_THAT(text_of(directory / "domains.pvd"), HasSubstr("domains/domains_000002.vtp"));
  EXPECT_EQ(text_of(directory / "points/points_000000.vtp"), first);
}

TEST_F(VtkWriter, LeavesNoTemporaryFile) {
  SeriesWriter(directory).write(two_points(0));
  for (const auto& entry : fs::recursive_directory_iterator(directory))
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
}

TEST_F(VtkWriter, NamesTheDirectoryItCannotCreate) {
  fs::create_directories(directory);
  std::ofstream(directory / "file") << "in the way";
  try {
    SeriesWriter writer(directory / "file" / "out");
    FAIL() << "a directory below a regular file";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr((directory / "file" / "out").string()));
    EXPECT_THAT(error.what(), HasSubstr("Not a directory"));
  }
}

/// The temporary file links to a device that is always full.
TEST_F(VtkWriter, KeepsEarlierFramesAndTheirIndexWhenAFileCannotBeWritten) {
  SeriesWriter writer(directory);
  writer.write(two_points(0));
  const std::string index = text_of(directory / "points.pvd"), first = text_of(directory / "points/points_000000.vtp");
  const auto expect_refusal = [&](const std::string& file, const std::string& reason) {
    try {
      writer.write(two_points(1));
      FAIL() << file;
    } catch (const RunError& error) {
      EXPECT_THAT(error.what(), HasSubstr((directory / file).string()));
      EXPECT_THAT(error.what(), HasSubstr(reason));
    }
    EXPECT_EQ(text_of(directory / "points/points_000000.vtp"), first);
  };

  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit none{0, before.rlim_max}; // as on a full disk
  ::setrlimit(RLIMIT_FSIZE, &none);
  expect_refusal("points/points_000001.vtp", "File too large");
  ::setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(text_of(directory / "points.pvd"), index);
  for (const char* file : {"points/points_000001.vtp", "domains/domains_000001.vtp"}) {
    fs::create_directories(directory / file / "in the way");
    expect_refusal(file, "irectory");
    EXPECT_EQ(text_of(directory / "points.pvd"), index);
    fs::remove_all(directory / file);
  }
}

TEST_F(VtkWriter, RefusesAFieldOfTheWrongLength) {
  Frame frame = two_points(0);
  frame.fields[0].values.pop_back();
  EXPECT_THROW(SeriesWriter(directory).write(frame), std::logic_error);
}

} // namespace
} // namespace riedel
