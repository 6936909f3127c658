#include "core/io/vtk_reader.hpp"

#include "core/base/error.hpp"
#include "core/io/input_file.hpp"
#include "core/io/packed_data.hpp"
#include "core/io/toml_words.hpp"
#include "core/io/xml.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace riedel {
namespace {

constexpr std::uintmax_t largest_frame = std::uintmax_t{4} << 30; ///< [bytes]

double real_in(const std::string& text) {
  double x = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size() || !std::isfinite(x))
    throw InputError("'" + text + "' instead of a number");
  return x;
}

std::size_t count_in(const XmlElement& element, const char* name, std::size_t otherwise) {
  const std::string text = element.attribute(name);
  if (text.empty()) return otherwise;
  std::uint32_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc{} || end != text.data() + text.size()) throw InputError("'" + text + "' instead of " + name);
  return count;
}

/// The file of a frame: in or below the folder of the index.
std::filesystem::path file_in(const XmlElement& entry) {
  const std::filesystem::path file = entry.attribute("file");
  if (file.empty() || file.is_absolute() || std::ranges::find(file, std::filesystem::path("..")) != file.end())
    throw InputError("'" + file.string() + "' is not a file below its folder");
  return file;
}

/// How the arrays of a file are compressed.
Unpack unpack_of(const XmlElement& file) {
  const std::string compressor = file.attribute("compressor");
  if (file.name != "VTKFile" || file.attribute("header_type") != "UInt32" ||
      file.attribute("byte_order") != "LittleEndian")
    throw InputError("it does not have the format of frames");
  if (compressor == "vtkZLibDataCompressor") return from_zlib;
  if (compressor == "vtkLZ4DataCompressor") return from_lz4; // written by earlier builds
  if (compressor.empty()) return nullptr;
  throw InputError("it is compressed by '" + compressor + "', but frames use zlib or LZ4");
}

/// The numbers of an array with the given number of rows.
std::vector<double> values_in(const XmlElement& array, std::size_t rows, std::size_t components, Unpack unpack) {
  const std::string type = array.attribute("type");
  const std::string_view text = trimmed(array.text);
  const std::size_t size = rows * components * size_of_type(type);
  constexpr std::size_t max_for_a_letter = 1032; // zlib's maximum
  if (array.attribute("format") != "binary" || size / max_for_a_letter > text.size())
    throw InputError("the array '" + array.attribute("Name") + "' does not hold the expected numbers");
  return numbers_of(unpacked(text, size, unpack), type);
}

/// Numbers that belong to the frame as a whole.
std::map<std::string, double> scalars_in(const XmlElement& data, Unpack unpack) {
  std::map<std::string, double> scalars;
  for (const XmlElement& each : data.children)
    if (each.name == "FieldData")
      for (const XmlElement& array : each.children)
        if (count_in(array, "NumberOfTuples", 0) == 1 && count_in(array, "NumberOfComponents", 1) == 1)
          scalars[array.attribute("Name")] = values_in(array, 1, 1, unpack).front();
  return scalars;
}

Field field_of(const XmlElement& array, std::size_t cells, Unpack unpack) {
  constexpr std::size_t max_components = 9;
  const std::size_t components = count_in(array, "NumberOfComponents", 1);
  if (components == 0 || components > max_components) throw InputError("an array with too many components");
  Field field{.name = array.attribute("Name"),
              .components = static_cast<int>(components),
              .unit = "",
              .values = values_in(array, cells, components, unpack),
              .whole = !array.attribute("type").starts_with("Float")};
  for (const XmlElement& key : array.children)
    if (key.name == "InformationKey" && key.attribute("name") == "UNITS_LABEL") field.unit = trimmed(key.text);
  return field;
}

/// The mean of the corners of every cell.
std::vector<double> middles(const std::vector<double>& corners, std::size_t corners_of_cell) {
  std::vector<double> position(corners.size() / corners_of_cell, 0.0);
  for (std::size_t i = 0; i < corners.size(); ++i)
    position[i / (3 * corners_of_cell) * 3 + i % 3] += corners[i] / static_cast<double>(corners_of_cell);
  return position;
}

Frame frame_of(const XmlElement& file, bool flat) {
  const Unpack unpack = unpack_of(file);
  const XmlElement &data = file.child(flat ? "PolyData" : "UnstructuredGrid"), &piece = data.child("Piece");
  const std::size_t corners = count_in(piece, "NumberOfPoints", 0);
  const std::size_t cells = count_in(piece, flat ? "NumberOfPolys" : "NumberOfCells", 0);
  Frame frame{
      .dimension = flat ? 2 : 3, .scalars = scalars_in(data, unpack), .position = {}, .corners = {}, .fields = {}};
  if (const auto time = frame.scalars.extract("TimeValue")) frame.time = time.mapped();
  const auto corners_of_cell = static_cast<std::size_t>(frame.corners_per_point());
  if (cells == 0 || corners != cells * corners_of_cell) throw InputError("it is not a file of domains");
  frame.corners = values_in(piece.child("Points").child("DataArray"), corners, 3, unpack);
  if (!std::ranges::all_of(frame.corners, [](double x) { return std::isfinite(x); }))
    throw InputError("a corner's position is not finite");
  frame.position = middles(frame.corners, corners_of_cell);
  for (const XmlElement& array : piece.child("CellData").children)
    frame.fields.push_back(field_of(array, cells, unpack));
  return frame;
}

} // namespace

std::vector<FrameFile> frame_files(const std::filesystem::path& folder) {
  const std::filesystem::path index = folder / "domains.pvd";
  std::vector<FrameFile> files;
  if (!std::filesystem::exists(index)) return files;
  const std::string text = read_input_file(index);
  try {
    const XmlElement file = read_xml(text);
    for (const XmlElement& entry : file.child("Collection").children)
      files.push_back({.time = real_in(entry.attribute("timestep")), .path = folder / file_in(entry)});
  } catch (const InputError& error) { throw InputError(index.string() + ": cannot be understood: " + error.what()); }
  return files;
}

Frame read_frame(const std::filesystem::path& path) {
  const bool flat = path.extension() == ".vtp";
  if (!flat && path.extension() != ".vtu") throw InputError(path.string() + ": is not a frame (.vtp or .vtu)");
  if (!std::filesystem::is_regular_file(path)) throw InputError(path.string() + ": is missing or not a file");
  const std::string text = read_input_file(path, largest_frame);
  try {
    return frame_of(read_xml(text), flat);
  } catch (const InputError& error) { throw InputError(path.string() + ": is damaged: " + error.what()); }
}

} // namespace riedel
