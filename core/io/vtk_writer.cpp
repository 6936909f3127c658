#include "core/io/vtk_writer.hpp"

#include "core/base/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/with_vtk.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <new>
#include <numeric>

namespace riedel {
namespace {

vtkNew<vtkPoints> coordinates(const std::vector<double>& xyz) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(xyz.size() / 3));
  std::copy(xyz.begin(), xyz.end(), static_cast<double*>(points->GetVoidPointer(0)));
  return points;
}

/// Cells that share no corner: the first uses the first `corners` points, and so on.
vtkNew<vtkCellArray> separate_cells(std::size_t cells, int corners) {
  vtkNew<vtkIdTypeArray> corner;
  corner->SetNumberOfValues(static_cast<vtkIdType>(cells) * corners);
  std::iota(corner->Begin(), corner->End(), vtkIdType{0});
  vtkNew<vtkCellArray> array;
  array->SetData(corners, corner);
  return array;
}

/// Names shown by ParaView for the components of vectors, symmetric and full tensors; empty: it numbers them.
std::vector<std::string> component_names(int components) {
  switch (components) {
  case 3:
    return {"X", "Y", "Z"};
  case 6:
    return {"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
  case 9:
    return {"XX", "XY", "XZ", "YX", "YY", "YZ", "ZX", "ZY", "ZZ"};
  default:
    return {};
  }
}

/// The field as an array of floats or integers.
template <class Array>
vtkNew<Array> array_of(const Field& field) {
  vtkNew<Array> array;
  array->SetNumberOfComponents(field.components);
  array->SetNumberOfValues(static_cast<vtkIdType>(field.values.size()));
  std::transform(field.values.begin(), field.values.end(), array->Begin(),
                 [](double value) { return static_cast<typename Array::ValueType>(value); });
  return array;
}

void add_fields(const Frame& frame, vtkDataSetAttributes* target) {
  const auto add = [&](const Field& field, vtkDataArray* array) {
    array->SetName(field.name.c_str());
    const std::vector<std::string> names = component_names(field.components);
    for (std::size_t c = 0; c < names.size(); ++c) array->SetComponentName(static_cast<vtkIdType>(c), names[c].c_str());
    if (!field.unit.empty()) array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), field.unit.c_str());
    target->AddArray(array);
  };
  for (const Field& field : frame.fields) {
    if (field.whole)
      add(field, array_of<vtkTypeInt64Array>(field));
    else
      add(field, array_of<vtkFloatArray>(field));
  }
}

void add_number(vtkDataSet* data, const char* name, double value) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  data->GetFieldData()->AddArray(array);
}

/// The file's bytes. Binary, not appended: ParaView 5.11 opens appended data as 0 points. Compressed by zlib, which all
/// readers of the format support, at its fastest: higher levels save a few per cent and take at least twice as long.
template <class Writer>
std::string encode(const Frame& frame, vtkDataSet* data) {
  add_number(data, "TimeValue", frame.time);
  for (const auto& [name, value] : frame.scalars) add_number(data, name.c_str(), value);
  vtkNew<Writer> writer;
  writer->SetInputDataObject(data);
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToZLib();
  writer->SetCompressionLevel(1);
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0 || writer->GetErrorCode() != 0) throw RunError("VTK could not encode a frame");
  return writer->GetOutputString();
}

std::string encode_points(const Frame& frame) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(coordinates(frame.position));
  data->SetVerts(separate_cells(frame.points(), 1));
  add_fields(frame, data->GetPointData());
  return encode<vtkXMLPolyDataWriter>(frame, data);
}

std::string encode_quads(const Frame& frame) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(coordinates(frame.corners));
  data->SetPolys(separate_cells(frame.points(), frame.corners_per_point()));
  add_fields(frame, data->GetCellData());
  return encode<vtkXMLPolyDataWriter>(frame, data);
}

std::string encode_hexahedra(const Frame& frame) {
  vtkNew<vtkUnstructuredGrid> data;
  data->SetPoints(coordinates(frame.corners));
  data->SetCells(VTK_HEXAHEDRON, separate_cells(frame.points(), frame.corners_per_point()));
  add_fields(frame, data->GetCellData());
  return encode<vtkXMLUnstructuredGridWriter>(frame, data);
}

std::string file_name(const std::string& series, std::size_t number, const char* extension) {
  std::array<char, 24> digits{};
  std::snprintf(digits.data(), digits.size(), "_%06zu", number);
  return series + "/" + series + digits.data() + extension;
}

/// The shortest digits that read back as the same number, in any locale.
std::string digits_of(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

void make_directory(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_symlink(path, error)) // frames would be written, and old ones left, elsewhere
    throw InputError("cannot create the folder " + path.string() + ": is a symbolic link");
  std::filesystem::create_directories(path, error);
  if (error) throw InputError("cannot create the folder " + path.string() + ": " + error.message());
}

/// VTK does not survive a lack of memory, so this is checked first: for its arrays, and texts that grow by doubling.
/// @throws std::bad_alloc
void require_room(const Frame& frame) {
  constexpr std::size_t spare = std::size_t{16}
                                << 20U; // for its objects, compressor, and the threads that it starts first
  std::size_t numbers = frame.position.size() + 2 * frame.corners.size();
  for (const Field& field : frame.fields) numbers += field.values.size();
  ::operator delete(::operator new(4 * sizeof(double) * numbers + spare)); // a direct call is never optimised away
}

} // namespace

bool with_vtk() { return true; }

SeriesWriter::SeriesWriter(std::filesystem::path directory) : directory_(std::move(directory)) {
  make_directory(directory_ / "points");
  make_directory(directory_ / "domains");
}

void SeriesWriter::write(const Frame& frame) {
  frame.check();
  require_room(frame);
  const bool flat = frame.dimension == 2, with_domains = !frame.corners.empty();
  const std::string points_file = file_name("points", points_.size(), ".vtp");
  const std::string domains_file = file_name("domains", points_.size(), flat ? ".vtp" : ".vtu");
  write_atomically(directory_ / points_file, encode_points(frame));
  if (with_domains) write_atomically(directory_ / domains_file, flat ? encode_quads(frame) : encode_hexahedra(frame));

  // Only files that are on the disk are listed.
  points_.push_back({frame.time, points_file});
  if (with_domains) domains_.push_back({frame.time, domains_file});
  write_index("points.pvd", points_);
  if (with_domains) write_index("domains.pvd", domains_);
}

void SeriesWriter::write_index(const std::string& name, const std::vector<Entry>& entries) const {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
  for (const Entry& entry : entries)
    text += "    <DataSet timestep=\"" + digits_of(entry.time) + "\" part=\"0\" file=\"" + entry.file + "\"/>\n";
  write_atomically(directory_ / name, text + "  </Collection>\n</VTKFile>\n");
}

} // namespace riedel
