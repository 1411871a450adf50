#include <gtest/gtest.h>

#include <array>
#include <string>

#include "wire/dbc.hpp"

namespace wire {
namespace {

constexpr std::string_view kPlant =
    "VERSION \"\"\n"
    "NS_ :\n"
    "\tNS_DESC_\n\tCM_\n\tVAL_\n\tSIG_VALTYPE_\n\tSG_MUL_VAL_\n"
    "BS_:\n"
    "BU_: PLC GW // nodes\n"
    "\n"
    "BO_ 399 LoopOP: 8 PLC\n"
    " SG_ OP : 0|16@1+ (0.01,0) [0|100] \"%\" GW\n"
    " SG_ Mode m1 : 16|8@1+ (1,0) [0|3] \"\" GW\n"
    " SG_ Page M : 24|8@1+ (1,0) [0|0] \"\" GW\n"
    " SG_ Travel m2 : 32|32@1- (1,0) [0|0] \"%\" GW\n"
    "BO_ 2566852608 LoopPV: 8 PLC\n"
    "\tSG_\tPV:7|16@0-(0.1,-40)[-1E3|1E3]\"\xC2\xB0"
    "C\"\tGW,PLC\n"
    "BO_ 3221225472 VECTOR__INDEPENDENT_SIG_MSG: 0 Vector__XXX\n"
    " SG_ Lost : 0|99@1+ (1,0) [0|0] \"\" GW\n"
    "CM_ SG_ 399 OP \"Controller output.\nBO_ 1 Fake: 8 X\n SG_ broken\";\n"
    "VAL_ 399 Mode 0 \"manual\" 1 \"auto\" ;\n"
    "SIG_VALTYPE_ 399 Travel : 1;\n";

struct Loaded {
  std::array<DbcMessage, 4> messages;
  std::array<DbcSignal, 8> signals;
  Dbc dbc{messages, signals};
};

DbcStatus dbc_status_of(std::string_view text) {
  Loaded loaded;
  return loaded.dbc.parse(text);
}

TEST(Dbc, ReadsMessagesAndSignals) {
  Loaded l;
  ASSERT_TRUE(l.dbc.parse(kPlant).ok());
  ASSERT_EQ(l.dbc.messages().size(), 2U);
  const DbcMessage& op = l.dbc.messages()[0];
  EXPECT_EQ(op.name, "LoopOP");
  EXPECT_EQ(op.id, 399U);
  EXPECT_EQ(op.length, 8);
  EXPECT_EQ(op.line, 11U);
  ASSERT_EQ(l.dbc.signals_of(op).size(), 4U);
  EXPECT_EQ(l.dbc.signals_of(op)[0].unit, "%");
  const DbcMessage& pv = l.dbc.messages()[1];
  EXPECT_TRUE(pv.extended);
  EXPECT_EQ(pv.id, 0x18FF1000U);

  FrameSignal s;
  ASSERT_TRUE(l.dbc.find("LoopPV.PV", s).ok());
  EXPECT_EQ(s.frame_id, 0x18FF1000U);
  EXPECT_TRUE(s.extended);
  EXPECT_EQ(s.signal.start, 7);
  EXPECT_EQ(s.signal.length, 16);
  EXPECT_EQ(s.signal.byte_order, ByteOrder::kBigEndian);
  EXPECT_TRUE(s.signal.is_signed);
  EXPECT_EQ(s.signal.scale, 0.1);
  EXPECT_EQ(s.signal.offset, -40);
  EXPECT_EQ(s.signal.minimum, -1000);
  EXPECT_EQ(s.signal.maximum, 1000);
  EXPECT_FALSE(s.multiplexed);
}

TEST(Dbc, MultiplexedFloatSignal) {
  Loaded l;
  ASSERT_TRUE(l.dbc.parse(kPlant).ok());
  FrameSignal s;
  ASSERT_TRUE(l.dbc.find("LoopOP.Travel", s).ok());
  EXPECT_TRUE(s.multiplexed);
  EXPECT_EQ(s.multiplex_value, 2U);
  EXPECT_EQ(s.multiplexor.start, 24);
  EXPECT_EQ(s.signal.type, ValueType::kFloat32);
}

TEST(Dbc, AMessageOfNobodyIsItsParameterGroupFromAnySender) {
  Loaded loaded;
  ASSERT_TRUE(loaded.dbc
                  .parse("BO_ 2314213630 Group: 8 X\n"  // 09F018FE
                         " SG_ A : 0|16@1- (1,0) [0|0] \"\" X\n"
                         "BO_ 2147488510 ToOne: 8 X\n"  // 000012FE
                         " SG_ C : 0|16@1- (1,0) [0|0] \"\" X\n"
                         "BO_ 254 Short: 8 X\n"
                         " SG_ B : 0|16@1- (1,0) [0|0] \"\" X\n")
                  .ok());
  FrameSignal signal;
  ASSERT_TRUE(loaded.dbc.find("Group.A", signal).ok());
  EXPECT_EQ(signal.frame_id, 0x01F01800U);
  EXPECT_EQ(signal.ignored, 0x1C0000FFU);
  ASSERT_TRUE(loaded.dbc.find("Short.B", signal).ok());
  EXPECT_EQ(signal.frame_id, 254U);
  ASSERT_TRUE(loaded.dbc.find("ToOne.C", signal).ok());
  EXPECT_EQ(signal.frame_id, 0x12FEU);
  EXPECT_EQ(signal.ignored, 0U) << "no broadcast group";
  ASSERT_TRUE(loaded.dbc.find("Short.B", signal).ok());
  EXPECT_EQ(signal.ignored, 0U);
}

TEST(Dbc, LineEndsAndMarkMakeNoDifference) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text = "\xEF\xBB\xBF";
    for (const char c : kPlant) text += c == '\n' ? end : std::string(1, c);
    Loaded l;
    ASSERT_TRUE(l.dbc.parse(text).ok());
    FrameSignal s;
    EXPECT_TRUE(l.dbc.find("LoopOP.Travel", s).ok());
    EXPECT_EQ(l.dbc.messages()[1].line, 16U);
  }
}

TEST(Dbc, ErrorsNameLineColumnAndFinding) {
  struct Case {
    const char* text;
    DbcError error;
    std::uint32_t line;
    std::uint32_t column;
  };
  for (const Case& c : {
           Case{"\nBO_ x M: 8 X\n", DbcError::kMessageId, 2, 5},
           Case{"BO_ 2048 M: 8 X\n", DbcError::kMessageId, 1, 5},
           Case{"BO_ 4294967296 M: 8 X\n", DbcError::kMessageId, 1, 5},
           Case{"BO_ 3758096384 M: 8 X\n", DbcError::kMessageId, 1, 5},
           Case{"BO_ 1\n", DbcError::kMessageName, 1, 6},
           Case{"BO_ 1 M 8 X\n", DbcError::kMessageColon, 1, 9},
           Case{"BO_ 1 M: X\n", DbcError::kMessageLength, 1, 10},
           Case{"SG_ S : 0|8@1+ (1,0) [0|0] \"\" X\n", DbcError::kSignalOutsideMessage, 1,
                5},
           Case{"BO_ 1 M: 8 X\n SG_ : 0|8@1+\n", DbcError::kSignalName, 2, 6},
           Case{"BO_ 1 M: 8 X\n SG_ S x : 0|8@1+\n", DbcError::kMultiplexing, 2, 8},
           Case{"BO_ 1 M: 8 X\n SG_ S m : 0|8@1+\n", DbcError::kMultiplexing, 2, 8},
           Case{"BO_ 1 M: 8 X\n SG_ S M 0|8@1+\n", DbcError::kSignalColon, 2, 10},
           Case{"BO_ 1 M: 8 X\n SG_ S : a|8@1+\n", DbcError::kStart, 2, 10},
           Case{"BO_ 1 M: 8 X\n SG_ S : 0|x@1+\n", DbcError::kLength, 2, 12},
           Case{"BO_ 1 M: 8 X\n SG_ S : 0|8@2+\n", DbcError::kByteOrder, 2, 14},
           Case{"BO_ 1 M: 8 X\n SG_ S : 0|8@1 (1,0)\n", DbcError::kSign, 2, 16},
           Case{"BO_ 1 M: 8 X\n SG_ S : 0|8@1+ (1;0)\n", DbcError::kScaleOffset, 2, 19},
           Case{"BO_ 1 M: 8 X\n SG_ S : 0|8@1+ (0,0)\n", DbcError::kScaleOffset, 2, 18},
           Case{"BO_ 1 M: 8 X\n SG_ S : 0|8@1+ (1,0) 0\n", DbcError::kLimits, 2, 23},
           Case{"BO_ 1 M: 8 X\n SG_ S : 0|8@1+ (1,0) [0|0] %\n", DbcError::kUnit, 2, 29},
           Case{"BO_ 1 M: 8 X\nSIG_VALTYPE_ 1 S : 3;\n", DbcError::kValueType, 2, 20},
           Case{"BO_ 1 M: 8 X\nSG_MUL_VAL_ 1 S P x;\n", DbcError::kMultiplexRange, 2, 19},
           Case{"BO_ 1 M: 8 X\nCM_ \"never\n\n", DbcError::kOpenString, 2, 5},
           Case{"t,u,y\n0,1,2\n", DbcError::kNoMessage, 0, 0},
           Case{"", DbcError::kNoMessage, 0, 0},
       }) {
    const DbcStatus status = dbc_status_of(c.text);
    EXPECT_EQ(status.error, c.error) << c.text << expected_at(status.error);
    EXPECT_EQ(status.line, c.line) << c.text;
    EXPECT_EQ(status.column, c.column) << c.text << status.found;
  }
  EXPECT_EQ(dbc_status_of("BO_ 1 M: 8 X\n SG_ S : 0|8@2+\n").found, "2+");
  EXPECT_EQ(dbc_status_of("BO_ 1 M: 8 X\n SG_ S : a23456789012345678901234567").found,
            "a23456789012345678901234");
  EXPECT_NE(dbc_status_of("BO_ 1 M: 8 X\n SG_ S : 65535|8@1+\n").error, DbcError::kStart);
}

TEST(Dbc, CapacityIsTheCallers) {
  std::string many;
  for (int i = 0; i < 5; ++i) {
    many += "BO_ " + std::to_string(i) + " M" + std::to_string(i) + ": 8 X\n";
  }
  EXPECT_EQ(dbc_status_of(many).error, DbcError::kTooManyMessages);
  EXPECT_EQ(dbc_status_of(many).line, 5U);
  std::string wide = "BO_ 1 M: 8 X\n";
  for (int i = 0; i < 9; ++i)
    wide += " SG_ S" + std::to_string(i) + " : 0|8@1+ (1,0) [0|0] \"\" X\n";
  EXPECT_EQ(dbc_status_of(wide).error, DbcError::kTooManySignals);
  EXPECT_EQ(dbc_status_of(wide).line, 10U);
}

TEST(Dbc, FindRefusesByName) {
  const std::string text =
      "BO_ 1 A: 2 X\n"
      " SG_ Wide : 8|16@1+ (1,0) [0|0] \"\" X\n"
      " SG_ Twice : 0|8@1+ (1,0) [0|0] \"\" X\n"
      " SG_ Twice : 8|8@1+ (1,0) [0|0] \"\" X\n"
      " SG_ Lonely m1 : 8|8@1+ (1,0) [0|0] \"\" X\n"
      "BO_ 2 B: 64 X\n"
      " SG_ Far : 505|8@1+ (1,0) [0|0] \"\" X\n"
      "BO_ 3 C: 8 X\n"
      " SG_ P M : 0|8@1+ (1,0) [0|0] \"\" X\n"
      " SG_ Ranged m1 : 8|8@1+ (1,0) [0|0] \"\" X\n"
      " SG_ Exact m2 : 8|8@1+ (1,0) [0|0] \"\" X\n"
      "SG_MUL_VAL_ 3 Ranged P 1-1, 3-4;\n"
      "SG_MUL_VAL_ 3 Exact P 2-2;\n";
  Loaded l;
  ASSERT_TRUE(l.dbc.parse(text).ok());
  FrameSignal s;
  EXPECT_EQ(l.dbc.find("A", s).error, DbcError::kReference);
  EXPECT_EQ(l.dbc.find("A.", s).error, DbcError::kReference);
  EXPECT_EQ(l.dbc.find(".Wide", s).error, DbcError::kReference);
  EXPECT_EQ(l.dbc.find("Z.Wide", s).error, DbcError::kUnknownMessage);
  EXPECT_EQ(l.dbc.find("A.wide", s).error, DbcError::kUnknownSignal);
  EXPECT_EQ(l.dbc.find("A.Twice", s).error, DbcError::kAmbiguous);
  EXPECT_EQ(l.dbc.find("A.Twice", s).line, 4U);
  EXPECT_EQ(l.dbc.find("A.Lonely", s).error, DbcError::kNoMultiplexor);
  EXPECT_EQ(l.dbc.find("A.Wide", s).error, DbcError::kLayout);
  EXPECT_EQ(l.dbc.find("A.Wide", s).layout, SignalError::kShortFrame);
  EXPECT_EQ(l.dbc.find("B.Far", s).layout, SignalError::kOutsideFrame);
  EXPECT_EQ(l.dbc.find("C.Ranged", s).error, DbcError::kExtendedMultiplexing);
  EXPECT_TRUE(l.dbc.find("C.Exact", s).ok());

  ASSERT_TRUE(
      l.dbc.parse("BO_ 2 B: 64 X\n SG_ Last : 504|8@1+ (1,0) [0|0] \"\" X\n").ok());
  EXPECT_TRUE(l.dbc.find("B.Last", s).ok()) << "a message of CAN FD";
  EXPECT_TRUE(needs_fd(s));

  ASSERT_TRUE(l.dbc
                  .parse("BO_ 1 A: 8 X\n SG_ P M : 0|8@1+ (1,0) [0|0] \"\" X\n"
                         " SG_ Q m0M : 8|8@1+ (1,0) [0|0] \"\" X\n"
                         " SG_ R m1 : 16|8@1+ (1,0) [0|0] \"\" X\n")
                  .ok());
  EXPECT_TRUE(l.dbc.find("A.P", s).ok());
  EXPECT_EQ(l.dbc.find("A.Q", s).error, DbcError::kExtendedMultiplexing);
  EXPECT_EQ(l.dbc.find("A.R", s).error, DbcError::kExtendedMultiplexing);

  ASSERT_TRUE(l.dbc.parse("BO_ 1 A: 8 X\nBO_ 2 A: 8 X\n").ok());
  EXPECT_EQ(l.dbc.find("A.P", s).error, DbcError::kAmbiguous);
}

}  // namespace
}  // namespace wire
