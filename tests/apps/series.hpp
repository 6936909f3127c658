/// A time series for ParaView, read back with VTK.
#pragma once

#include "support/patterns.hpp"
#include "temporary_folder.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

namespace riedel::test {

/// One frame, kept by its reader.
class VtkFrame {
public:
  VtkFrame(const std::filesystem::path& file, double time) : time_(time) {
    reader_->SetFileName(file.c_str());
    reader_->Update();
  }
  [[nodiscard]] double listed_time() const { return time_; } ///< in the .pvd file
  [[nodiscard]] double number(const char* name) { return data()->GetFieldData()->GetArray(name)->GetComponent(0, 0); }
  [[nodiscard]] vtkPolyData* data() { return reader_->GetOutput(); }
  [[nodiscard]] vtkDataArray* at_points(const char* field) { return data()->GetPointData()->GetArray(field); }
  [[nodiscard]] vtkDataArray* at_cells(const char* field) { return data()->GetCellData()->GetArray(field); }

private:
  vtkNew<vtkXMLPolyDataReader> reader_;
  double time_;
};

/// The frames that a .pvd file lists.
inline std::vector<std::unique_ptr<VtkFrame>> read_series(const std::filesystem::path& pvd) {
  const std::string text = file_content(pvd);
  const std::string entry = R"re(<DataSet timestep="([^"]+)" part="0" file="([^"]+)"/>)re";
  std::vector<std::unique_ptr<VtkFrame>> frames;
  for (const auto& match : matches_in(text, entry))
    frames.push_back(std::make_unique<VtkFrame>(pvd.parent_path() / match[2], std::stod(match[1])));
  return frames;
}

} // namespace riedel::test
