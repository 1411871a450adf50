#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "support/gateway/sample_status.hpp"
#include "wire/big_endian.hpp"
#include "wire/diagnostics.hpp"
#include "workbench/effects/catalogue.hpp"

namespace wire {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes object(int offset, const LoopStatus& loop) {
  std::array<std::uint8_t, 512> out{};
  const std::size_t size = encode_loop_object(offset, loop, out);
  return {out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size)};
}

Bytes did(std::uint16_t number) {
  const auto loops = support::sample_loops();
  const GatewayStatus gateway = support::sample_gateway();
  std::array<std::uint8_t, 4096> out{};
  const auto size = encode_did(number, {gateway, loops, 3}, out);
  return size ? Bytes(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(*size))
              : Bytes{};
}

Bytes text(std::string_view text, std::size_t bytes) {
  Bytes out(text.begin(), text.end());
  out.resize(bytes);
  return out;
}

TEST(Diagnostics, GoldenObjectsOfALoop) {
  const LoopStatus loop = support::sticking_loop();
  EXPECT_EQ(object(0, loop),
            (Bytes{4,    4,    195,  0,    0x01, 0xF5, 0x01, 0xF2, 0x01, 0xEA,
                   0x01, 0xE5, 0x00, 0x02, 0x23, 0xDA, 0,    0,    0,    12}));
  EXPECT_EQ(object(1, loop), text("FIC-211", 32));
  EXPECT_EQ(object(2, loop), (Bytes{0x14, 0x03, 0xFF, 0xCE, 0x13, 0x88, 1}));
  EXPECT_EQ(object(3, loop), (Bytes{0x08, 0x00, 0, 10, 0x24, 0xC2, 0xFE, 0xBB}));
  EXPECT_EQ(object(4, loop), (Bytes{13, 123, 0, 175}));
  EXPECT_EQ(object(5, loop), (Bytes{0, 2, 0, 6, 0, 50, 4, 4, 0, 1}));
  EXPECT_EQ(object(6, loop), (Bytes{0, 0, 0x01, 0x4E, 0x76, 0x9C, 0x9D, 0x59}));
  EXPECT_EQ(object(7, loop), text("u can0 LoopOP.OP, y can0 0x18F", 30));
  EXPECT_EQ(object(8, loop), (Bytes{0, 1, 0x86, 0xA0, 0, 0, 0, 3, 0, 0, 0, 1, 0, 0,
                                    0, 7, 0,    0,    0, 2, 0, 0, 0, 5, 0, 0, 0, 4}));
  EXPECT_EQ(object(9, loop), (Bytes{2, 0x0F, 0xA0, 0x0F, 0x0A, 0x10, 0x9A,  //
                                    0x17, 0x70, 0x16, 0x8F, 0xFF, 0xFF}));
  EXPECT_EQ(object(10, loop),
            (Bytes{0x01, 0xE0, 0x02, 0x08, 0x01, 0xDB, 0x02, 0x03, 0,    63,  //
                   0x08, 0x56, 0xFF, 0xE1, 0xFF, 0xD4, 0xFF, 0xEE, 0x00, 40}));
  EXPECT_TRUE(object(11, loop).empty());
  EXPECT_TRUE(object(-1, loop).empty());
}

TEST(Diagnostics, TheLastStandardIdentifierIsOne) {
  LoopStatus loop = support::sample_loops()[0];
  loop.id = 0x1F;
  EXPECT_FALSE(broadcast_frame(loop, 0x7E0).extended);
  EXPECT_TRUE(broadcast_frame(loop, 0x7E1).extended);
}

TEST(Diagnostics, WhatIsNotKnownIsAllOnes) {
  const LoopStatus loop = support::new_loop();
  EXPECT_EQ(object(0, loop),
            (Bytes{0,    0,    0xFF, 0,    0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF,
                   0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}));
  EXPECT_EQ(object(2, loop), (Bytes{0x7F, 0xFF, 0x7F, 0xFF, 0x7F, 0xFF, 0}));
  EXPECT_EQ(object(3, loop), (Bytes{0xFF, 0xFF, 0xFF, 0xFF, 0x7F, 0xFF, 0x7F, 0xFF}));
  EXPECT_EQ(object(6, loop), Bytes(8, 0xFF));
  EXPECT_EQ(object(9, loop), Bytes{0});
  EXPECT_EQ(object(10, loop),
            (Bytes{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF,  //
                   0x7F, 0xFF, 0x7F, 0xFF, 0x7F, 0xFF, 0x7F, 0xFF, 0xFF, 0xFF}));
  for (const LoopField& field : loop_fields()) {
    if (field.name == "stick_band_ascending_pct") {
      EXPECT_EQ(shown(field, loop), std::nullopt);
    }
  }
}

TEST(Diagnostics, GoldenObjectsOfTheGateway) {
  EXPECT_EQ(did(0xF186), Bytes{3});
  EXPECT_EQ(did(0xF18A), text("Stickband", 9));
  EXPECT_EQ(did(0xF18C), text("gw-17", 5));
  EXPECT_EQ(did(0xF195), text("0.1.0", 5));
  EXPECT_EQ(did(0xF197), text("Valve stiction monitor", 22));
  EXPECT_EQ(did(0xFD00), (Bytes{4, 2, 1, 0, 0, 0x0E, 0x10, 0xCB, 0xF4, 0x39, 0x26}));
  EXPECT_EQ(did(0xFD03), Bytes(24));
  EXPECT_EQ(did(0xFD10), object(0, support::sticking_loop()));
  EXPECT_EQ(did(0xFEF1), text("LIC-400", 32));
  for (const int absent : {0x0000, 0xF187, 0xFD04, 0xFD1B, 0xFD20, 0xFF00}) {
    EXPECT_TRUE(did(static_cast<std::uint16_t>(absent)).empty()) << absent;
  }
}

TEST(Diagnostics, DirectoryListsEveryObjectWithItsLength) {
  const Bytes directory = did(kDirectoryDid);
  ASSERT_EQ(directory.size() % 4, 0U);
  std::set<std::uint16_t> seen;
  for (std::size_t at = 0; at < directory.size(); at += 4) {
    const auto number =
        static_cast<std::uint16_t>(get_big_endian(std::span(directory).subspan(at, 2)));
    const auto length = get_big_endian(std::span(directory).subspan(at + 2, 2));
    EXPECT_TRUE(seen.insert(number).second) << number;
    EXPECT_EQ(did(number).size(), length) << number;
  }
  EXPECT_EQ(seen.size(), 9 + 2 * loop_objects().size());
}

TEST(Diagnostics, TooSmallAnOutputSaysHowMuchItTakes) {
  const auto loops = support::sample_loops();
  const GatewayStatus gateway = support::sample_gateway();
  std::array<std::uint8_t, 20> out{};
  for (std::size_t room = 0; room < out.size(); ++room) {
    out.fill(0xEE);
    EXPECT_EQ(encode_did(0xFD10, {gateway, loops, 1}, std::span(out).first(room)), 20U);
    EXPECT_EQ(encode_loop_object(0, loops[0], std::span(out).first(room)), 0U);
    EXPECT_EQ(out[room], 0xEE) << "wrote beyond " << room;
  }
}

TEST(Diagnostics, TableIsConsistent) {
  std::set<std::string_view> names;
  int last = -1;
  for (const LoopField& field : loop_fields()) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_GE(static_cast<int>(field.object), last) << field.name;
    last = field.object;
    EXPECT_LT(field.object, loop_objects().size());
    EXPECT_EQ((field.number != nullptr) + (field.text != nullptr),
              field.type == FieldType::kPath ? 0 : 1);
    EXPECT_FALSE(field.meaning.empty());
    EXPECT_GT(field.scale, 0);
  }
  for (std::size_t i = 0; i < loop_objects().size(); ++i) {
    EXPECT_EQ(loop_objects()[i].offset, i);
    EXPECT_EQ(loop_objects()[i].writable, i == 5);
  }
  for (const GatewayField& field : gateway_fields()) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
  }
  EXPECT_EQ(object(0, support::sticking_loop()).size(), kStateBytes);
  EXPECT_EQ(object(3, support::sticking_loop()).size(), kWindowBytes);
  EXPECT_EQ(object(5, support::sticking_loop()).size(), kParameterBytes);
}

TEST(Diagnostics, EffectsAreThoseOfTheWorkbench) {
  const auto effects = workbench::standard_catalogue().effects();
  for (const LoopField& field : loop_fields()) {
    if (field.name != "suspect_effect") continue;
    ASSERT_EQ(field.choices.size(), effects.size() + 1);
    for (std::size_t i = 0; i < field.choices.size(); ++i) {
      EXPECT_EQ(field.choices[i].value, i);
      EXPECT_EQ(field.choices[i].name, i == 0 ? "none" : effects[i - 1]->code());
    }
  }
}

TEST(Diagnostics, RawValuesRoundSaturateAndComeBack) {
  EXPECT_EQ(to_raw(FieldType::kU16, 0.01, 5.014), 501U);
  EXPECT_EQ(to_raw(FieldType::kU16, 0.01, 5.016), 502U);
  EXPECT_EQ(to_raw(FieldType::kU16, 0.01, 1e9), 0xFFFEU);
  EXPECT_EQ(to_raw(FieldType::kU16, 0.01, -1), 0U);
  EXPECT_EQ(to_raw(FieldType::kI16, 0.01, 1e9), 0x7FFEU);
  EXPECT_EQ(to_raw(FieldType::kI16, 0.01, -1e9), 0x8000U);
  EXPECT_EQ(to_raw(FieldType::kU8, 0.5, 100), 200U);
  EXPECT_EQ(to_raw(FieldType::kU32, 1, std::numeric_limits<double>::infinity()),
            0xFFFFFFFEU);
  EXPECT_EQ(to_raw(FieldType::kU64, 0.001, 1e300), 1ULL << 53);
  EXPECT_EQ(to_raw(FieldType::kI16, 0.01, std::nan("")), 0x7FFFU);
  EXPECT_EQ(to_raw(FieldType::kU64, 1, std::nan("")), ~0ULL);
  EXPECT_EQ(from_raw(FieldType::kI16, 0.01, 0xFFCE), -0.5);
  EXPECT_EQ(from_raw(FieldType::kU16, 0.01, 501), 5.01) << "the nearest double";
  EXPECT_EQ(from_raw(FieldType::kU8, 0.5, 195), 97.5);
  EXPECT_EQ(from_raw(FieldType::kI16, 0.01, 0x7FFF), std::nullopt);
  EXPECT_EQ(from_raw(FieldType::kU16, 0.01, 0x7FFF), 327.67);
  for (const FieldType type : {FieldType::kU8, FieldType::kU16, FieldType::kI16}) {
    for (std::uint64_t raw = 0; raw <= (type == FieldType::kU8 ? 0xFF : 0xFFFF); ++raw) {
      const double back = from_raw(type, 0.01, raw).value_or(kNotAvailable);
      ASSERT_EQ(to_raw(type, 0.01, back), raw);
    }
  }
}

TEST(Diagnostics, Ne107FollowsTheParameters) {
  LoopStatus loop = support::sticking_loop();
  EXPECT_EQ(ne107_of(loop), Ne107::kMaintenanceRequired);
  loop.parameters.stiction = Ne107::kOffSpec;
  EXPECT_EQ(ne107_of(loop), Ne107::kOffSpec);
  loop.confirmed = false;
  EXPECT_EQ(ne107_of(loop), Ne107::kNormal) << "not before the on-delay";
  loop.confirmed = true;
  loop.verdict = LoopVerdict::kOtherOscillation;
  EXPECT_EQ(ne107_of(loop), Ne107::kNormal);
  loop.verdict = LoopVerdict::kBacklash;
  EXPECT_EQ(ne107_of(loop), Ne107::kMaintenanceRequired);
  loop.input = InputStatus::kUncertain;
  EXPECT_EQ(ne107_of(loop), Ne107::kMaintenanceRequired);
  loop.input = InputStatus::kCurrentLow;
  EXPECT_EQ(ne107_of(loop), Ne107::kFailure);
  loop.simulated = true;
  EXPECT_EQ(ne107_of(loop), Ne107::kCheckFunction);
}

TEST(Diagnostics, WorstOfAllLoops) {
  std::array<LoopStatus, 3> loops = {support::new_loop(), support::new_loop(),
                                     support::new_loop()};
  EXPECT_EQ(worst_ne107({}), Ne107::kNormal);
  EXPECT_EQ(worst_ne107(loops), Ne107::kNormal);
  loops[1] = support::sticking_loop();
  EXPECT_EQ(worst_ne107(loops), Ne107::kMaintenanceRequired);
  loops[0] = loops[1];
  loops[0].parameters.stiction = Ne107::kOffSpec;
  EXPECT_EQ(worst_ne107(loops), Ne107::kOffSpec);
  loops[2].simulated = true;
  EXPECT_EQ(worst_ne107(loops), Ne107::kCheckFunction);
  loops[1].input = InputStatus::kMissing;
  EXPECT_EQ(worst_ne107(loops), Ne107::kFailure);
}

TEST(Diagnostics, ParametersComeBackOrAreRefused) {
  LoopStatus loop;
  loop.parameters = {3,
                     1000,
                     12.34,
                     Ne107::kOffSpec,
                     Ne107::kNormal,
                     Ne107::kFailure,
                     Ne107::kCheckFunction};
  const Bytes good = object(5, loop);
  LoopParameters back;
  ASSERT_TRUE(decode_parameters(good, back));
  loop.parameters = back;
  EXPECT_EQ(object(5, loop), good);

  const auto refused = [&](std::size_t at, std::uint8_t value) {
    Bytes bad = good;
    bad[at] = value;
    LoopParameters untouched;
    const bool accepted = decode_parameters(bad, untouched);
    return !accepted && untouched.on_delay_windows == LoopParameters{}.on_delay_windows;
  };
  EXPECT_TRUE(refused(0, 0x10));
  EXPECT_TRUE(refused(1, 0));
  EXPECT_TRUE(refused(2, 0xFF));
  EXPECT_TRUE(refused(4, 0xFF));
  for (const std::size_t at : {6U, 7U, 8U, 9U}) EXPECT_TRUE(refused(at, 5)) << at;
  EXPECT_FALSE(decode_parameters(std::span(good).first(9), back));
  EXPECT_FALSE(decode_parameters({}, back));
  Bytes not_available = good;
  not_available[4] = not_available[5] = 0xFF;
  EXPECT_FALSE(decode_parameters(not_available, back));
}

TEST(Diagnostics, BroadcastIsTheStartOfTheState) {
  const LoopStatus loop = support::sticking_loop();
  const CanFrame frame = broadcast_frame(loop);
  EXPECT_EQ(frame.id, 0x191U);
  EXPECT_FALSE(frame.extended);
  EXPECT_EQ(frame.dlc, 8);
  EXPECT_EQ(Bytes(frame.data.begin(), frame.data.begin() + frame.dlc),
            (Bytes{4, 4, 195, 0, 0x01, 0xF5, 0x01, 0xF2}));
  EXPECT_TRUE(broadcast_frame(loop, 0x18FF0000).extended);
}

TEST(Diagnostics, DetailsHaveFramesOfTheirOwn) {
  const LoopStatus loop = support::sticking_loop();
  const CanFrame band = detail_frame(2, loop);
  EXPECT_EQ(band.id, 0x1B1U);
  EXPECT_EQ(Bytes(band.data.begin(), band.data.begin() + band.dlc),
            (Bytes{0x01, 0xE0, 0x02, 0x08, 0x01, 0xDB, 0x02, 0x03}));
  const CanFrame trend = detail_frame(3, loop);
  EXPECT_EQ(trend.id, 0x1D1U);
  EXPECT_EQ(Bytes(trend.data.begin(), trend.data.begin() + trend.dlc),
            (Bytes{0, 0, 0, 12, 0, 63, 0xFF, 0xE1}));
  EXPECT_EQ(detail_frame(3, loop, 0x500).id, 0x521U);
}

TEST(Diagnostics, FramesHoldWhatNamesThem) {
  std::array<std::size_t, kBroadcastFrames + 1> bytes{};
  for (const LoopField& field : loop_fields()) {
    ASSERT_LE(field.frame, kBroadcastFrames) << field.name;
    bytes[field.frame] += size_of(field.type);
  }
  for (int frame = 1; frame <= kBroadcastFrames; ++frame) {
    EXPECT_EQ(bytes[static_cast<std::size_t>(frame)], kMaxClassicLength) << frame;
  }
}

TEST(Diagnostics, TextsAndPathsAreCutToTheirRoom) {
  LoopStatus loop;
  loop.tag.assign(std::string(40, 'x'));
  EXPECT_EQ(object(1, loop), text(std::string(32, 'x'), 32));
  loop.path_knots = 255;
  EXPECT_EQ(object(9, loop).size(), 1 + 6 * kMostPathKnots);
}

TEST(Diagnostics, SeverityOrdersTheNe107Status) {
  EXPECT_EQ(severity(Ne107::kNormal), 0);
  EXPECT_EQ(severity(Ne107::kMaintenanceRequired), 1);
  EXPECT_EQ(severity(Ne107::kOffSpec), 2);
  EXPECT_EQ(severity(Ne107::kCheckFunction), 3);
  EXPECT_EQ(severity(Ne107::kFailure), 4);
}

TEST(Diagnostics, ParametersAtTheirEndsAreValid) {
  LoopParameters p;
  p.on_delay_windows = p.off_delay_windows = 1;
  p.band_min_pct = 0;
  EXPECT_TRUE(is_valid(p));
  p.on_delay_windows = p.off_delay_windows = 1000;
  p.band_min_pct = 100;
  EXPECT_TRUE(is_valid(p));
  for (const std::uint16_t windows : {std::uint16_t{0}, std::uint16_t{1001}}) {
    LoopParameters bad;
    bad.on_delay_windows = windows;
    EXPECT_FALSE(is_valid(bad)) << windows;
    bad = {};
    bad.off_delay_windows = windows;
    EXPECT_FALSE(is_valid(bad)) << windows;
  }
  for (const double band : {-0.01, 100.01}) {
    LoopParameters bad;
    bad.band_min_pct = band;
    EXPECT_FALSE(is_valid(bad)) << band;
  }
}

}  // namespace
}  // namespace wire
