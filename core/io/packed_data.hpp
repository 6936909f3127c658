/// Numbers as stored in VTK's XML: compressed in blocks, and encoded in base 64.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace riedel {

/// Decodes base 64. @throws InputError for an invalid letter or an incomplete group
std::string from_base64(std::string_view letters);

/// Decodes a block in LZ4's format. @param size of the result [bytes] @throws InputError if the contents differ
std::string from_lz4(std::string_view block, std::size_t size);

/// The same for a zlib stream.
std::string from_zlib(std::string_view block, std::size_t size);

/// Decodes a block in one of these formats.
using Unpack = std::string (*)(std::string_view block, std::size_t size);

/// Decodes the text of a VTK data array, in its form "binary" with headers of 32 bits.
/// @param unpack none: it is not compressed @param size of all numbers together [bytes]
/// @throws InputError if the text is damaged or has another form
std::string unpacked(std::string_view text, std::size_t size, Unpack unpack);

/// Numbers of a VTK type, such as "Float32", in the byte order of this machine. @throws InputError
std::vector<double> numbers_of(std::string_view bytes, std::string_view type);

/// Bytes per number. @throws InputError for an unknown type
std::size_t size_of_type(std::string_view type);

} // namespace riedel
