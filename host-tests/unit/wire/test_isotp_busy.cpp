// One request at a time: who else asks meanwhile is told so.
#include <gtest/gtest.h>

#include "support/uds/isotp_server.hpp"
#include "wire/isotp.hpp"

namespace wire {
namespace {

using support::Bytes;
using support::counting;
using support::frame_of;
using support::padded;
using Server = support::IsoTpServer;

TEST(IsoTp, ASingleFrameIsServedWhileAnotherRequestIsReceived) {
  Server s;
  s.take({0x10, 13, 1, 2, 3, 4, 5, 6});
  (void)s.next();
  s.take({0x03, 0x22, 0xF1, 0x86});
  EXPECT_EQ(s.request(), (Bytes{0x22, 0xF1, 0x86}));
  EXPECT_FALSE(s.link.request()->functional);
  ASSERT_TRUE(s.link.send(Bytes{0x62, 0xF1, 0x86, 1}));
  EXPECT_EQ(s.next(), padded({0x04, 0x62, 0xF1, 0x86, 1}));
  s.take({0x10, 9, 0x2E, 0xFD, 0x15, 0, 0, 0});
  EXPECT_EQ(s.next(), padded({0x03, 0x7F, 0x2E, 0x21})) << "one buffer, one long request";
  s.take({0x21, 7, 8, 9, 10, 11, 12, 13});
  EXPECT_EQ(s.request(), counting(13)) << "the first tester's message is untouched";
  EXPECT_EQ(s.counters().busy, 1U);
}

TEST(IsoTp, AMessageThatIsCompleteWaitsForTheResponseToAnother) {
  Server s(normal_fixed_settings());
  s.take_from(0x18DA10F2, {0x10, 13, 1, 2, 3, 4, 5, 6});
  (void)s.next();
  s.take_from(0x18DA10F1, {0x03, 0x22, 0xFD, 0x01});
  ASSERT_TRUE(s.link.send(counting(20)));
  EXPECT_EQ(s.next()[0], 0x10);
  s.take_from(0x18DA10F2, {0x21, 7, 8, 9, 10, 11, 12, 13});
  EXPECT_TRUE(s.request().empty());
  s.take_from(0x18DA10F1, {0x30, 0, 0});
  EXPECT_EQ(s.next()[0], 0x21);
  EXPECT_EQ(s.next()[0], 0x22);
  EXPECT_EQ(s.request(), counting(13));
  EXPECT_EQ(s.link.request()->tester, 0xF2);
}

// Answers that a tester gets of 100 requests while a stranger floods with first frames
// that nothing follows.
int answered_of_100(std::uint32_t tester, std::uint32_t stranger) {
  IsoTpSettings settings;
  if (tester > kMaxStandardId) settings = normal_fixed_settings();
  Server s(settings);
  int answered = 0;
  for (int k = 0; k < 100; ++k) {
    const std::int64_t now_us = k * 10'000;
    for (int n = 0; n < 5; ++n) {
      s.take_from(stranger, {0x10, 200, 0x22, 0xF1, 0x86, 0, 0, 0}, now_us);
    }
    s.take_from(tester, {0x03, 0x22, 0xF1, 0x86}, now_us);
    if (s.request() == Bytes{0x22, 0xF1, 0x86}) {
      EXPECT_TRUE(s.link.send(Bytes{0x62, 0xF1, 0x86, 1}));
    }
    for (Bytes data = s.next(now_us); !data.empty(); data = s.next(now_us)) {
      answered += data[1] == 0x62 ? 1 : 0;
    }
  }
  return answered;
}

TEST(IsoTp, FirstFramesOfAStrangerDoNotStarveATester) {
  EXPECT_EQ(answered_of_100(0x18DA10F1, 0x18DA10F9), 100);
  EXPECT_EQ(answered_of_100(0x7E0, 0x7E0), 100);
}

TEST(IsoTp, AReceptionThatStandsStillGivesWayToAnotherTesters) {
  Server s(normal_fixed_settings());
  s.take_from(0x18DA10F9, {0x10, 200, 1, 2, 3, 4, 5, 6}, 0);
  s.take_from(0x18DA10F1, {0x10, 13, 1, 2, 3, 4, 5, 6}, 200'000);
  (void)s.next(200'000);
  EXPECT_EQ(s.next(200'000), padded({0x03, 0x7F, 1, 0x21}));
  s.take_from(0x18DA10F1, {0x10, 13, 1, 2, 3, 4, 5, 6}, 300'000);
  EXPECT_EQ(s.next(300'000)[0], 0x30);
  s.take_from(0x18DA10F1, {0x21, 7, 8, 9, 10, 11, 12, 13}, 300'000);
  EXPECT_EQ(s.request(), counting(13));
}

TEST(IsoTp, SecondRequestOnTheSameIdentifiersIsBusyAfterTheResponse) {
  Server s;
  s.take({0x01, 0x22});
  ASSERT_TRUE(s.link.send(counting(20)));
  (void)s.next();
  s.take({0x03, 0x22, 0xF1, 0x86});
  EXPECT_TRUE(s.next().empty()) << "a frame in between would end the response";
  s.take({0x30, 0, 0});
  EXPECT_EQ(s.next()[0], 0x21);
  EXPECT_EQ(s.next()[0], 0x22);
  EXPECT_EQ(s.next(), padded({0x03, 0x7F, 0x22, 0x21}));
  EXPECT_TRUE(s.next().empty());
}

TEST(IsoTp, SecondTesterWithItsOwnAddressIsBusyAtOnce) {
  Server s(normal_fixed_settings());
  s.take_from(0x18DA10F1, {0x01, 0x22});
  ASSERT_TRUE(s.link.send(counting(20)));
  EXPECT_EQ(s.next()[0], 0x10);
  EXPECT_EQ(s.id, 0x18DAF110U);
  s.take_from(0x18DA10F2, {0x03, 0x22, 0xF1, 0x86});
  EXPECT_EQ(s.next(), padded({0x03, 0x7F, 0x22, 0x21}));
  EXPECT_EQ(s.id, 0x18DAF210U);
  s.take_from(0x18DA10F2, {0x30, 0, 0});
  EXPECT_TRUE(s.next().empty()) << "not its response";
  s.take_from(0x18DA10F1, {0x30, 0, 0});
  EXPECT_EQ(s.next()[0], 0x21);
  EXPECT_EQ(s.id, 0x18DAF110U);
  EXPECT_EQ(s.next()[0], 0x22);
  s.take_from(0x18DA10F2, {0x02, 0x3E, 0x00});
  ASSERT_TRUE(s.link.send(Bytes{0x7E, 0x00}));
  (void)s.next();
  EXPECT_EQ(s.id, 0x18DAF210U) << "served when its turn has come";
}

TEST(IsoTp, ForeignConsecutiveFramesDoNotMix) {
  Server s(normal_fixed_settings());
  s.take_from(0x18DA10F1, {0x10, 13, 1, 2, 3, 4, 5, 6});
  s.take_from(0x18DA10F2, {0x21, 99, 99, 99, 99, 99, 99, 99});
  s.take_from(0x18DA10F1, {0x21, 7, 8, 9, 10, 11, 12, 13});
  EXPECT_EQ(s.request(), counting(13));
}

TEST(IsoTp, FunctionalTesterPresentPassesAtAnyTime) {
  Server s;
  s.take({0x10, 13, 1, 2, 3, 4, 5, 6});
  (void)s.next();
  s.take_from(0x7DF, {0x02, 0x3E, 0x80});
  EXPECT_EQ(s.request(), (Bytes{0x3E, 0x80}));
  EXPECT_TRUE(s.link.request()->functional);
  s.link.release();
  s.take({0x21, 7, 8, 9, 10, 11, 12, 13});
  EXPECT_EQ(s.request(), counting(13));
  EXPECT_EQ(s.counters().busy, 0U);
  s.take_from(0x7DF, {0x02, 0x3E, 0x00});
  EXPECT_EQ(s.counters().busy, 1U) << "that one wants an answer";
}

}  // namespace
}  // namespace wire
