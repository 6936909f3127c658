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
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace riedel {
namespace {

constexpr std::size_t corners_of_quad = 4;

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
              .values = {}};
  if (vtkInformation* information = array.GetInformation(); information->Has(vtkDataArray::UNITS_LABEL()) != 0)
    field.unit = information->Get(vtkDataArray::UNITS_LABEL());
  field.values.reserve(static_cast<std::size_t>(array.GetNumberOfValues()));
  for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i)
    for (int c = 0; c < field.components; ++c) field.values.push_back(array.GetComponent(i, c));
  return field;
}

/// The mean of every four corners.
std::vector<double> middles(const std::vector<double>& corners) {
  std::vector<double> position(corners.size() / corners_of_quad, 0.0);
  for (std::size_t i = 0; i < corners.size(); ++i)
    position[i / (3 * corners_of_quad) * 3 + i % 3] += corners[i] / corners_of_quad;
  return position;
}

Frame frame_of(vtkPolyData& data) {
  Frame frame{.dimension = 2,
              .time = number_in(data.GetFieldData(), "TimeValue"),
              .u_over_h = number_in(data.GetFieldData(), "u_over_h"),
              .position = {},
              .corners = {},
              .fields = {}};
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i)
    for (int a = 0; a < 3; ++a) frame.corners.push_back(data.GetPoint(i)[a]);
  frame.position = middles(frame.corners);
  for (int a = 0; a < data.GetCellData()->GetNumberOfArrays(); ++a)
    if (vtkDataArray* array = data.GetCellData()->GetArray(a)) frame.fields.push_back(field_of(*array));
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
  if (path.extension() != ".vtp") throw InputError(path.string() + ": is no frame in two dimensions");
  if (!std::filesystem::is_regular_file(path)) throw InputError(path.string() + ": is missing, or no file");
  const Silence silence;
  vtkNew<vtkXMLPolyDataReader> reader;
  vtkNew<Listener> listener;
  for (const auto event : {vtkCommand::ErrorEvent, vtkCommand::WarningEvent}) reader->AddObserver(event, listener);
  reader->SetFileName(path.c_str());
  reader->Update();
  Frame frame = frame_of(*reader->GetOutput());
  if (listener->heard_error || frame.points() == 0 || frame.corners.size() % (3 * corners_of_quad) != 0 ||
      !std::ranges::all_of(frame.corners, [](double x) { return std::isfinite(x); }))
    throw InputError(path.string() + ": is damaged, or no file of domains");
  try {
    frame.check();
  } catch (const std::logic_error& error) { throw InputError(path.string() + ": is damaged: " + error.what()); }
  return frame;
}

} // namespace riedel
