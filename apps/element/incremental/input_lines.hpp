/// A file of lines that begin with numbers or with a word; what follows is a comment.
#pragma once

#include <cstdint>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace riedel {

class InputLines {
public:
  /// @throws InputError when the file cannot be read
  explicit InputLines(const std::filesystem::path& path);

  [[nodiscard]] std::string place() const;                ///< of the last line read: "test.inp:12:"
  [[noreturn]] void refuse(const std::string& why) const; ///< throws InputError with the place

  /// The next line that is not empty. @return whether there was one
  bool next(std::string& line);
  /// The first word of the next line. @param what names it in the message if it is missing
  std::string word(const std::string& what);
  /// The next line, whatever it contains. @param what names it in the message if it is missing
  std::string line(const std::string& what);
  /// The first numbers of the next line, also as 1.0d0. @param what names them in the message if they are missing
  std::vector<double> numbers(std::size_t count, const std::string& what);
  /// The first numbers of a line that has been read.
  [[nodiscard]] std::vector<double> numbers_in(std::string line, std::size_t count, const std::string& what) const;
  /// An integer at the beginning of the next line. @param what names it
  std::int64_t integer(const std::string& what, std::int64_t minimum, std::int64_t maximum);
  /// The same number as an integer. @throws InputError if it is none
  [[nodiscard]] std::int64_t integer_of(double x, const std::string& what, std::int64_t minimum,
                                        std::int64_t maximum) const;
  double number(const std::string& what) { return numbers(1, what).front(); }

private:
  [[nodiscard]] double number_in(std::string text, const std::string& what) const;

  std::filesystem::path path_;
  std::istringstream file_;
  int number_ = 0; ///< of the last line read
};

} // namespace riedel
