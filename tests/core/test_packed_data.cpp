/// XML and packed numbers, as far as frames hold them.
#include "core/base/error.hpp"
#include "core/io/packed_data.hpp"
#include "core/io/xml.hpp"

#include <gmock/gmock.h>

namespace riedel {
namespace {

using testing::ElementsAre;

std::string bytes(std::initializer_list<int> values) {
  std::string text;
  for (const int value : values) text += static_cast<char>(value);
  return text;
}

TEST(Base64, GivesTheBytes) { // the vectors of RFC 4648
  EXPECT_EQ(from_base64(""), "");
  EXPECT_EQ(from_base64("Zg=="), "f");
  EXPECT_EQ(from_base64("Zm8="), "fo");
  EXPECT_EQ(from_base64("Zm9v"), "foo");
  EXPECT_EQ(from_base64("Zm9vYmE="), "fooba");
  EXPECT_EQ(from_base64("+/+/"), bytes({0xfb, 0xff, 0xbf}));
}

TEST(Base64, RefusesWhatIsNone) {
  for (const char* text : {"Z", "Zm9", "Z===", "====", "Zg==Zg==", "Zm=v", "Zm9v\n", "Zm9*", "Zg=a"})
    EXPECT_THROW((void)from_base64(text), InputError) << text;
}

TEST(Lz4, GivesLiteralsAndRepeats) {
  EXPECT_EQ(from_lz4(bytes({0x50}) + "hello", 5), "hello");
  EXPECT_EQ(from_lz4(bytes({0x13, 'a', 1, 0, 0x50}) + "bbbbb", 13), "aaaaaaaabbbbb"); // reaches into what it writes
  EXPECT_EQ(from_lz4(bytes({0xF0, 1}) + std::string(16, 'x'), 16), std::string(16, 'x'));
  EXPECT_EQ(from_lz4(bytes({0x1F, 'a', 1, 0, 255, 0, 0x10, 'b'}), 276), std::string(275, 'a') + "b");
}

TEST(Lz4, RefusesWhatHoldsSomethingElse) {
  EXPECT_THROW((void)from_lz4(bytes({0x50}) + "hell", 5), InputError);              // cut off
  EXPECT_THROW((void)from_lz4(bytes({0x50}) + "hello", 4), InputError);             // too long
  EXPECT_THROW((void)from_lz4(bytes({0x50}) + "hello", 6), InputError);             // too short
  EXPECT_THROW((void)from_lz4(bytes({0x13, 'a', 2, 0, 0x10, 'b'}), 9), InputError); // from before the beginning
  EXPECT_THROW((void)from_lz4(bytes({0x13, 'a', 0, 0, 0x10, 'b'}), 9), InputError);
  EXPECT_THROW((void)from_lz4(bytes({0x13, 'a', 1}), 8), InputError);
  EXPECT_THROW((void)from_lz4(bytes({0x1F, 'a', 1, 0, 255}), 8), InputError);
  EXPECT_THROW((void)from_lz4(bytes({0xFF, 255}), 8), InputError);
}

TEST(Zlib, GivesWhatWasDeflated) { // "hello", as zlib's own programs write it
  const std::string block = bytes({0x78, 0x9c, 0xcb, 0x48, 0xcd, 0xc9, 0xc9, 0x07, 0x00, 0x06, 0x2c, 0x02, 0x15});
  EXPECT_EQ(from_zlib(block, 5), "hello");
  EXPECT_THROW((void)from_zlib(block, 4), InputError);
  EXPECT_THROW((void)from_zlib(block, 6), InputError);
  for (std::size_t i = 0; i < block.size(); ++i) EXPECT_THROW((void)from_zlib(block.substr(0, i), 5), InputError) << i;
}

TEST(PackedNumbers, AreTheNumbers) {
  const std::string one = bytes({0, 0, 0x80, 0x3f});
  EXPECT_THAT(numbers_of(one + bytes({0, 0, 0, 0xc0}), "Float32"), ElementsAre(1.0, -2.0));
  EXPECT_THAT(numbers_of(bytes({1, 0xff}), "UInt8"), ElementsAre(1.0, 255.0));
  EXPECT_THROW((void)size_of_type("Float63"), InputError);
  // one block of 4 bytes in a block of 32768, 5 bytes when packed: a literal run
  EXPECT_EQ(unpacked("AQAAAACAAAAEAAAABQAAAA==QAAAgD8=", 4, from_lz4), one);
  for (const char* text :
       {"", "AQAAAACAAAAEAAAABQAAAA==", "/////wCAAAAEAAAABQAAAA==QAAAgD8=", "AQAAAACAAAAEAAAABgAAAA==QAAAgD8="})
    EXPECT_THROW((void)unpacked(text, 4, from_lz4), InputError) << text;
  EXPECT_THROW((void)unpacked("AQAAAACAAAAEAAAABQAAAA==QAAAgD8=", 8, from_lz4), InputError);
  EXPECT_EQ(unpacked("BAAAAAAAgD8=", 4, nullptr), one); // not compressed
  EXPECT_THROW((void)unpacked("BQAAAAAAgD8=", 4, nullptr), InputError);
}

TEST(Xml, GivesElementsAttributesAndText) {
  const std::string text = "<?xml version='1.0'?>\n<!-- <a> -->\n<a b=\"1 &lt; 2\" c='\"'> x <d/><e>y</e></a>\n";
  const XmlElement root = read_xml(text);
  EXPECT_EQ(root.name, "a");
  EXPECT_EQ(root.attribute("b"), "1 < 2");
  EXPECT_EQ(root.attribute("c"), "\"");
  EXPECT_EQ(root.attribute("d"), "");
  EXPECT_EQ(root.text, " x ");
  EXPECT_EQ(root.child("e").text, "y");
  EXPECT_THROW((void)root.child("f"), InputError);
}

TEST(Xml, RefusesWhatDoesNotCloseOrNestsTooDeep) {
  for (const char* text : {"", "<", "<a", "<a>", "<a></b>", "<a b></a>", "<a b=1></a>", "<a b='1></a>", "<a/><b/>",
                           "<a/>x", "<!DOCTYPE a><a/>", "<a><!-- </a>", "<a></a"})
    EXPECT_THROW((void)read_xml(text), InputError) << text;
  std::string deep;
  for (int i = 0; i < 300000; ++i) deep += "<a>";
  EXPECT_THROW((void)read_xml(deep), InputError);
}

} // namespace
} // namespace riedel
