#include "core/io/packed_data.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <zlib.h>

namespace riedel {

static_assert(std::endian::native == std::endian::little, "the headers of blocks are read in the byte order of memory");

namespace {

[[noreturn]] void refuse(const char* why) { throw InputError(why); }

int value_of(char letter) {
  if (letter >= 'A' && letter <= 'Z') return letter - 'A';
  if (letter >= 'a' && letter <= 'z') return letter - 'a' + 26;
  if (letter >= '0' && letter <= '9') return letter - '0' + 52;
  if (letter == '+') return 62;
  if (letter == '/') return 63;
  refuse("a character that is not base 64");
}

/// A length that continues in further bytes while they are 255.
std::size_t length_in(std::string_view block, std::size_t& at, unsigned nibble) {
  std::size_t length = nibble;
  for (unsigned next = nibble == 15 ? 255 : 0; next == 255; length += next) {
    if (at == block.size()) refuse("a block that ends within a length");
    next = static_cast<unsigned char>(block[at++]);
  }
  return length;
}

/// Repeats the bytes from `back` before the end on; the source may overlap the output.
void repeat(std::string& bytes, std::size_t back, std::size_t length) {
  if (back == 0 || back > bytes.size()) refuse("a block that repeats missing data");
  for (std::size_t from = bytes.size() - back; length > 0; --length) bytes += bytes[from++];
}

std::uint32_t word_at(std::string_view bytes, std::size_t number) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + number * sizeof word, sizeof word);
  return word;
}

constexpr std::size_t word = sizeof(std::uint32_t);

/// What follows a length in one word, and must have that length.
std::string after_length(std::string bytes, std::size_t size) {
  if (bytes.size() != size + word || word_at(bytes, 0) != size) refuse("data whose size differs from that stated");
  return bytes.substr(word);
}

template <class Number>
std::vector<double> as_doubles(std::string_view bytes) {
  std::vector<double> numbers(bytes.size() / sizeof(Number));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    Number number{};
    std::memcpy(&number, bytes.data() + i * sizeof number, sizeof number);
    numbers[i] = static_cast<double>(number);
  }
  return numbers;
}

struct Type {
  std::string_view name;
  std::size_t size;
  std::vector<double> (*read)(std::string_view);
};
constexpr std::array<Type, 5> types{{{"Float32", 4, as_doubles<float>},
                                     {"Float64", 8, as_doubles<double>},
                                     {"Int32", 4, as_doubles<std::int32_t>},
                                     {"Int64", 8, as_doubles<std::int64_t>},
                                     {"UInt8", 1, as_doubles<std::uint8_t>}}};

const Type& type_named(std::string_view name) {
  const auto found = std::ranges::find(types, name, &Type::name);
  if (found == types.end()) throw InputError("unknown number type '" + std::string(name) + "'");
  return *found;
}

/// Number of base-64 letters for this many bytes, including the padding of the last group.
std::size_t letters_for(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

} // namespace

std::string from_base64(std::string_view letters) {
  if (letters.size() % 4 != 0) refuse("base-64 text that is not in groups of four");
  std::string bytes;
  bytes.reserve(letters.size() / 4 * 3);
  for (std::size_t i = 0; i < letters.size(); i += 4) {
    const std::string_view group = letters.substr(i, 4);
    const std::size_t filled = std::min(group.find('='), group.size());
    if (filled < 2 || (filled < 4 && i + 4 < letters.size()) ||
        group.substr(filled) != std::string_view("==").substr(0, 4 - filled))
      refuse("an incomplete group of base 64");
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 4; ++k)
      bits = bits << 6U | static_cast<std::uint32_t>(k < filled ? value_of(group[k]) : 0);
    for (std::size_t k = 0; k + 1 < filled; ++k) bytes += static_cast<char>(bits >> (16U - 8U * k) & 0xFFU);
  }
  return bytes;
}

std::string from_lz4(std::string_view block, std::size_t size) {
  std::string bytes;
  bytes.reserve(size);
  for (std::size_t at = 0; at < block.size();) {
    const auto token = static_cast<unsigned char>(block[at++]);
    const std::size_t literals = length_in(block, at, token >> 4U);
    if (literals > block.size() - at || literals > size - bytes.size()) refuse("a block that is cut off or too long");
    bytes += block.substr(at, literals);
    at += literals;
    if (at == block.size()) break; // the last sequence repeats nothing
    if (block.size() - at < 2) refuse("a block that is cut off");
    const std::size_t back = static_cast<unsigned char>(block[at]) + 256U * static_cast<unsigned char>(block[at + 1]);
    at += 2;
    constexpr std::size_t shortest = 4;
    const std::size_t length = length_in(block, at, token & 15U) + shortest;
    if (length > size - bytes.size()) refuse("a block that is too long");
    repeat(bytes, back, length);
  }
  if (bytes.size() != size) refuse("a block that is too short");
  return bytes;
}

std::string from_zlib(std::string_view block, std::size_t size) {
  std::string bytes(size, '\0');
  uLongf length = size;
  const int end = ::uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                               reinterpret_cast<const Bytef*>(block.data()), block.size());
  if (end != Z_OK || length != size) refuse("a block with other contents than stated");
  return bytes;
}

std::string unpacked(std::string_view text, std::size_t size, Unpack unpack) {
  if (unpack == nullptr) return after_length(from_base64(text), size);
  if (text.size() < letters_for(word)) refuse("data without a header");
  constexpr std::size_t fixed = 3; // blocks, bytes in each, bytes in the last if incomplete
  const std::size_t blocks = word_at(from_base64(text.substr(0, letters_for(word))), 0);
  const std::size_t in_header = letters_for(word * (fixed + blocks));
  if (text.size() < in_header) refuse("data with an incomplete header");
  const std::string header = from_base64(text.substr(0, in_header));
  const std::string data = from_base64(text.substr(in_header));
  const std::size_t full = word_at(header, 1), last = word_at(header, 2);
  std::string bytes;
  std::size_t at = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t packed = word_at(header, fixed + b), wanted = b + 1 == blocks && last != 0 ? last : full;
    if (packed > data.size() - at || wanted > size - bytes.size()) refuse("data whose size differs from that stated");
    bytes += unpack(std::string_view(data).substr(at, packed), wanted);
    at += packed;
  }
  if (bytes.size() != size || at != data.size()) refuse("data whose size differs from that stated");
  return bytes;
}

std::vector<double> numbers_of(std::string_view bytes, std::string_view type) { return type_named(type).read(bytes); }

std::size_t size_of_type(std::string_view type) { return type_named(type).size; }

} // namespace riedel
