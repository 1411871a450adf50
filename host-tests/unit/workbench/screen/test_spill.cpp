#include <gtest/gtest.h>

#include <stdexcept>

#include "support/base/temporary_folder.hpp"
#include "workbench/screen/spill.hpp"

namespace workbench {
namespace {

TEST(Spill, StreamsComeBackWhole) {
  const TemporaryFolder folder;
  Spill spill(folder.path(), 3 * 4096);
  std::vector<std::string> wanted(3);
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_EQ(spill.add_stream(), i);
  for (int row = 0; row < 5000; ++row) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const std::string text = std::to_string(row * (i + 1)) + '\n';
      wanted[i] += text;
      spill.buffer(i) += text;
    }
    if (row % 7 == 0) spill.flush_full();
  }
  spill.finish();
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(spill.text(i), wanted[i]);
    EXPECT_EQ(spill.size(i), wanted[i].size());
  }
}

TEST(Spill, AFolderThatIsNoneIsSaid) {
  EXPECT_THROW(Spill("/no/such/folder"), std::runtime_error);
}

}  // namespace
}  // namespace workbench
