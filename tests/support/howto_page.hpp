/// Pages that walk through an example of code.
#pragma once

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace riedel::test {

/// The text of a file, by its path in the tree.
inline std::string text_of(const std::string& path) {
  std::ifstream file(std::string(SOURCE_DIR) + "/" + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Checks that the page shows the example unchanged, and that it is shorter than sixty lines.
inline void expect_page_to_show(const std::string& page, const std::string& example) {
  const std::string shown = text_of(example);
  ASSERT_FALSE(shown.empty());
  EXPECT_LT(std::ranges::count(shown, '\n'), 60);
  EXPECT_NE(text_of(page).find("```cpp\n" + shown + "```"), std::string::npos);
}

} // namespace riedel::test
