#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "hal/sysfs_adc.hpp"
#include "support/base/temporary_folder.hpp"

namespace hal {
namespace {

class Sysfs : public testing::Test {
 protected:
  Sysfs() {
    put("bus/iio/devices/iio:device9/name", "other");
    put("bus/iio/devices/iio:device10/name", "ads1115");
    put("bus/iio/devices/iio:device10/in_voltage0_raw", "16000");
    put("bus/iio/devices/iio:device10/in_voltage_scale", "0.125");
    put("bus/iio/devices/iio:device10/in_voltage0_offset", "-800");
    put("class/hwmon/hwmon3/name", "ina219");
    put("class/hwmon/hwmon3/curr1_input", "12");
  }

  void put(const std::string& file, const std::string& text) const {
    const std::filesystem::path path = root / file;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text << '\n';
  }

  TemporaryFolder own;
  std::filesystem::path root = own.path();
};

TEST_F(Sysfs, FindsTheIioDeviceByNameAndScales) {
  SysfsAdc adc(AdcKind::kIio, root.string(), "ads1115", "voltage0");
  double value = 0;
  ASSERT_TRUE(adc.open()) << adc.error();
  ASSERT_TRUE(adc.read(value)) << adc.error();
  EXPECT_DOUBLE_EQ(value, (16000 - 800) * 0.125);
  put("bus/iio/devices/iio:device10/in_voltage0_raw", "800");
  ASSERT_TRUE(adc.read(value)) << "the same descriptor again";
  EXPECT_DOUBLE_EQ(value, 0);
}

TEST_F(Sysfs, ReadsHwmon) {
  SysfsAdc adc(AdcKind::kHwmon, root.string(), "ina219", "curr1");
  double value = 0;
  ASSERT_TRUE(adc.open()) << adc.error();
  ASSERT_TRUE(adc.read(value));
  EXPECT_DOUBLE_EQ(value, 12);
}

TEST_F(Sysfs, SaysWhatIsMissingAndFindsItOnceItIsThere) {
  SysfsAdc adc(AdcKind::kIio, root.string(), "ads9999", "voltage0");
  EXPECT_FALSE(adc.open());
  EXPECT_NE(std::string(adc.error()).find("ads9999"), std::string::npos) << adc.error();
  double value = 0;
  EXPECT_FALSE(adc.read(value));
  put("bus/iio/devices/iio:device9/name", "ads9999");
  EXPECT_FALSE(adc.open());
  EXPECT_NE(std::string(adc.error()).find("no such channel"), std::string::npos);
  put("bus/iio/devices/iio:device9/in_voltage0_raw", "1");
  EXPECT_TRUE(adc.open()) << adc.error();
}

TEST_F(Sysfs, AValueThatIsNoNumberIsAnErrorThatStays) {
  SysfsAdc adc(AdcKind::kHwmon, root.string(), "ina219", "curr1");
  ASSERT_TRUE(adc.open());
  put("class/hwmon/hwmon3/curr1_input", "broken");
  double value = 7;
  EXPECT_FALSE(adc.read(value));
  EXPECT_EQ(value, 7);
  put("class/hwmon/hwmon3/curr1_input", "4");
  EXPECT_FALSE(adc.read(value)) << "until it is opened again";
  ASSERT_TRUE(adc.open());
  EXPECT_TRUE(adc.read(value));
}

TEST_F(Sysfs, DevicesOfOneNameAreCountedByTheirNumbers) {
  put("bus/iio/devices/iio:device2/name", "ads1115");
  put("bus/iio/devices/iio:device2/in_voltage0_raw", "5");
  double value = 0;
  SysfsAdc first(AdcKind::kIio, root.string(), "ads1115", "voltage0", 0);
  ASSERT_TRUE(first.open() && first.read(value));
  EXPECT_DOUBLE_EQ(value, 5);
  SysfsAdc third(AdcKind::kIio, root.string(), "ads1115", "voltage0", 2);
  EXPECT_FALSE(third.open());
}

}  // namespace
}  // namespace hal
