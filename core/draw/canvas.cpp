#include "core/draw/canvas.hpp"

#include "core/base/error.hpp"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

namespace riedel {
namespace {

constexpr int dots_per_inch = 72; ///< a font's size is then its height in pixels

/// The fonts built into VTK have no Greek letters and leave them blank, so a font file is preferred if the system has
/// one: DejaVu Sans (Debian's fonts-dejavu-core) covers Greek, subscripts and mathematical signs.
std::string font_file() {
  for (const char* file :
       {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
        "/usr/share/fonts/TTF/DejaVuSans.ttf"}) {
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) return file;
  }
  return {};
}

/// The letters used in our labels, transcribed to those of VTK's own font.
std::string spelled_out(std::string text) {
  constexpr std::array<std::pair<const char*, const char*>, 21> spelling{{
      {"α", "alpha"},  {"β", "beta"}, {"γ", "gamma"}, {"δ", "delta"}, {"Δ", "Delta"}, {"ε", "epsilon"}, {"θ", "theta"},
      {"λ", "lambda"}, {"μ", "mu"},   {"ν", "nu"},    {"ρ", "rho"},   {"σ", "sigma"}, {"τ", "tau"},     {"φ", "phi"},
      {"ψ", "psi"},    {"₀", "0"},    {"₁", "1"},     {"₂", "2"},     {"₃", "3"},     {"‖", "|"},       {"…", "..."},
  }};
  for (const auto& [sign, letters] : spelling)
    for (std::size_t at = 0; (at = text.find(sign, at)) != std::string::npos;)
      text.replace(at, std::char_traits<char>::length(sign), letters);
  return text;
}

vtkNew<vtkTextProperty> font(double size) {
  static const std::string file = font_file();
  vtkNew<vtkTextProperty> property;
  property->SetFontSize(std::max(1, static_cast<int>(std::lround(size))));
  if (file.empty()) {
    property->SetFontFamilyToArial();
  } else {
    property->SetFontFamily(VTK_FONT_FILE);
    property->SetFontFile(file.c_str());
  }
  return property;
}

vtkStdString drawable(const std::string& text) {
  static const bool greek = !font_file().empty();
  return greek ? text : spelled_out(text);
}

} // namespace

double text_width(const std::string& text, double size) {
  if (text.empty()) return 0;
  constexpr double fine = 100; // measured at a large size, since font sizes are whole pixels
  std::array<int, 4> box{};
  vtkTextRenderer::GetInstance()->GetBoundingBox(font(fine), drawable(text), box.data(), dots_per_inch,
                                                 vtkTextRenderer::FreeType);
  return (box[1] - box[0] + 1) * size / fine;
}

TextMask text_mask(const std::string& text, double size) {
  TextMask mask;
  if (text.empty()) return mask;
  const auto property = font(size);
  vtkNew<vtkImageData> image;
  std::array<int, 2> used{};
  vtkTextRenderer::Metrics metrics;
  auto* renderer = vtkTextRenderer::GetInstance();
  if (!renderer->RenderString(property, drawable(text), image, used.data(), dots_per_inch, vtkTextRenderer::FreeType) ||
      !renderer->GetMetrics(property, drawable(text), metrics, dots_per_inch, vtkTextRenderer::FreeType))
    throw RunError("VTK could not draw the text '" + text + "'");
  // Image rows count upwards from the lower edge of the line of text, and may begin below it.
  const int* extent = image->GetExtent();
  const int base_line = -metrics.Descent.GetY();
  mask.width = used[0];
  mask.height = used[1];
  mask.baseline = extent[2] + used[1] - base_line;
  mask.cover.resize(static_cast<std::size_t>(mask.width) * static_cast<std::size_t>(mask.height));
  auto out = mask.cover.begin();
  for (int row = mask.height - 1; row >= 0; --row)
    for (int column = 0; column < mask.width; ++column)
      *out++ = static_cast<unsigned char*>(image->GetScalarPointer(extent[0] + column, extent[2] + row, 0))[3];
  return mask;
}

std::string encode_png(int width, int height, const std::vector<unsigned char>& rgb) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const std::ptrdiff_t row = std::ptrdiff_t{3} * width;
  for (int y = 0; y < height; ++y)
    std::copy_n(rgb.begin() + y * row, row, static_cast<unsigned char*>(image->GetScalarPointer(0, height - 1 - y, 0)));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  const vtkUnsignedCharArray* bytes = writer->GetResult();
  if (writer->GetErrorCode() != 0 || bytes == nullptr) throw RunError("VTK could not encode a picture");
  auto* data = writer->GetResult();
  return {reinterpret_cast<const char*>(data->GetPointer(0)), static_cast<std::size_t>(data->GetNumberOfValues())};
}

} // namespace riedel
