/// Numbers as VTK's XML holds them: compressed in blocks, and written with 64 letters.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace riedel {

/// The bytes that letters of base 64 stand for. @throws InputError for another letter, or a part of a group
std::string from_base64(std::string_view letters);

/// What a block in LZ4's format holds. @param size of it [bytes]   @throws InputError when it holds something else
std::string from_lz4(std::string_view block, std::size_t size);

/// The same of a stream of zlib's.
std::string from_zlib(std::string_view block, std::size_t size);

/// The bytes of a block, in one of these formats.
using Unpack = std::string (*)(std::string_view block, std::size_t size);

/// Text of a data array of VTK's, in its form "binary" with headers of 32 bits.
/// @param unpack none: it is not compressed   @param size of all numbers together [bytes]
/// @throws InputError when the text is damaged or of another form
std::string unpacked(std::string_view text, std::size_t size, Unpack unpack);

/// Numbers of a type of VTK's, such as "Float32", in the order of bytes of this machine. @throws InputError
std::vector<double> numbers_of(std::string_view bytes, std::string_view type);

/// Bytes of one number. @throws InputError for a type that is not known
std::size_t size_of_type(std::string_view type);

} // namespace riedel
