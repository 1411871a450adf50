#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "config/gateway.hpp"
#include "config/source_reader.hpp"

namespace config {
namespace {

// What is said of a loop with these two sources, a line for each.
std::string error_of(const std::string& u, const std::string& y) {
  try {
    (void)parse_gateway(
        "[bus.a]\nbackend = \"slcan\"\nport = 0\n[[loop]]\nid = 1\ntag = "
        "\"A\"\nu = { " +
            u + " }\ny = { " + y + " }\n",
        "g.toml");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}
long lines_of(const std::string& error) {
  return std::count(error.begin(), error.end(), '\n') + (error.empty() ? 0 : 1);
}

TEST(SourceReader, OfASourceThatIsWrongNothingElseIsSaid) {
  const std::string kind = error_of("source = \"opc\"", "source = \"mqtt\"");
  EXPECT_EQ(lines_of(kind), 2) << kind;
  EXPECT_NE(kind.find("loop[1].u.source"), std::string::npos) << kind;
  EXPECT_NE(kind.find("loop[1].y.source"), std::string::npos) << kind;
  const std::string dbc =
      "source = \"can\", dbc = \"none.dbc\", message = \"M\", signal = ";
  EXPECT_EQ(lines_of(error_of(dbc + "\"U\"", dbc + "\"Y\"")), 2);
  const std::string modbus = "source = \"modbus\", host = \"10.0.0.5\"";
  EXPECT_EQ(lines_of(error_of(modbus, modbus)), 2) << "no address";
}

TEST(SourceReader, TheSameSignalTwiceIsToldWhereBothCanBeRead) {
  const std::string can = "source = \"can\", frame_id = 1, start = 0, length = 16";
  EXPECT_NE(error_of(can, can).find("loop[1].y: expected another signal than u"),
            std::string::npos);
  const std::string modbus = "source = \"modbus\", host = \"10.0.0.5\", address = ";
  EXPECT_NE(error_of(modbus + "1", modbus + "1").find("expected another signal than u"),
            std::string::npos);
  EXPECT_EQ(error_of(modbus + "1", modbus + "2"), "");
}

TEST(SourceReader, AModbusHostIsAnAddress) {
  const std::string y = "source = \"modbus\", host = \"10.0.0.5\", address = 1";
  EXPECT_EQ(error_of(y + "1", y), "");
  for (const char* host : {"plc.local", "10.0.0.300", "10.0.0.5:502", "10.0.0"}) {
    const std::string said = error_of(
        "source = \"modbus\", address = 2, host = \"" + std::string(host) + '"', y);
    EXPECT_NE(said.find(std::string("loop[1].u.host: expected an IPv4 address, as "
                                    "\"10.0.0.5\", found \"") +
                        host),
              std::string::npos)
        << said;
    EXPECT_EQ(lines_of(said), 1) << said;
  }
  const std::string modbus = "source = \"modbus\", address = 2";
  EXPECT_EQ(lines_of(error_of(modbus + ", host = \"\"", y)), 1);
  EXPECT_EQ(lines_of(error_of(modbus + ", host = 7", y)), 1);
  EXPECT_EQ(lines_of(error_of(modbus, y)), 1);
  EXPECT_EQ(
      lines_of(error_of(modbus + ", host = \"10.0.0.5\", device = \"/dev/ttyS0\"", y)),
      1);
}

TEST(SourceReader, AMultiplexerHasWholeValuesThatFitIntoIt) {
  const auto said = [](const char* value) {
    return error_of(
        "source = \"can\", frame_id = 1, start = 16, length = 16, multiplexer "
        "= { start = 0, length = 8 }, multiplexer_ids = [" +
            std::string(value) + "]",
        "source = \"can\", frame_id = 2, start = 0, length = 16");
  };
  EXPECT_EQ(said("255"), "");
  for (const char* value : {"256", "-1", "2.5"}) {
    EXPECT_NE(said(value).find("from 0 to 255"), std::string::npos) << said(value);
  }
}

}  // namespace
}  // namespace config
