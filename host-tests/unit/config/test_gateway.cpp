#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "config/gateway.hpp"
#include "support/base/temporary_folder.hpp"

namespace config {
namespace {

constexpr const char* kDbc =
    "BO_ 398 LoopOP: 8 PLC\n SG_ OP : 0|32@1- (1E-5,0) [0|100] \"%\" GW\n"
    "BO_ 397 LoopSP: 4 PLC\n SG_ SP : 0|32@1- (1,0) [0|0] \"%\" GW\n";

const std::string kStart = "[bus.can0]\nbackend = \"socketcan\"\ninterface = \"can0\"\n";
const std::string kLoop =
    "[[loop]]\nid = 1\ntag = \"FIC-211\"\n"
    "u = { source = \"can\", frame_id = 0x18E, start = 0, length = 16 }\n"
    "y = { source = \"can\", frame_id = 0x18F, start = 0, length = 16 }\n";

class GatewayFile : public testing::Test {
 protected:
  GatewayFile() { std::ofstream(folder + "plant.dbc") << kDbc; }

  [[nodiscard]] Gateway parse(const std::string& text) const {
    return parse_gateway(text, folder + "g.toml");
  }
  // What is said of a text that must be refused.
  [[nodiscard]] std::string error_of(const std::string& text) const {
    try {
      (void)parse(text);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "accepted";
  }
  void expect_error(const std::string& text,
                    const std::vector<std::string>& parts) const {
    const std::string error = error_of(text);
    for (const std::string& part : parts) {
      EXPECT_NE(error.find(part), std::string::npos) << part << "\nnot in:\n" << error;
    }
    for (const char* part : {"expected ", "found ", "; ", "g.toml"}) {
      EXPECT_NE(error.find(part), std::string::npos) << part << "\nnot in:\n" << error;
    }
  }

  TemporaryFolder own;
  std::string folder = own.path() + "/";
};

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST_F(GatewayFile, TheSampleIsValid) {
  const Gateway gateway = parse(text_of(STICKBAND_SAMPLE));
  EXPECT_EQ(gateway.name, "gw-17");
  ASSERT_EQ(gateway.loops.size(), 1U);
  const Loop& loop = gateway.loops[0];
  EXPECT_EQ(loop.u.signal.frame_id, 398U);
  EXPECT_EQ(loop.y.signal.frame_id, 0x18FU);
  EXPECT_EQ(loop.y.signal.signal.byte_order, wire::ByteOrder::kBigEndian);
  EXPECT_TRUE(loop.y.has_range);
  EXPECT_EQ(loop.u.description, "can0 18E LoopOP.OP");
  EXPECT_EQ(loop.flag->line, 3U);
  EXPECT_EQ(loop.parameters.stiction, wire::Ne107::kMaintenanceRequired);
  EXPECT_EQ(gateway.uds->request_id, 0x7E0U);
  EXPECT_NE(gateway.crc32, 0U);
}

// An unknown key is answered with the list of those there are: each is in the sample.
TEST_F(GatewayFile, TheSampleShowsEveryKey) {
  const std::string sample = text_of(STICKBAND_SAMPLE);
  const std::string iio =
      "[[loop]]\nid = 1\ntag = \"A\"\n"
      "u = { source = \"iio\", name = \"x\", channel = \"voltage0\", zzz = 1 }\n";
  for (const std::string& text :
       {std::string("zzz = 1\n"), std::string("[gateway]\nzzz = 1\n"),
        kStart + "zzz = 1\n",
        std::string("[bus.a]\nbackend = \"slcan\"\nport = 1\nzzz = 1\n"),
        std::string("[bus.a]\nbackend = \"file\"\npath = \"x\"\nzzz = 1\n"),
        kStart + "[uds]\nzzz = 1\n", kStart + "[broadcast]\nzzz = 1\n",
        std::string("[metrics]\npath = \"x\"\nzzz = 1\n"),
        std::string("[state]\npath = \"x\"\nzzz = 1\n"), kStart + kLoop + "zzz = 1\n",
        kStart + kLoop + "flag = { chip = \"a\", line = 1, zzz = 1 }\n",
        kStart + kLoop + "[loop.alarm]\nzzz = 1\n",
        kStart + kLoop + "[loop.alarm]\nne107 = { zzz = 1 }\n", iio,
        kStart + "[[loop]]\nu = { source = \"can\", frame_id = 1, zzz = 1 }\n",
        kStart + "[[loop]]\nu = { source = \"can\", dbc = \"plant.dbc\", zzz = 1 }\n"}) {
    const std::string error = error_of(text);
    const std::string head = "one of the keys ";
    const std::size_t start = error.find(head);
    ASSERT_NE(start, std::string::npos) << text << error;
    std::stringstream keys(error.substr(
        start + head.size(), error.find(", found \"zzz\"") - start - head.size()));
    for (std::string key; std::getline(keys, key, ',');) {
      key.erase(0, key.find_first_not_of(' '));
      const bool shown = sample.find(key + " =") != std::string::npos ||
                         sample.find('[' + key) != std::string::npos ||
                         sample.find('.' + key + ']') != std::string::npos;
      EXPECT_TRUE(shown) << key << " is not in the sample";
    }
  }
}

TEST_F(GatewayFile, ParameterGroupsAndProcessDataHaveTheirOwnNames) {
  const std::string head =
      "[bus.a]\nbackend = \"slcan\"\nport = 0\n[[loop]]\nid = 1\ntag = "
      "\"A\"\n";
  const std::string u =
      "u = { source = \"j1939\", pgn = 0xFEF2, start = 8, length = 16, scale = 0.5 }\n";
  const std::string y =
      "y = { source = \"canopen\", node = 5, pdo = 2, object = \"6401:01\", mapping = "
      "[0x60410010, 0x64010110], is_signed = true }\n";
  const Gateway gateway = parse_gateway(head + u + y, "g.toml");
  const Source& group = gateway.loops[0].u;
  EXPECT_EQ(group.kind, SourceKind::kCan);
  EXPECT_TRUE(group.signal.extended);
  EXPECT_EQ(group.signal.frame_id, 0x00FEF200U);
  EXPECT_EQ(group.signal.ignored, 0x1C0000FFU);
  EXPECT_EQ(group.maximum, 0.5 * 0xFAFF) << "above is no value";
  EXPECT_EQ(group.description, "a PGN FEF2");
  const Source& object = gateway.loops[0].y;
  EXPECT_EQ(object.signal.frame_id, 0x285U);
  EXPECT_EQ(object.signal.signal.start, 16);
  EXPECT_EQ(object.signal.signal.length, 16);
  EXPECT_EQ(object.description, "a node 5 PDO 2 6401:01");

  const std::string to_one =
      "u = { source = \"j1939\", pgn = 0xEF00, source_address = 3, "
      "start = 0, length = 8 }\n";
  const Gateway addressed = parse_gateway(head + to_one + y, "g.toml");
  EXPECT_EQ(addressed.loops[0].u.signal.frame_id, 0x00EF0003U);
  EXPECT_EQ(addressed.loops[0].u.signal.ignored, 0x1C00FF00U);

  expect_error(head + u +
                   "y = { source = \"canopen\", node = 5, object = \"6402:01\", "
                   "mapping = [0x60410010] }\n",
               {"g.toml:8: loop[1].y.mapping", "found it not mapped there"});
  expect_error(head + u +
                   "y = { source = \"canopen\", node = 5, pdo = 9, object = "
                   "\"6041:00\", mapping = [0x60410010] }\n",
               {"expected cob_id"});
}

TEST_F(GatewayFile, AParameterIsFoundByItsNumberInADbcFile) {
  std::ofstream(folder + "j.dbc")
      << "BO_ 2364540158 EEC1: 8 X\n SG_ EngSpeed : 24|16@1+ (0.125,0) [0|8031.875] "
         "\"rpm\" X\nBA_DEF_ SG_ \"SPN\" INT 0 524287;\n"
         "BA_ \"SPN\" SG_ 2364540158 EngSpeed 190;\n";
  const std::string head =
      "[bus.a]\nbackend = \"slcan\"\nport = 0\n[[loop]]\nid = 1\ntag = "
      "\"A\"\n";
  const auto u = [](int spn) {
    return "u = { source = \"j1939\", pgn = 0xF004, dbc = \"j.dbc\", spn = " +
           std::to_string(spn) + " }\n";
  };
  const std::string y = "y = { source = \"can\", frame_id = 1, start = 0, length = 8 }\n";
  const Gateway gateway = parse_gateway(head + u(190) + y, folder + "g.toml");
  EXPECT_EQ(gateway.loops[0].u.signal.signal.start, 24);
  EXPECT_EQ(gateway.loops[0].u.signal.frame_id, 0x00F00400U);
  EXPECT_EQ(gateway.loops[0].u.maximum, 8031.875);
  try {
    (void)parse_gateway(head + u(191) + y, folder + "g.toml");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("BA_ \"SPN\" 191"), std::string::npos);
  }
}

TEST_F(GatewayFile, RegistersAreReadByServerAndAddress) {
  const std::string head = "[[loop]]\nid = 1\ntag = \"A\"\n";
  const std::string u =
      "u = { source = \"modbus\", host = \"10.0.0.5\", address = 100, type = \"f32\", "
      "word_order = \"low_first\", scale = 0.5 }\n";
  const std::string y =
      "y = { source = \"modbus\", device = \"/dev/ttyS1\", baud = 19200, parity = \"N\", "
      "unit = 7, table = \"input\", address = 3, type = \"i16\" }\n";
  const Gateway gateway = parse_gateway(head + u + y, "g.toml");
  const Modbus& tcp = gateway.loops[0].u.modbus;
  EXPECT_EQ(tcp.host, "10.0.0.5");
  EXPECT_EQ(tcp.port, 502);
  EXPECT_EQ(tcp.address, 100);
  EXPECT_EQ(tcp.type, RegisterType::kF32);
  EXPECT_TRUE(tcp.low_word_first);
  EXPECT_EQ(gateway.loops[0].u.scale, 0.5);
  EXPECT_EQ(gateway.loops[0].u.description, "10.0.0.5:502 1 holding 100");
  const Modbus& rtu = gateway.loops[0].y.modbus;
  EXPECT_EQ(rtu.device, "/dev/ttyS1");
  EXPECT_EQ(rtu.baud, 19200);
  EXPECT_EQ(rtu.parity, 'N');
  EXPECT_EQ(rtu.unit, 7);
  EXPECT_TRUE(rtu.input_table);
  EXPECT_EQ(gateway.loops[0].y.offset, 0);

  expect_error(head + u + "y = { source = \"modbus\", address = 1 }\n",
               {"g.toml:5: loop[1].y", "host", "device"});
  expect_error(head + u + "y = { source = \"modbus\", host = \"10.0.0.5\" }\n",
               {"the number of a register"});
  expect_error(head + u +
                   "y = { source = \"modbus\", host = \"10.0.0.5\", address = 1, scale = "
                   "0.0 }\n",
               {"a finite scale that is not 0"});
}

TEST_F(GatewayFile, UnknownKeysAndWrongTypesAreNamedWithLineAndKey) {
  expect_error(kStart + kLoop + "sample_perod_s = 1.0\n",
               {"g.toml:9: loop[1].sample_perod_s: expected one of the keys ",
                "sample_period_s", "found \"sample_perod_s\""});
  expect_error(kStart + kLoop + "sample_period_s = \"fast\"\n",
               {"g.toml:9: loop[1].sample_period_s: expected a number from 0.01 to 3600",
                "found the text \"fast\"", "; "});
  expect_error(kStart + kLoop + "span = [100.0, 0.0]\n",
               {"two ascending finite numbers"});
  expect_error(kStart + kLoop + "span = [0.0, inf]\n",
               {"two ascending finite numbers", "found [0, inf]"});
  expect_error("[bus.can0]\nbackend = \"usb\"\n",
               {"g.toml:2: bus.can0.backend", "\"socketcan\""});
  expect_error("[gateway\n", {"g.toml:1", "TOML"});
}

TEST_F(GatewayFile, EveryKindOfSourceIsNamedWhereThereIsNoneOrAnother) {
  const std::string kinds =
      "loop[1].u.source: expected one of \"can\", \"iio\", \"hwmon\", \"modbus\", "
      "\"j1939\", \"canopen\", found ";
  expect_error(kStart + "[[loop]]\nu = { frame_id = 1 }\n", {kinds + "nothing"});
  expect_error(kStart + "[[loop]]\nu = { source = \"usb\" }\n", {kinds + "the text"});
}

TEST_F(GatewayFile, EverythingThatIsWrongIsSaidAtOnceInTheOrderOfTheLines) {
  const std::string error = error_of(kStart + "[uds]\nwrites = 1\nrequest_id = -1\n" +
                                     kLoop + "stale_after_s = 1.0\n");
  const std::size_t first = error.find("g.toml:5: uds.writes");
  const std::size_t second = error.find("g.toml:6: uds.request_id");
  const std::size_t third = error.find("loop[1].stale_after_s");
  EXPECT_LT(first, second) << error;
  EXPECT_LT(second, third) << error;
  EXPECT_NE(third, std::string::npos) << error;
}

TEST_F(GatewayFile, MissingDbcMessageAndSignalAreNamed) {
  const auto loop_with = [](const std::string& u) {
    return kStart + "[[loop]]\nid = 1\ntag = \"A\"\nu = { source = \"can\", " + u +
           " }\ny = { source = \"can\", frame_id = 1, start = 0, length = 8 }\n";
  };
  expect_error(loop_with("dbc = \"none.dbc\", message = \"A\", signal = \"B\""),
               {"g.toml:7: loop[1].u.dbc", "none.dbc cannot be read"});
  expect_error(
      loop_with("dbc = \"plant.dbc\", message = \"LoopPV\", signal = \"B\""),
      {"loop[1].u.message", "plant.dbc", "\"LoopPV\"", "\"LoopOP\", \"LoopSP\""});
  expect_error(loop_with("dbc = \"plant.dbc\", message = \"LoopOP\", signal = \"B\""),
               {"plant.dbc:1", "a signal \"B\"", "found \"OP\""});
  expect_error(loop_with("frame_id = 0x800, start = 0, length = 8"),
               {"loop[1].u.frame_id", "extended = true"});
  expect_error(loop_with("frame_id = 2, start = 508, length = 8"), {"loop[1].u.start"});
  const std::string lab = "[bus.can0]\nbackend = \"slcan\"\nport = 1\n";
  const std::string far = loop_with("frame_id = 2, start = 60, length = 8");
  EXPECT_EQ(error_of(far), "accepted") << "of CAN FD";
  expect_error(lab + far.substr(far.find("[[loop]]")), {"loop[1].u", "CAN FD", "slcan"});
  expect_error(loop_with("bus = \"can9\", frame_id = 2, start = 0, length = 8"),
               {"loop[1].u.bus", "\"can0\"", "\"can9\""});
}

TEST_F(GatewayFile, OneMistakeIsOneLine) {
  const std::string twice = kStart + "[broadcast]\ndetail_base_id = 0x1B0\n" + kLoop +
                            "[[loop]]\nid = 1\ntag = \"B\"\n" +
                            kLoop.substr(kLoop.find("u = "));
  const std::string none = "[[loop]]\nid = 0\n" + kLoop.substr(kLoop.find("tag = "));
  const std::string from_dbc =
      "[[loop]]\nid = 1\ntag = \"A\"\nu = { source = \"can\", dbc = \"plant.dbc\", "
      "message "
      "= \"LoopPV\", signal = \"B\" }\n" +
      kLoop.substr(kLoop.find("y = "));
  const std::pair<std::string, const char*> cases[] = {
      {"[bus.can0]\nbackend = \"pcan\"\nchannel = 1\n" + kLoop, "bus.can0.backend: "},
      {"[bus.can0]\ninterface = \"can0\"\n" + kLoop, "bus.can0.backend: "},
      {twice, "loop[2]: expected an id of its own"},
      {kStart + none, "loop[1].id: "},
      {kStart + from_dbc, "loop[1].u.message: "},
  };
  for (const auto& [text, place] : cases) {
    const std::string error = error_of(text);
    EXPECT_NE(error.find(place), std::string::npos) << error;
    EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 0) << error;
  }
}

TEST_F(GatewayFile, IdentifiersLoopsAndLinesBelongToOneOnly) {
  const auto second = [](int id, const std::string& more) {
    return "[[loop]]\nid = " + std::to_string(id) + "\ntag = \"B\"\n" +
           "u = { source = \"can\", frame_id = 1, start = 0, length = 16 }\n"
           "y = { source = \"can\", frame_id = 2, start = 0, length = 16 }\n" +
           more;
  };
  const std::string flag = "flag = { chip = \"gpiochip0\", line = 3 }\n";
  expect_error(kStart + kLoop + second(1, ""), {"g.toml:9: loop[2]", "an id of its own"});
  expect_error(kStart + kLoop + flag + second(2, flag),
               {"loop[2].flag", "a GPIO line of its own", "loop[1].flag"});
  expect_error(kStart + "[uds]\nrequest_id = 0x18E\n" + kLoop,
               {"loop[1].u", "18E", "uds.request_id"});
  expect_error(kStart + "[uds]\nrequest_id = 0x700\nresponse_id = 0x700\n" + kLoop,
               {"uds.response_id", "700"});
  expect_error(kStart + "[broadcast]\nbase_id = 0x18D\n" + kLoop,
               {"18E", "the status frame of loop 1"});
  EXPECT_EQ(parse(kStart + kLoop + second(2, "")).loops.size(), 2U);
}

TEST_F(GatewayFile, AnalogSourcesAreChecked) {
  const auto u = [](const std::string& more) {
    return kStart +
           "[[loop]]\nid = 1\ntag = \"A\"\nu = { source = \"iio\", name = \"ads\", " +
           more + " }\ny = { source = \"can\", frame_id = 1, start = 0, length = 8 }\n";
  };
  const Gateway gateway =
      parse(u("channel = \"voltage0\", shunt_ohm = 250.0, ne43 = true"));
  EXPECT_TRUE(gateway.loops[0].u.is_current);
  EXPECT_EQ(gateway.loops[0].u.in[1], 20);
  expect_error(u("channel = \"voltage0\", ne43 = true"), {"loop[1].u.ne43", "shunt_ohm"});
  expect_error(u("channel = \"current0\", ne43 = true, failure_low_ma = 5.0"),
               {"failure_low_ma"});
}

TEST_F(GatewayFile, WritingNeedsAKeyOf32Bytes) {
  expect_error(kStart + "[uds]\nwrites = true\n" + kLoop, {"uds.writes", "key_file"});
  std::ofstream(folder + "uds.key") << std::string(63, 'a');
  const std::string text =
      kStart + "[uds]\nwrites = true\nkey_file = \"uds.key\"\n" + kLoop;
  expect_error(text, {"uds.key_file", "64 hex digits", "63"});
  std::ofstream(folder + "uds.key") << std::string(64, 'a') << '\n';
  std::filesystem::permissions(folder + "uds.key", std::filesystem::perms(0644));
  expect_error(text, {"uds.key_file", "everybody may read", "chmod 600"});
  std::filesystem::permissions(folder + "uds.key", std::filesystem::perms(0600));
  const Gateway gateway = parse(text);
  EXPECT_TRUE(gateway.uds->has_key);
  EXPECT_EQ(gateway.uds->key[31], 0xAA);
}

TEST_F(GatewayFile, AKeyOfZerosIsNone) {
  std::ofstream(folder + "uds.key") << std::string(64, '0') << '\n';
  std::filesystem::permissions(folder + "uds.key", std::filesystem::perms(0600));
  expect_error(kStart + "[uds]\nwrites = true\nkey_file = \"uds.key\"\n" + kLoop,
               {"uds.key_file", "all zeros"});
}

TEST_F(GatewayFile, ACredentialTakesThePlaceOfAKeyFile) {
  std::filesystem::create_directory(folder + "credentials");
  std::ofstream(folder + "credentials/uds.key") << std::string(64, 'b');
  std::filesystem::permissions(folder + "credentials/uds.key",
                               std::filesystem::perms(0400));
  setenv("CREDENTIALS_DIRECTORY", (folder + "credentials").c_str(), 1);
  const Gateway gateway =
      parse(kStart + "[uds]\nkey_file = \"/root/none/uds.key\"\n" + kLoop);
  unsetenv("CREDENTIALS_DIRECTORY");
  EXPECT_EQ(gateway.uds->key[0], 0xBB);
  std::filesystem::remove(folder + "credentials/uds.key");
  std::ofstream(folder + "credentials/uds.key") << "none";
  std::ofstream(folder + "uds.key") << std::string(64, 'c');
  std::filesystem::permissions(folder + "uds.key", std::filesystem::perms(0600));
  setenv("CREDENTIALS_DIRECTORY", (folder + "credentials").c_str(), 1);
  const Gateway from_file = parse(kStart + "[uds]\nkey_file = \"uds.key\"\n" + kLoop);
  unsetenv("CREDENTIALS_DIRECTORY");
  EXPECT_EQ(from_file.uds->key[0], 0xCC) << "the unit's stand-in is no key";
}

TEST_F(GatewayFile, AFileThatIsWrittenHasOnePurpose) {
  const auto with = [](const std::string& metrics, const std::string& state) {
    return kStart + "[metrics]\npath = \"" + metrics + "\"\n[state]\npath = \"" + state +
           "\"\n" + kLoop;
  };
  expect_error(with("same", "same"), {"state.path", "a file of its own", "the textfile"});
  expect_error(with("a/../same", "./same"), {"state.path", "the textfile"});
  expect_error(with("state.new", "state"), {"state.path", "the textfile"});
  expect_error(with("a.prom", "g.toml"), {"state.path", "the configuration"});
  EXPECT_TRUE(parse(with("a.prom", "state")).state);
}

TEST_F(GatewayFile, TheStateFileLiesBesideTheConfiguration) {
  const Gateway gateway = parse(kStart + "[state]\npath = \"state\"\n" + kLoop);
  ASSERT_TRUE(gateway.state);
  EXPECT_EQ(gateway.state->path, folder + "state");
  EXPECT_EQ(gateway.state->period_s, 10);
  EXPECT_FALSE(parse(kStart + kLoop).state);
  expect_error(kStart + "[state]\nperiod_s = 0.1\n" + kLoop,
               {"state.path: ", "state.period_s: ", "1 to 3600"});
}

TEST_F(GatewayFile, WritesAreSixtyAnHourUnlessItSaysOtherwise) {
  EXPECT_EQ(parse(kStart + kLoop).writes_per_hour, 60);
  EXPECT_EQ(parse("[gateway]\nwrites_per_hour = 10\n" + kStart + kLoop).writes_per_hour,
            10);
  expect_error("[gateway]\nwrites_per_hour = 9\n" + kStart + kLoop,
               {"gateway.writes_per_hour: ", "10 to 3600"});
}

TEST_F(GatewayFile, ASteadyLoopIsNotEvaluatedMoreOftenThanAnother) {
  EXPECT_EQ(parse(kStart + kLoop).loops[0].evaluate_steady_pct, 100);
  expect_error(kStart + kLoop + "evaluate_every_pct = 50\nevaluate_steady_pct = 49\n",
               {"evaluate_steady_pct: expected at least evaluate_every_pct"});
}

TEST_F(GatewayFile, ABandNeedsNoAttentionBeforeItCounts) {
  const std::string alarm = kStart + kLoop + "[loop.alarm]\n";
  expect_error(alarm + "band_min_pct = 3.0\nband_limit_pct = 2.5\n",
               {"loop[1].alarm.band_limit_pct: expected at least band_min_pct"});
  EXPECT_EQ(parse(alarm + "band_limit_pct = 1.0\n").loops[0].band_limit_pct, 1);
  EXPECT_EQ(parse(alarm + "band_min_pct = 3.0\n").loops[0].band_limit_pct, 3);
}

TEST_F(GatewayFile, AListThatIsNoPairIsCounted) {
  expect_error(kStart + kLoop + "span = [2.0]\n",
               {"loop[1].span: expected a list of two numbers, found a list of one"});
  expect_error(kStart + kLoop + "span = [0,0, 9,5]\n", {"found a list of 4"});
  expect_error(kStart + kLoop + "span = []\n", {"found an empty list"});
}

TEST_F(GatewayFile, ALineThatIsNoTomlIsTakenForWhatItMeans) {
  expect_error(kStart + kLoop + "sample_period_s = 1,0\n",
               {"g.toml:9: expected a number with a decimal point, found 1,0"});
}

TEST_F(GatewayFile, AFileWithoutLoopsOrThatIsMissingIsRefused) {
  expect_error(kStart, {"loop: expected 1 to 31 tables [[loop]], found 0"});
  EXPECT_THROW((void)read_gateway(folder + "no-such.toml"), ConfigError);
}

TEST_F(GatewayFile, ANameIsAsLongAsATesterCanAskFor) {
  const std::string text = kStart + kLoop + "[gateway]\nname = \"";
  EXPECT_EQ(parse(text + std::string(32, 'x') + "\"\n").name.size(), 32U);
  expect_error(text + std::string(33, 'x') + "\"\n", {"gateway.name", "32 bytes"});
}

}  // namespace
}  // namespace config
