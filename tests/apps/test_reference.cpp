/// docs/input.md is what the program prints.
#include "apps/built_in.hpp"
#include "apps/reference.hpp"
#include "temporary_folder.hpp"

using namespace riedel;

TEST(InputReference, IsUpToDate) {
  EXPECT_EQ(file_content(SOURCE_DIR "/docs/input.md"), input_reference(full_catalogue()))
      << "renew it: riedel check --reference > docs/input.md";
}
