// One request at a time: who else asks meanwhile is told so.
#include <gtest/gtest.h>

#include "support/isotp_server.hpp"
#include "wire/isotp.hpp"

namespace wire {
namespace {

using support::Bytes;
using support::counting;
using support::frame_of;
using support::padded;
using Server = support::IsoTpServer;

TEST(IsoTp, SecondRequestWhileOneIsReceivedIsBusyAtOnce) {
  Server s;
  s.take({0x10, 13, 1, 2, 3, 4, 5, 6});
  (void)s.next();
  s.take({0x03, 0x22, 0xF1, 0x86});
  EXPECT_EQ(s.next(), padded({0x03, 0x7F, 0x22, 0x21}));
  s.take({0x10, 9, 0x2E, 0xFD, 0x15, 0, 0, 0});
  EXPECT_EQ(s.next(), padded({0x03, 0x7F, 0x2E, 0x21}));
  s.take({0x21, 7, 8, 9, 10, 11, 12, 13});
  EXPECT_EQ(s.request(), counting(13)) << "the first tester's message is untouched";
  EXPECT_EQ(s.counters().busy, 2U);
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
