#include <gtest/gtest.h>

#include "config/pdo_mapping.hpp"

namespace config {
namespace {

constexpr const char* kEds =
    "[1A00]\r\nParameterName=Transmit PDO mapping\r\n\r\n"
    "[1A00sub0]\nDefaultValue=3\n"
    "[1A00sub1]\nDefaultValue=0x60410010\n"
    "[1a00SUB2]\nDefaultValue=0x20000108\nParameterValue = 0x64010110\n"
    "[1A00sub3]\nDefaultValue=0x64020120\n"
    "[6401sub1]\nDataType=0x0003\n[6402sub1]\nDataType=0x0008\n[6041]\nDataType=6\n"
    "[1A01sub0]\nDefaultValue=2\n[1A01sub1]\nDefaultValue=0x60000108\n";

TEST(PdoMapping, ReadsNamesOfObjects) {
  ObjectName name;
  EXPECT_TRUE(parse_object("6401:01", name));
  EXPECT_EQ(name.index, 0x6401);
  EXPECT_EQ(name.sub, 1);
  EXPECT_TRUE(parse_object("0x6041", name));
  EXPECT_EQ(name.index, 0x6041);
  EXPECT_EQ(name.sub, 0);
  for (const char* bad : {"", "64010:1", "6401:", "6401:100", "speed", "6401:01 "}) {
    EXPECT_FALSE(parse_object(bad, name)) << bad;
  }
}

TEST(PdoMapping, ReadsAnEdsAndWhatADcfSetsInIt) {
  EXPECT_EQ(read_mapping(kEds, 1), (PdoMapping{0x60410010, 0x64010110, 0x64020120}));
  EXPECT_TRUE(read_mapping(kEds, 2).empty()) << "an entry is missing";
  EXPECT_TRUE(read_mapping(kEds, 3).empty());
  EXPECT_TRUE(read_mapping("rubbish\n[", 1).empty());
}

TEST(PdoMapping, LaysObjectsOutOneAfterTheOther) {
  const PdoMapping mapping = read_mapping(kEds, 1);
  wire::Signal signal;
  ASSERT_TRUE(lay_out(mapping, {0x6401, 1}, signal));
  EXPECT_EQ(signal.start, 16);
  EXPECT_EQ(signal.length, 16);
  EXPECT_TRUE(read_data_type(kEds, {0x6401, 1}, signal));
  EXPECT_TRUE(signal.is_signed);
  ASSERT_TRUE(lay_out(mapping, {0x6402, 1}, signal));
  EXPECT_EQ(signal.start, 32);
  EXPECT_TRUE(read_data_type(kEds, {0x6402, 1}, signal));
  EXPECT_EQ(signal.type, wire::ValueType::kFloat32);
  EXPECT_TRUE(read_data_type(kEds, {0x6041, 0}, signal)) << "without sub-index";
  EXPECT_FALSE(signal.is_signed);
  EXPECT_FALSE(read_data_type(kEds, {0x7000, 0}, signal));
  EXPECT_FALSE(lay_out(mapping, {0x6401, 2}, signal)) << "not mapped";
  EXPECT_FALSE(lay_out({0x60000140, 0x64010110}, {0x6401, 1}, signal))
      << "beyond a frame";
}

}  // namespace
}  // namespace config
