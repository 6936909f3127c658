/// A PNG read back, for tests of what was drawn.
#pragma once

#include <filesystem>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

namespace riedel {

class PngPixels {
public:
  explicit PngPixels(const std::filesystem::path& path) {
    reader_->SetFileName(path.c_str());
    reader_->Update();
  }
  [[nodiscard]] int width() { return reader_->GetOutput()->GetDimensions()[0]; }
  [[nodiscard]] int height() { return reader_->GetOutput()->GetDimensions()[1]; }
  /// Colour as 0xRRGGBB; rows count from the top.
  [[nodiscard]] unsigned at(int x, int y) {
    const auto* rgb = static_cast<unsigned char*>(reader_->GetOutput()->GetScalarPointer(x, height() - 1 - y, 0));
    return (unsigned{rgb[0]} << 16U) | (unsigned{rgb[1]} << 8U) | rgb[2];
  }
  /// Pixels of that colour in a row.
  [[nodiscard]] int count_in_row(int y, unsigned color) {
    int count = 0;
    for (int x = 0; x < width(); ++x) count += at(x, y) == color ? 1 : 0;
    return count;
  }

private:
  vtkNew<vtkPNGReader> reader_;
};

} // namespace riedel
