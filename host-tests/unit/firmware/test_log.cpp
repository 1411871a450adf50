#include <gtest/gtest.h>

#include <string>

#include "firmware/log.hpp"

namespace firmware {
namespace {

class Lines : public testing::Test {
 protected:
  ~Lines() override { std::fclose(file); }
  [[nodiscard]] std::string text() const {
    std::rewind(file);
    std::string all(1 << 16, '\0');
    all.resize(std::fread(all.data(), 1, all.size(), file));
    return all;
  }
  std::FILE* file = std::tmpfile();
};

TEST_F(Lines, CarryTheirPriority) {
  Log log(file);
  log.write(0, Priority::kError, "broken");
  log.write(1, Priority::kInfo, "fine");
  log.print(2, Priority::kWarning, "%d of %s", 2, "them");
  EXPECT_EQ(text(), "<3>broken\n<6>fine\n<4>2 of them\n");
}

TEST_F(Lines, AreLimitedInTheLongRunAndTheRestIsCounted) {
  Log log(file);
  for (int k = 0; k < 1000; ++k) log.write(k, Priority::kInfo, "again");
  EXPECT_EQ(log.suppressed(), 1000U - Log::kBurst);
  log.write(10'000'000, Priority::kInfo, "later");
  const std::string all = text();
  EXPECT_NE(all.find("<4>960 messages about the gateway suppressed\n<6>later\n"),
            std::string::npos)
      << all;
}

TEST_F(Lines, OfOneTopicTakeNoneFromAnother) {
  Log log(file);
  for (int k = 0; k < 1000; ++k) {
    log.write(k, Priority::kWarning, "no answer", Topic::kDevices);
  }
  log.write(1000, Priority::kWarning, "input fault: missing", Topic::kInputs);
  log.write(1000, Priority::kWarning, "FLAG RAISED", Topic::kFlags);
  EXPECT_EQ(log.suppressed(), 1000U - Log::kBurst);
  log.write(10'000'000, Priority::kWarning, "no answer", Topic::kDevices);
  const std::string all = text();
  EXPECT_NE(all.find("<4>input fault: missing\n<4>FLAG RAISED\n"
                     "<4>960 messages about devices suppressed\n<4>no answer\n"),
            std::string::npos)
      << all;
}

}  // namespace
}  // namespace firmware
