#include "core/io/vtk_reader.hpp"

#include "core/base/error.hpp"
#include "core/io/input_file.hpp"

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace riedel {
namespace {

/// Notes that something went wrong.
class Listener final : public vtkCommand {
public:
  static Listener* New() { return new Listener; }
  void Execute(vtkObject* /*caller*/, unsigned long event, void* /*data*/) override {
    heard_error = heard_error || event == vtkCommand::ErrorEvent;
  }
  bool heard_error = false;
};

/// While it lives, VTK prints nothing.
class Silence {
public:
  Silence() { vtkObject::GlobalWarningDisplayOff(); }
  ~Silence() { vtkObject::SetGlobalWarningDisplay(before_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  vtkTypeBool before_ = vtkObject::GetGlobalWarningDisplay();
};

/// The text of an attribute in a line of XML; empty if it is not there.
std::string attribute(const std::string& line, const std::string& name) {
  const std::size_t start = line.find(name + "=\"");
  if (start == std::string::npos) return "";
  const std::size_t from = start + name.size() + 2;
  return line.substr(from, line.find('"', from) - from);
}

/// Below the folder that it is told in, as frames are: "../" leads elsewhere.
bool stays_inside(const std::filesystem::path& path) {
  return path.is_relative() && std::ranges::find(path, std::filesystem::path("..")) == path.end();
}

double number_in(vtkFieldData* data, const char* name) {
  vtkDataArray* array = data->GetArray(name);
  return array != nullptr && array->GetNumberOfTuples() > 0 ? array->GetTuple1(0) : 0.0;
}

Field field_of(vtkDataArray& array) {
  Field field{.name = array.GetName() == nullptr ? "" : array.GetName(),
              .components = array.GetNumberOfComponents(),
              .unit = "",
              .values = {},
              .whole = array.GetDataType() != VTK_FLOAT && array.GetDataType() != VTK_DOUBLE};
  if (vtkInformation* information = array.GetInformation(); information->Has(vtkDataArray::UNITS_LABEL()) != 0)
    field.unit = information->Get(vtkDataArray::UNITS_LABEL());
  field.values.reserve(static_cast<std::size_t>(array.GetNumberOfValues()));
  for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i)
    for (int c = 0; c < field.components; ++c) field.values.push_back(array.GetComponent(i, c));
  return field;
}

/// The mean of the corners of every cell.
std::vector<double> middles(const std::vector<double>& corners, std::size_t corners_of_cell) {
  std::vector<double> position(corners.size() / corners_of_cell, 0.0);
  for (std::size_t i = 0; i < corners.size(); ++i)
    position[i / (3 * corners_of_cell) * 3 + i % 3] += corners[i] / static_cast<double>(corners_of_cell);
  return position;
}

Frame frame_of(vtkPointSet& data, int dimension) {
  Frame frame{.dimension = dimension,
              .time = number_in(data.GetFieldData(), "TimeValue"),
              .u_over_h = number_in(data.GetFieldData(), "u_over_h"),
              .position = {},
              .corners = {},
              .fields = {}};
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i)
    for (int a = 0; a < 3; ++a) frame.corners.push_back(data.GetPoint(i)[a]);
  const auto corners_of_cell = static_cast<std::size_t>(frame.corners_per_point());
  if (frame.corners.size() % (3 * corners_of_cell) != 0) return frame;
  frame.position = middles(frame.corners, corners_of_cell);
  for (int a = 0; a < data.GetCellData()->GetNumberOfArrays(); ++a)
    if (vtkDataArray* array = data.GetCellData()->GetArray(a)) frame.fields.push_back(field_of(*array));
  return frame;
}

/// @throws InputError where VTK finds the file damaged
template <class Reader>
Frame read_with(const std::filesystem::path& path, int dimension) {
  const Silence silence;
  vtkNew<Reader> reader;
  vtkNew<Listener> listener;
  for (const auto event : {vtkCommand::ErrorEvent, vtkCommand::WarningEvent}) reader->AddObserver(event, listener);
  reader->SetFileName(path.c_str());
  reader->Update();
  Frame frame = frame_of(*reader->GetOutput(), dimension);
  if (listener->heard_error || frame.points() == 0)
    throw InputError(path.string() + ": is damaged, or no file of domains");
  return frame;
}

} // namespace

std::vector<FrameFile> frame_files(const std::filesystem::path& folder) {
  const std::filesystem::path index = folder / "domains.pvd";
  std::vector<FrameFile> files;
  if (!std::filesystem::exists(index)) return files;
  std::istringstream text(read_input_file(index));
  for (std::string line; std::getline(text, line);) {
    if (line.find("<DataSet") == std::string::npos) continue;
    const std::string time = attribute(line, "timestep"), name = attribute(line, "file");
    FrameFile entry{.path = folder / name};
    const auto [end, error] = std::from_chars(time.data(), time.data() + time.size(), entry.time);
    if (name.empty() || !stays_inside(name) || error != std::errc{} || end != time.data() + time.size() ||
        !std::isfinite(entry.time))
      throw InputError(index.string() + ": cannot be understood: " + line);
    files.push_back(std::move(entry));
  }
  return files;
}

Frame read_frame(const std::filesystem::path& path) {
  const bool flat = path.extension() == ".vtp";
  if (!flat && path.extension() != ".vtu")
    throw InputError(path.string() + ": is no frame, which ends in .vtp or .vtu");
  if (!std::filesystem::is_regular_file(path)) throw InputError(path.string() + ": is missing, or no file");
  Frame frame = flat ? read_with<vtkXMLPolyDataReader>(path, 2) : read_with<vtkXMLUnstructuredGridReader>(path, 3);
  if (!std::ranges::all_of(frame.corners, [](double x) { return std::isfinite(x); }))
    throw InputError(path.string() + ": is damaged, or no file of domains");
  try {
    frame.check();
  } catch (const std::logic_error& error) { throw InputError(path.string() + ": is damaged: " + error.what()); }
  return frame;
}

} // namespace riedel
