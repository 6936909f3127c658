/// Frames that were written for ParaView, read back.
#include "core/base/error.hpp"
#include "core/io/vtk_reader.hpp"
#include "core/io/vtk_writer.hpp"
#include "temporary_folder.hpp"

#include <gmock/gmock.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

Frame two_squares() {
  Frame frame{.dimension = 2,
              .time = 0.5,
              .scalars = {{"u_over_h", 0.03}},
              .position = {0.5, 0.5, 0, 1.5, 0.5, 0},
              .corners = {},
              .fields = {}};
  for (const double x : {0.0, 1.0})
    frame.corners.insert(frame.corners.end(), {x, 0, 0, x + 1, 0, 0, x + 1, 1, 0, x, 1, 0});
  frame.fields.push_back({"void_ratio", 1, "-", {0.5, 0.75}});
  frame.fields.push_back({"velocity", 3, "m/s", {1, 2, 3, 4, 5, 6}});
  return frame;
}

TEST(FrameReader, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  SeriesWriter writer(folder.path());
  const Frame frame = two_squares();
  writer.write(frame);
  writer.write(frame);
  const auto files = frame_files(folder.path());
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].time, 0.5);
  const Frame again = read_frame(files[1].path);
  EXPECT_EQ(again.scalar("u_over_h"), 0.03);
  EXPECT_EQ(again.position, frame.position);
  EXPECT_EQ(again.corners, frame.corners);
  EXPECT_EQ(again.field("velocity").values, frame.fields[1].values);
  EXPECT_EQ(again.field("velocity").unit, "m/s");
}

/// Results of earlier versions have another compression.
TEST(FrameReader, ReadsWhatVtkHasCompressedOtherwise) {
  const TemporaryFolder folder;
  SeriesWriter(folder.path()).write(two_squares());
  const fs::path file = frame_files(folder.path())[0].path;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  for (const auto compressor : {vtkXMLWriter::LZ4, vtkXMLWriter::NONE}) {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(file.c_str());
    writer->SetInputData(reader->GetOutput());
    writer->SetDataModeToBinary();
    writer->SetCompressorType(compressor);
    writer->Write();
    EXPECT_EQ(file_content(file).find("vtkLZ4DataCompressor") != std::string::npos, compressor == vtkXMLWriter::LZ4);
    EXPECT_EQ(read_frame(file).field("void_ratio").values, two_squares().field("void_ratio").values);
  }
}

TEST(FrameReader, GivesBackBoxesInThreeDimensions) {
  const TemporaryFolder folder;
  Frame frame{.dimension = 3,
              .time = 0.5,
              .scalars = {{"u_over_h", 0.03}},
              .position = {0.5, 0.5, 1},
              .corners = {},
              .fields = {}};
  frame.corners = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 2, 1, 0, 2, 1, 1, 2, 0, 1, 2};
  frame.fields = {{"id", 1, "-", {7}, true}, {"void_ratio", 1, "-", {0.625}}};
  SeriesWriter(folder.path()).write(frame);
  const Frame again = read_frame(frame_files(folder.path()).at(0).path);
  EXPECT_EQ(again.dimension, 3);
  EXPECT_EQ(again.scalar("u_over_h"), 0.03);
  EXPECT_EQ(again.position, frame.position);
  EXPECT_EQ(again.corners, frame.corners);
  EXPECT_EQ(again.field("void_ratio").values, frame.fields[1].values);
  EXPECT_TRUE(again.field("id").whole);
  EXPECT_FALSE(again.field("void_ratio").whole);
}

TEST(FrameReader, NamesTheFileThatIsMissingOrDamaged) {
  const TemporaryFolder folder;
  EXPECT_TRUE(frame_files(folder.path()).empty());
  const auto error_of = [](const fs::path& path) -> std::string {
    try {
      (void)read_frame(path);
    } catch (const InputError& error) { return error.what(); }
    return "";
  };
  EXPECT_THAT(error_of(folder / "none.vtp"), HasSubstr("none.vtp: is missing"));
  SeriesWriter(folder.path()).write(two_squares());
  const fs::path file = frame_files(folder.path())[0].path;
  fs::resize_file(file, fs::file_size(file) / 2);
  EXPECT_THAT(error_of(file), HasSubstr("domains_000000.vtp: is damaged"));
  for (const char* entry : {"timestep=\"x\" file=\"a\"", "timestep=\"nan\" file=\"a\"", "timestep=\"1\" file=\"../a\"",
                            "timestep=\"1\" file=\"/a\"", "timestep=\"1\"", "file=\"a\""}) {
    folder.file("domains.pvd", "<VTKFile><Collection><DataSet " + std::string(entry) + "/></Collection></VTKFile>\n");
    EXPECT_THROW((void)frame_files(folder.path()), InputError) << entry;
  }
}

/// VTK's own reader ends the program when it meets the third of them.
TEST(FrameReader, RefusesEveryDamageToAFile) {
  const TemporaryFolder folder;
  SeriesWriter(folder.path()).write(two_squares());
  const std::string whole = file_content(frame_files(folder.path())[0].path);
  const auto damaged = [&](const std::string& what, const std::string& by) {
    const std::size_t at = whole.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return folder.file("damaged.vtp", whole.substr(0, at) + by + whole.substr(at + what.size()));
  };
  for (const auto& [what, by] :
       {std::pair{"vtkZLibDataCompressor", "vtkLZMADataCompressor"},
        {"vtkZLibDataCompressor", "vtkLZ4DataCompressor"},
        {"Float64", "Float63"},
        {"UInt32", "UInt64"},
        {"NumberOfPoints=\"8\"", "NumberOfPoints=\"4000000000\""},
        {"NumberOfPolys=\"2\"", "NumberOfPolys=\"-2\""},
        {"NumberOfComponents=\"3\"", "NumberOfComponents=\"0\""},
        {"format=\"binary\"", "format=\"appended\""},
        {"AQAAAACAAAAIAAAA", "AQAAAACAAAAJAAAA"}, // a block of nine bytes for a number of eight
        {"</PolyData>", ""}})
    EXPECT_THROW((void)read_frame(damaged(what, by)), InputError) << what << " -> " << by;
  for (std::size_t size = 0; size + 20 < whole.size(); size += 97)
    EXPECT_THROW((void)read_frame(folder.file("cut.vtp", whole.substr(0, size))), InputError) << size;
}

} // namespace
} // namespace riedel::test
