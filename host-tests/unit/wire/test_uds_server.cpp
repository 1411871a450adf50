#include <gtest/gtest.h>

#include "support/uds/tester.hpp"
#include "wire/big_endian.hpp"
#include "wire/uds_server.hpp"

namespace wire {
namespace {

using support::Bytes;
using support::refusal;
using support::writing_settings;
using support::operator+;
using Tester = support::UdsTester;

const Bytes kParameters = {0, 3, 0, 9, 0, 100, 4, 3, 0, 1};

TEST(UdsServer, SessionControl) {
  Tester t;
  EXPECT_EQ(t.ask({0x10, 0x03}), (Bytes{0x50, 0x03, 0x00, 0x32, 0x01, 0xF4}));
  EXPECT_EQ(t.server.session(), 3);
  EXPECT_EQ(t.ask({0x22, 0xF1, 0x86}), (Bytes{0x62, 0xF1, 0x86, 3}));
  EXPECT_EQ(t.ask({0x10, 0x01}), (Bytes{0x50, 0x01, 0x00, 0x32, 0x01, 0xF4}));
  EXPECT_TRUE(t.ask({0x10, 0x83}).empty());
  EXPECT_EQ(t.server.session(), 3);
  EXPECT_EQ(t.ask({0x10, 0x02}), refusal(0x10, Nrc::kSubFunctionNotSupported));
  EXPECT_EQ(t.ask({0x10}), refusal(0x10, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x10, 0x01, 0x00}), refusal(0x10, Nrc::kIncorrectLength));
  EXPECT_EQ(t.server.session(), 3);
}

TEST(UdsServer, SessionEndsAfterS3) {
  Tester t;
  (void)t.ask({0x10, 0x03});
  t.now_us += UdsServer::kS3Us - 1;
  t.server.advance(t.now_us);
  EXPECT_EQ(t.server.session(), 3);
  EXPECT_EQ(t.ask({0x3E, 0x00}), (Bytes{0x7E, 0x00}));
  t.now_us += UdsServer::kS3Us - 1;
  EXPECT_TRUE(t.ask({0x3E, 0x80}).empty());
  t.now_us += UdsServer::kS3Us;
  EXPECT_EQ(t.ask({0x22, 0xF1, 0x86}), (Bytes{0x62, 0xF1, 0x86, 1}))
      << "even when nobody called advance()";
}

TEST(UdsServer, TesterPresent) {
  Tester t;
  EXPECT_EQ(t.ask({0x3E, 0x00}), (Bytes{0x7E, 0x00}));
  EXPECT_TRUE(t.ask({0x3E, 0x80}).empty());
  EXPECT_EQ(t.ask({0x3E, 0x01}), refusal(0x3E, Nrc::kSubFunctionNotSupported));
  EXPECT_EQ(t.ask({0x3E, 0x81}), refusal(0x3E, Nrc::kSubFunctionNotSupported));
  EXPECT_EQ(t.ask({0x3E}), refusal(0x3E, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x3E, 0, 0}), refusal(0x3E, Nrc::kIncorrectLength));
}

TEST(UdsServer, EveryOtherServiceIsRefused) {
  Tester t(writing_settings());
  const Bytes served = {0x10, 0x14, 0x19, 0x22, 0x27, 0x2E, 0x31, 0x35, 0x36, 0x37, 0x3E};
  for (int service = 0; service <= 0xFF; ++service) {
    const auto sid = static_cast<std::uint8_t>(service);
    const bool refused = t.ask({sid}) == refusal(sid, Nrc::kServiceNotSupported);
    const bool known = std::find(served.begin(), served.end(), sid) != served.end();
    EXPECT_EQ(refused, !known) << service;
  }
  EXPECT_TRUE(t.ask({}).empty());
}

TEST(UdsServer, ReadsOneAndSeveralObjects) {
  Tester t;
  const Bytes state = t.ask({0x22, 0xFD, 0x10});
  ASSERT_EQ(state.size(), 3 + kStateBytes);
  EXPECT_EQ(state[3], 4);
  const Bytes both = t.ask({0x22, 0xFD, 0x10, 0xF1, 0x95});
  EXPECT_EQ(both, (state + Bytes{0xF1, 0x95, '0', '.', '1', '.', '0'}));
  EXPECT_EQ(t.ask({0x22, 0x12, 0x34, 0xF1, 0x95}),
            (Bytes{0x62, 0xF1, 0x95, '0', '.', '1', '.', '0'}))
      << "what is not there is left out";
  EXPECT_EQ(t.ask({0x22, 0x12, 0x34}), refusal(0x22, Nrc::kRequestOutOfRange));
  EXPECT_EQ(t.ask({0x22}), refusal(0x22, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x22, 0xFD}), refusal(0x22, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x22, 0xFD, 0x10, 0xFD}), refusal(0x22, Nrc::kIncorrectLength));
}

TEST(UdsServer, ReadsEveryObjectOfTheDirectory) {
  Tester t;
  const Bytes answer = t.ask({0x22, 0xFD, 0x01});
  for (std::size_t at = 3; at < answer.size(); at += 4) {
    const Bytes object = t.ask({0x22, answer[at], answer[at + 1]});
    EXPECT_EQ(object.size(), 3 + get_big_endian(std::span(answer).subspan(at + 2, 2)));
  }
}

TEST(UdsServer, TooLongAResponseIsSaidToBe) {
  Tester t;
  const Bytes request = {0x22, 0xFD, 0x10, 0xFD, 0x11};
  const std::size_t needed = t.ask(request).size();
  std::array<std::uint8_t, 64> small{};
  for (std::size_t room = 3; room <= small.size(); ++room) {
    small.fill(0xEE);
    const auto response =
        t.server.handle(request, false, t.now_us, std::span(small).first(room));
    const bool fits = room >= needed;
    EXPECT_EQ(response.size(), fits ? needed : 3) << room;
    EXPECT_EQ(response[0], fits ? 0x62 : 0x7F) << room;
    if (room < small.size()) {
      EXPECT_EQ(small[room], 0xEE) << room;
    }
  }
  Bytes many = {0x22};
  for (int i = 0; i < 200; ++i) many = many + Bytes{0xFD, 0x11};
  EXPECT_EQ(t.ask(many), refusal(0x22, Nrc::kResponseTooLong));
}

TEST(UdsServer, WritesOnlyUnlockedInTheExtendedSession) {
  Tester t(writing_settings());
  const Bytes write = Bytes{0x2E, 0xFD, 0x15} + kParameters;
  EXPECT_EQ(t.ask(write), refusal(0x2E, Nrc::kServiceNotInSession));
  (void)t.ask({0x10, 0x03});
  EXPECT_EQ(t.ask(write), refusal(0x2E, Nrc::kSecurityAccessDenied));
  t.unlock();
  EXPECT_EQ(t.ask(write), (Bytes{0x6E, 0xFD, 0x15}));
  EXPECT_EQ(t.daemon.loops[0].parameters.on_delay_windows, 3);
  EXPECT_EQ(t.daemon.loops[0].parameters.backlash, Ne107::kOffSpec);
  EXPECT_EQ(t.ask({0x22, 0xFD, 0x15}), (Bytes{0x62, 0xFD, 0x15} + kParameters));
  (void)t.ask({0x10, 0x03});
  EXPECT_EQ(t.ask(write), refusal(0x2E, Nrc::kSecurityAccessDenied))
      << "a new session is locked";
}

TEST(UdsServer, WriteRefusals) {
  Tester t(writing_settings());
  EXPECT_EQ(t.ask({0x2E, 0xFD, 0x15}), refusal(0x2E, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x2E, 0xFD, 0x15, 0}), refusal(0x2E, Nrc::kIncorrectLength))
      << "length before session";
  t.unlock();
  EXPECT_EQ(t.ask(Bytes{0x2E, 0xFD, 0x15} + kParameters + Bytes{0}),
            refusal(0x2E, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x2E, 0xFD, 0x10, 0}), refusal(0x2E, Nrc::kRequestOutOfRange));
  EXPECT_EQ(t.ask(Bytes{0x2E, 0xFD, 0x25} + kParameters),
            refusal(0x2E, Nrc::kRequestOutOfRange));
  Bytes out_of_range = kParameters;
  out_of_range[6] = 9;
  EXPECT_EQ(t.ask(Bytes{0x2E, 0xFD, 0x15} + out_of_range),
            refusal(0x2E, Nrc::kRequestOutOfRange));
  t.daemon.willing = false;
  EXPECT_EQ(t.ask(Bytes{0x2E, 0xFD, 0x15} + kParameters),
            refusal(0x2E, Nrc::kConditionsNotCorrect));
}

TEST(UdsServer, ReadOnlyUnlessConfigured) {
  UdsSettings settings = writing_settings();
  settings.writes = false;
  Tester t(settings);
  t.unlock();
  EXPECT_EQ(t.ask(Bytes{0x2E, 0xFD, 0x15} + kParameters),
            refusal(0x2E, Nrc::kConditionsNotCorrect));
  EXPECT_EQ(t.ask({0x31, 0x01, 0xF0, 0x00}), refusal(0x31, Nrc::kConditionsNotCorrect));
  EXPECT_EQ(t.ask({0x31, 0x01, 0xF0, 0x02, 1, 4}),
            refusal(0x31, Nrc::kConditionsNotCorrect));
  EXPECT_EQ(t.daemon.loops[0].parameters.on_delay_windows, 2);
  EXPECT_TRUE(t.daemon.resets.empty());
  EXPECT_FALSE(t.daemon.loops[0].simulated);
}

TEST(UdsServer, WithoutKeyThereIsNoUnlocking) {
  UdsSettings settings;
  settings.writes = true;
  Tester t(settings);
  (void)t.ask({0x10, 0x03});
  EXPECT_EQ(t.ask({0x27, 0x01}), refusal(0x27, Nrc::kServiceNotSupported));
  EXPECT_EQ(t.ask(Bytes{0x2E, 0xFD, 0x15} + kParameters),
            refusal(0x2E, Nrc::kSecurityAccessDenied));
}

TEST(UdsServer, SecurityAccess) {
  Tester t(writing_settings());
  EXPECT_EQ(t.ask({0x27, 0x01}), refusal(0x27, Nrc::kServiceNotInSession));
  EXPECT_EQ(t.ask({0x27}), refusal(0x27, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x27, 0x03}), refusal(0x27, Nrc::kSubFunctionNotSupported));
  EXPECT_EQ(t.ask({0x27, 0x01, 0x00}), refusal(0x27, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x27, 0x02, 0x00}), refusal(0x27, Nrc::kIncorrectLength));
  (void)t.ask({0x10, 0x03});
  EXPECT_EQ(t.ask(Bytes{0x27, 0x02} + Bytes(16)),
            refusal(0x27, Nrc::kRequestSequenceError));
  const Bytes first = t.seed();
  const Bytes second = t.seed();
  ASSERT_EQ(first.size(), 16U);
  EXPECT_NE(first, second);
  EXPECT_EQ(t.ask(Bytes{0x27, 0x02} + t.key_for(first)), refusal(0x27, Nrc::kInvalidKey))
      << "a seed is good until the next one";
  EXPECT_EQ(t.ask(Bytes{0x27, 0x02} + t.key_for(second)),
            refusal(0x27, Nrc::kRequestSequenceError))
      << "and for one try";
  EXPECT_FALSE(t.server.unlocked());
  t.unlock();
  EXPECT_TRUE(t.server.unlocked());
  EXPECT_EQ(t.seed(), Bytes(16)) << "zeros: already unlocked";
  t.now_us += UdsServer::kS3Us;
  t.server.advance(t.now_us);
  EXPECT_FALSE(t.server.unlocked());
  (void)t.ask({0x10, 0x03});
  t.daemon.has_random = false;
  EXPECT_EQ(t.ask({0x27, 0x01}), refusal(0x27, Nrc::kConditionsNotCorrect));
}

TEST(UdsServer, ThreeWrongKeysLockOut) {
  Tester t(writing_settings());
  (void)t.ask({0x10, 0x03});
  const auto wrong = [&] {
    Bytes key = t.key_for(t.seed());
    key[15] ^= 1;
    return t.ask(Bytes{0x27, 0x02} + key);
  };
  EXPECT_EQ(wrong(), refusal(0x27, Nrc::kInvalidKey));
  (void)t.ask({0x10, 0x03});
  EXPECT_EQ(wrong(), refusal(0x27, Nrc::kInvalidKey));
  EXPECT_EQ(wrong(), refusal(0x27, Nrc::kExceededAttempts));
  for (const std::int64_t wait : {0, 4'000'000, 3'000'000, 2'999'999}) {
    t.now_us += wait;
    (void)t.ask({0x10, 0x03});
    EXPECT_EQ(t.ask({0x27, 0x01}), refusal(0x27, Nrc::kTimeDelayNotExpired));
  }
  t.now_us += 1;
  t.unlock();
}

TEST(UdsServer, RoutinesThatAnybodyMayStart) {
  Tester t;
  EXPECT_EQ(t.ask({0x31, 0x01, 0xF0, 0x01, 1}), (Bytes{0x71, 0x01, 0xF0, 0x01}));
  EXPECT_EQ(t.ask({0x31, 0x01, 0xF0, 0x01}), (Bytes{0x71, 0x01, 0xF0, 0x01}));
  EXPECT_EQ(t.daemon.evaluations, (std::vector<int>{1, 0}));
  EXPECT_TRUE(t.ask({0x31, 0x81, 0xF0, 0x01, 31}).empty());
  EXPECT_EQ(t.ask({0x31, 0x03, 0xF0, 0x01, 1}), (Bytes{0x71, 0x03, 0xF0, 0x01, 4, 0}));
  EXPECT_EQ(t.ask({0x31, 0x01, 0xF0, 0x01, 0}), refusal(0x31, Nrc::kRequestOutOfRange));
  EXPECT_EQ(t.ask({0x31, 0x01, 0xF0, 0x01, 2}), refusal(0x31, Nrc::kRequestOutOfRange));
  EXPECT_EQ(t.ask({0x31, 0x01, 0xF0, 0x03}), refusal(0x31, Nrc::kRequestOutOfRange));
  EXPECT_EQ(t.ask({0x31, 0x01, 0xEF, 0xFF}), refusal(0x31, Nrc::kRequestOutOfRange));
  EXPECT_EQ(t.ask({0x31, 0x01, 0xF0, 0x01, 1, 1}), refusal(0x31, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x31, 0x03, 0xF0, 0x01}), refusal(0x31, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x31, 0x03, 0xF0, 0x01, 0}), refusal(0x31, Nrc::kRequestOutOfRange));
  EXPECT_EQ(t.ask({0x31, 0x01, 0xF0}), refusal(0x31, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x31}), refusal(0x31, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x31, 0x04, 0xF0, 0x01}),
            refusal(0x31, Nrc::kSubFunctionNotSupported));
  EXPECT_EQ(t.ask({0x31, 0x02, 0xF0, 0x01}),
            refusal(0x31, Nrc::kSubFunctionNotSupported));
  t.daemon.willing = false;
  EXPECT_EQ(t.ask({0x31, 0x01, 0xF0, 0x01}), refusal(0x31, Nrc::kConditionsNotCorrect));
}

TEST(UdsServer, RoutinesThatNeedTheKey) {
  Tester t(writing_settings());
  for (const Bytes& request :
       {Bytes{0x31, 0x01, 0xF0, 0x00, 1}, Bytes{0x31, 0x01, 0xF0, 0x02, 31, 4},
        Bytes{0x31, 0x02, 0xF0, 0x02}}) {
    t.server.advance(t.now_us += UdsServer::kS3Us);
    EXPECT_EQ(t.ask(request), refusal(0x31, Nrc::kSubFunctionNotInSession));
    (void)t.ask({0x10, 0x03});
    EXPECT_EQ(t.ask(request), refusal(0x31, Nrc::kSecurityAccessDenied));
    t.unlock();
    EXPECT_EQ(t.ask(request), (Bytes{0x71, request[1], 0xF0, request[3]}));
  }
  EXPECT_EQ(t.daemon.resets, (std::vector<int>{1}));
}

TEST(UdsServer, SimulationShowsCheckFunctionUntilTheSessionEnds) {
  Tester t(writing_settings());
  t.unlock();
  EXPECT_EQ(t.ask({0x31, 0x01, 0xF0, 0x02, 31}), refusal(0x31, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x31, 0x01, 0xF0, 0x02, 31, 6}),
            refusal(0x31, Nrc::kRequestOutOfRange));
  EXPECT_EQ(t.ask({0x31, 0x01, 0xF0, 0x02, 30, 4}),
            refusal(0x31, Nrc::kRequestOutOfRange));
  EXPECT_EQ(t.ask({0x31, 0x01, 0xF0, 0x02, 31, 4}), (Bytes{0x71, 0x01, 0xF0, 0x02}));
  const Bytes state = t.ask({0x22, 0xFE, 0xF0});
  EXPECT_EQ(state[3], 4);
  EXPECT_EQ(state[4], static_cast<int>(Ne107::kCheckFunction));
  EXPECT_EQ(t.ask({0x31, 0x03, 0xF0, 0x02, 31}), (Bytes{0x71, 0x03, 0xF0, 0x02, 4, 1}));
  EXPECT_EQ(t.ask({0x31, 0x02, 0xF0, 0x02, 31}), (Bytes{0x71, 0x02, 0xF0, 0x02}));
  EXPECT_FALSE(t.daemon.status(31).simulated);
  EXPECT_EQ(t.ask({0x31, 0x01, 0xF0, 0x02, 0, 5}),
            refusal(0x31, Nrc::kRequestOutOfRange));
  for (const std::uint8_t loop : Bytes{1, 31}) {
    EXPECT_EQ(t.ask({0x31, 0x01, 0xF0, 0x02, loop, 5}), (Bytes{0x71, 0x01, 0xF0, 0x02}));
    EXPECT_TRUE(t.daemon.status(loop).simulated);
  }
  t.server.advance(t.now_us += UdsServer::kS3Us);
  EXPECT_FALSE(t.daemon.status(1).simulated);
  EXPECT_FALSE(t.daemon.status(31).simulated);
}

TEST(UdsServer, FunctionalRequestsAreSilentOnFiveRefusals) {
  Tester t(writing_settings());
  EXPECT_EQ(t.ask_all({0x3E, 0x00}), (Bytes{0x7E, 0x00}));
  EXPECT_TRUE(t.ask_all({0x85, 0x01}).empty());              // 11
  EXPECT_TRUE(t.ask_all({0x3E, 0x01}).empty());              // 12
  EXPECT_TRUE(t.ask_all({0x22, 0x12, 0x34}).empty());        // 31
  EXPECT_TRUE(t.ask_all({0x31, 0x01, 0xF0, 0x00}).empty());  // 7E
  EXPECT_TRUE(t.ask_all({0x27, 0x01}).empty());              // 7F
  EXPECT_EQ(t.ask_all({0x3E}), refusal(0x3E, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask_all({0x37}), refusal(0x37, Nrc::kRequestSequenceError));
}

TEST(UdsServer, CountsAndListsDtcs) {
  Tester t;
  const int confirmed = kDtcConfirmed;
  EXPECT_EQ(t.ask({0x19, 0x01, 0x08}), (Bytes{0x59, 0x01, 0x7D, 0x01, 0, 1}));
  EXPECT_EQ(t.ask({0x19, 0x02, 0x08}), (Bytes{0x59, 0x02, 0x7D, 0x51, 0x01, 0x71, 0x2D}));
  for (const std::uint8_t bit : Bytes{0x01, 0x04, 0x20}) {
    EXPECT_EQ(t.ask({0x19, 0x02, bit}),
              (Bytes{0x59, 0x02, 0x7D, 0x51, 0x01, 0x71, 0x2D}));
  }
  EXPECT_EQ(t.ask({0x19, 0x02, 0x82}), (Bytes{0x59, 0x02, 0x7D}))
      << "bits 1 and 7 do not exist";
  EXPECT_EQ(t.ask({0x19, 0x01, 0x00}), (Bytes{0x59, 0x01, 0x7D, 0x01, 0, 0}));
  const Bytes all = t.ask({0x19, 0x0A});
  ASSERT_EQ(all.size(), 3 + 4 * 16U);
  EXPECT_EQ(all[2], 0x7D);
  EXPECT_EQ(all[6] & confirmed, 0);
  EXPECT_EQ(t.ask({0x19, 0x03}), refusal(0x19, Nrc::kSubFunctionNotSupported));
  EXPECT_EQ(t.ask({0x19, 0x02}), refusal(0x19, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x19, 0x0A, 0x00}), refusal(0x19, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x19}), refusal(0x19, Nrc::kIncorrectLength));
}

TEST(UdsServer, SnapshotAndExtendedData) {
  Tester t;
  const Bytes state = t.ask({0x22, 0xFD, 0x10});
  const Bytes window = t.ask({0x22, 0xFD, 0x13});
  const Bytes expected = Bytes{0x59, 0x04, 0x51, 0x01, 0x71, 0x2D, 0x01, 0x02} +
                         Bytes(state.begin() + 1, state.end()) +
                         Bytes(window.begin() + 1, window.end());
  EXPECT_EQ(t.ask({0x19, 0x04, 0x51, 0x01, 0x71, 0x01}), expected);
  EXPECT_EQ(t.ask({0x19, 0x04, 0x51, 0x01, 0x71, 0xFF}), expected);
  EXPECT_EQ(t.ask({0x19, 0x04, 0x51, 0x1F, 0x71, 0xFF}),
            (Bytes{0x59, 0x04, 0x51, 0x1F, 0x71, 0x50}))
      << "never confirmed";
  EXPECT_EQ(t.ask({0x19, 0x06, 0x51, 0x01, 0x71, 0x01}),
            (Bytes{0x59, 0x06, 0x51, 0x01, 0x71, 0x2D, 0x01, 0, 1}));
  for (const std::uint8_t report : Bytes{0x04, 0x06}) {
    EXPECT_EQ(t.ask({0x19, report, 0x51, 0x02, 0x71, 0x01}),
              refusal(0x19, Nrc::kRequestOutOfRange));
    EXPECT_EQ(t.ask({0x19, report, 0x00, 0x00, 0x00, 0x01}),
              refusal(0x19, Nrc::kRequestOutOfRange));
    EXPECT_EQ(t.ask({0x19, report, 0x51, 0x01, 0x71, 0x02}),
              refusal(0x19, Nrc::kRequestOutOfRange));
    EXPECT_EQ(t.ask({0x19, report, 0x51, 0x01, 0x71}),
              refusal(0x19, Nrc::kIncorrectLength));
  }
}

TEST(UdsServer, ClearsDtcsAsItWrites) {
  Tester t(writing_settings());
  EXPECT_EQ(t.ask({0x14, 0xFF, 0xFF}), refusal(0x14, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x14, 0xFF, 0xFF, 0xFF}), refusal(0x14, Nrc::kServiceNotInSession));
  EXPECT_TRUE(t.ask_all({0x14, 0xFF, 0xFF, 0xFF}).empty());
  (void)t.ask({0x10, 0x03});
  EXPECT_EQ(t.ask({0x14, 0xFF, 0xFF, 0xFF}), refusal(0x14, Nrc::kSecurityAccessDenied));
  EXPECT_EQ(t.ask({0x14, 0x51, 0x01, 0x71}), refusal(0x14, Nrc::kSecurityAccessDenied));
  EXPECT_EQ(t.ask({0x19, 0x01, 0x08}), (Bytes{0x59, 0x01, 0x7D, 0x01, 0, 1}));
  t.unlock();
  EXPECT_EQ(t.ask({0x14, 0x51, 0x02, 0x71}), refusal(0x14, Nrc::kRequestOutOfRange));
  EXPECT_EQ(t.ask({0x14, 0x00, 0x00, 0x00}), refusal(0x14, Nrc::kRequestOutOfRange));
  EXPECT_EQ(t.ask({0x14, 0x51, 0x01, 0x71}), Bytes{0x54});
  EXPECT_EQ(t.ask({0x19, 0x01, 0x08}), (Bytes{0x59, 0x01, 0x7D, 0x01, 0, 0}));
  t.daemon.dtcs->update(t.daemon.loops[0]);
  EXPECT_EQ(t.ask({0x19, 0x01, 0x08}), (Bytes{0x59, 0x01, 0x7D, 0x01, 0, 1}));
  EXPECT_EQ(t.ask({0x14, 0xFF, 0xFF, 0xFF}), Bytes{0x54});
  EXPECT_EQ(t.ask({0x19, 0x01, 0x2D}), (Bytes{0x59, 0x01, 0x7D, 0x01, 0, 0}));
}

TEST(UdsServer, ClearsNothingUnlessConfigured) {
  UdsSettings settings = writing_settings();
  settings.writes = false;
  Tester t(settings);
  t.unlock();
  EXPECT_EQ(t.ask({0x14, 0xFF, 0xFF, 0xFF}), refusal(0x14, Nrc::kConditionsNotCorrect));
  EXPECT_EQ(t.ask({0x19, 0x01, 0x08}), (Bytes{0x59, 0x01, 0x7D, 0x01, 0, 1}));
}

TEST(UdsServer, TellsOfEveryUnlockRefusedKeyWriteAndClear) {
  using enum UdsAct;
  Tester t(writing_settings());
  (void)t.ask({0x10, 0x03});
  (void)t.ask(Bytes{0x27, 0x02} + Bytes(16));
  EXPECT_TRUE(t.daemon.told.empty()) << "no seed, no key";
  (void)t.seed();
  (void)t.ask(Bytes{0x27, 0x02} + Bytes(16));
  t.unlock();
  (void)t.ask(Bytes{0x2E, 0xFD, 0x15} + kParameters);
  (void)t.ask({0x14, 0x51, 0x01, 0x71});
  (void)t.ask({0x31, 0x01, 0xF0, 0x00, 31});
  (void)t.ask({0x31, 0x01, 0xF0, 0x02, 1, 4});
  (void)t.ask({0x14, 0x51, 0x02, 0x71});
  (void)t.ask({0x22, 0xFD, 0x10});
  EXPECT_EQ(t.daemon.told, (std::vector<std::pair<UdsAct, int>>{{kRefusedKey, 0},
                                                                {kUnlocked, 0},
                                                                {kWritten, 1},
                                                                {kCleared, 1},
                                                                {kReset, 31},
                                                                {kSimulated, 1}}));
}

TEST(UdsServer, AnAnswerLongerThanTheRoomIsRefused) {
  Tester t;
  std::array<std::uint8_t, 3 + kStateBytes> room{};
  const Bytes ask = {0x22, 0xFD, 0x10};
  EXPECT_EQ(t.server.handle(ask, false, t.now_us, room, 0).size(), room.size());
  const auto less = std::span(room).first(room.size() - 1);
  const auto answer = t.server.handle(ask, false, t.now_us, less, 0);
  EXPECT_EQ(Bytes(answer.begin(), answer.end()), refusal(0x22, Nrc::kResponseTooLong));
  EXPECT_TRUE(t.server.handle(ask, false, t.now_us, less.first(2), 0).empty())
      << "no room for a refusal";
}

}  // namespace
}  // namespace wire
