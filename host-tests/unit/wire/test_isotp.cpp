#include <gtest/gtest.h>

#include <vector>

#include "support/uds/isotp_server.hpp"
#include "wire/isotp.hpp"

namespace wire {
namespace {

using support::Bytes;
using support::counting;
using support::frame_of;
using support::padded;
using Server = support::IsoTpServer;

TEST(IsoTp, SingleFrameInAndOut) {
  Server s;
  EXPECT_FALSE(s.link.busy());
  s.take({0x02, 0x3E, 0x00});
  EXPECT_EQ(s.request(), (Bytes{0x3E, 0x00}));
  EXPECT_FALSE(s.link.request()->functional);
  EXPECT_TRUE(s.link.busy());
  ASSERT_TRUE(s.link.send(Bytes{0x7E, 0x00}));
  EXPECT_EQ(s.next(), padded({0x02, 0x7E, 0x00}));
  EXPECT_EQ(s.id, 0x7E8U);
  EXPECT_TRUE(s.next().empty());
  EXPECT_FALSE(s.link.busy());
  EXPECT_EQ(s.counters().requests, 1U);
  EXPECT_EQ(s.counters().responses, 1U);
}

TEST(IsoTp, PaddedAndUnpaddedFramesAreTheSame) {
  for (const std::size_t size : {5U, 6U, 8U}) {
    Server s;
    Bytes data = {0x04, 1, 2, 3, 4};
    data.resize(size, 0x55);
    s.take(data);
    EXPECT_EQ(s.request(), (Bytes{1, 2, 3, 4}));
  }
}

TEST(IsoTp, SegmentedRequest) {
  Server s;
  s.take({0x10, 20, 1, 2, 3, 4, 5, 6});
  EXPECT_EQ(s.next(), padded({0x30, 0, 0}));
  EXPECT_TRUE(s.next().empty());
  s.take({0x21, 7, 8, 9, 10, 11, 12, 13});
  EXPECT_TRUE(s.request().empty());
  s.take({0x22, 14, 15, 16, 17, 18, 19, 20});
  EXPECT_EQ(s.request(), counting(20));
  EXPECT_EQ(s.counters().requests, 1U);
}

TEST(IsoTp, LastConsecutiveFrameMayBeShortOrPadded) {
  for (const std::size_t size : {3U, 8U}) {
    Server s;
    s.take({0x10, 8, 1, 2, 3, 4, 5, 6});
    Bytes last = {0x21, 7, 8};
    last.resize(size, 0xAA);
    s.take(last);
    EXPECT_EQ(s.request(), counting(8));
  }
}

TEST(IsoTp, AsksForBlocksAndSeparation) {
  IsoTpSettings settings;
  settings.block_size = 2;
  settings.st_min = 5;
  Server s(settings);
  s.take({0x10, 34, 1, 2, 3, 4, 5, 6});
  EXPECT_EQ(s.next(), padded({0x30, 2, 5}));
  s.take({0x21, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_TRUE(s.next().empty());
  s.take({0x22, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(s.next(), padded({0x30, 2, 5}));
  s.take({0x23, 0, 0, 0, 0, 0, 0, 0});
  s.take({0x24, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(s.request().size(), 34U);
  EXPECT_TRUE(s.next().empty()) << "no flow control after the last frame";
}

TEST(IsoTp, SequenceNumbersWrap) {
  Server s;
  const Bytes message = counting(512);
  s.take({0x12, 0x00, 1, 2, 3, 4, 5, 6});
  std::size_t at = 6;
  for (std::uint8_t sn = 1; at < message.size(); ++sn) {
    Bytes frame = {static_cast<std::uint8_t>(0x20 | (sn & 15))};
    for (int i = 0; i < 7 && at < message.size(); ++i) frame.push_back(message[at++]);
    s.take(frame);
  }
  EXPECT_EQ(s.request(), message);
}

TEST(IsoTp, TooLongIsOverflow) {
  Server s;
  s.take({0x12, 0x01, 1, 2, 3, 4, 5, 6});
  EXPECT_EQ(s.next(), padded({0x32, 0, 0}));
  EXPECT_FALSE(s.link.busy());
  EXPECT_EQ(s.counters().overflows, 1U);
  s.take({0x21, 7, 8, 9, 10, 11, 12, 13});
  EXPECT_EQ(s.counters().rejected_frames, 1U);
}

TEST(IsoTp, WrongSequenceNumberAborts) {
  for (const std::uint8_t sn : Bytes{0x20, 0x22, 0x2F}) {
    Server s;
    s.take({0x10, 20, 1, 2, 3, 4, 5, 6});
    s.take({sn, 7, 8, 9, 10, 11, 12, 13});
    EXPECT_FALSE(s.link.sending());
    EXPECT_EQ(s.counters().sequence_errors, 1U);
    s.take({0x21, 7, 8, 9, 10, 11, 12, 13});
    s.take({0x22, 14, 15, 16, 17, 18, 19, 20});
    EXPECT_TRUE(s.request().empty());
  }
}

TEST(IsoTp, RejectsWhatIsNoClassicFrameOfTheProtocol) {
  const std::vector<Bytes> bad = {
      {},                                 // nothing
      {0x00, 1, 2, 3, 4, 5, 6, 7},        // single frame of length 0: escape of CAN FD
      {0x08, 1, 2, 3, 4, 5, 6, 7},        // more than fits
      {0x03, 1, 2},                       // shorter than it says
      {0x01},                             //
      {0x10, 20, 1, 2, 3, 4, 5},          // first frame that is not full
      {0x10, 7, 1, 2, 3, 4, 5, 6},        // would have fitted a single frame
      {0x10, 0x00, 0, 0, 0x10, 0, 1, 2},  // 32-bit length
      {0x21, 1, 2, 3, 4, 5, 6, 7},        // nothing to continue
      {0x30, 0, 0},                       // nothing to control
      {0x40, 0, 0},                       // no such kind
      {0xF0, 0, 0, 0, 0, 0, 0, 0},
  };
  CanFrame fd = support::frame_of(0x7E0, {0x02, 0x3E, 0x00});
  fd.fd = true;
  Server classic;
  classic.link.on_frame(fd, 0);
  EXPECT_EQ(classic.counters().rejected_frames, 1U) << "a request in a CAN FD frame";
  EXPECT_TRUE(classic.request().empty());
  for (const Bytes& data : bad) {
    Server s;
    s.take(data);
    EXPECT_EQ(s.counters().rejected_frames, 1U) << testing::PrintToString(data);
    EXPECT_FALSE(s.link.busy());
    EXPECT_TRUE(s.next().empty());
  }
  Server s;
  CanFrame remote = frame_of(0x7E0, {0x02, 0x3E, 0x00});
  remote.remote = true;
  s.link.on_frame(remote, 0);
  EXPECT_EQ(s.counters().rejected_frames, 1U);
  CanFrame error = frame_of(0x7E0, {0x02, 0x3E, 0x00});
  error.error = true;
  s.link.on_frame(error, 0);
  EXPECT_FALSE(s.link.busy());
}

TEST(IsoTp, ShortConsecutiveFrameIsRejectedAndTheMessageGoesOn) {
  Server s;
  s.take({0x10, 13, 1, 2, 3, 4, 5, 6});
  s.take({0x21, 7, 8});
  EXPECT_EQ(s.counters().rejected_frames, 1U);
  s.take({0x21, 7, 8, 9, 10, 11, 12, 13});
  EXPECT_EQ(s.request(), counting(13));
}

TEST(IsoTp, OtherIdentifiersAreNotOurs) {
  Server s;
  for (const std::uint32_t id : {0x7E1U, 0x7E8U, 0x18DA10F1U}) {
    s.take_from(id, {0x02, 0x3E, 0x00});
    EXPECT_FALSE(s.link.busy());
  }
  CanFrame extended = frame_of(0x7E0, {0x02, 0x3E, 0x00});
  extended.extended = true;
  s.link.on_frame(extended, 0);
  EXPECT_FALSE(s.link.busy());
  EXPECT_EQ(s.counters().rejected_frames, 0U);
}

TEST(IsoTp, SegmentedResponse) {
  Server s;
  s.take({0x01, 0x22});
  ASSERT_TRUE(s.link.send(counting(20)));
  EXPECT_EQ(s.next(), (Bytes{0x10, 20, 1, 2, 3, 4, 5, 6}));
  EXPECT_TRUE(s.next(1000).empty()) << "waits for flow control";
  s.take({0x30, 0, 0}, 2000);
  EXPECT_EQ(s.next(2000), (Bytes{0x21, 7, 8, 9, 10, 11, 12, 13}));
  EXPECT_EQ(s.next(2000), (Bytes{0x22, 14, 15, 16, 17, 18, 19, 20}));
  EXPECT_TRUE(s.next(2000).empty());
  EXPECT_EQ(s.counters().responses, 1U);
}

TEST(IsoTp, LastFrameOfAResponseIsPadded) {
  Server s;
  ASSERT_TRUE(s.link.send(counting(8)));
  (void)s.next();
  s.take({0x30, 0, 0});
  EXPECT_EQ(s.next(), padded({0x21, 7, 8}));
}

TEST(IsoTp, KeepsSeparationAndBlocksOfTheTester) {
  Server s;
  ASSERT_TRUE(s.link.send(counting(34)));
  (void)s.next();
  s.take({0x30, 2, 10}, 0);
  EXPECT_EQ(s.next(0)[0], 0x21);
  EXPECT_TRUE(s.next(9'999).empty());
  EXPECT_EQ(s.link.next_us(), 10'000);
  EXPECT_EQ(s.next(10'000)[0], 0x22);
  EXPECT_TRUE(s.next(30'000).empty()) << "the block is over";
  s.take({0x30, 0, 0xF3}, 40'000);
  EXPECT_EQ(s.next(40'000)[0], 0x23);
  EXPECT_TRUE(s.next(40'299).empty());
  EXPECT_EQ(s.next(40'300)[0], 0x24);
  EXPECT_EQ(s.counters().responses, 1U);
}

TEST(IsoTp, ReservedSeparationMeansTheLongest) {
  for (const int code : {0x7F, 0x80, 0xF0, 0xFA, 0xFF}) {
    Server s;
    ASSERT_TRUE(s.link.send(counting(20)));
    (void)s.next();
    s.take({0x30, 0, static_cast<std::uint8_t>(code)}, 0);
    (void)s.next(0);
    EXPECT_TRUE(s.next(126'999).empty()) << code;
    EXPECT_FALSE(s.next(127'000).empty()) << code;
  }
}

TEST(IsoTp, TimesOutWithoutFlowControl) {
  Server s;
  ASSERT_TRUE(s.link.send(counting(20)));
  (void)s.next(500);
  EXPECT_EQ(s.link.next_us(), 1'000'500);
  EXPECT_TRUE(s.next(1'000'499).empty());
  EXPECT_TRUE(s.link.busy());
  EXPECT_TRUE(s.next(1'000'500).empty());
  EXPECT_FALSE(s.link.busy());
  EXPECT_EQ(s.counters().timeouts, 1U);
  EXPECT_EQ(s.link.next_us(), std::nullopt);
}

TEST(IsoTp, TimesOutWithoutConsecutiveFrame) {
  Server s;
  s.take({0x10, 20, 1, 2, 3, 4, 5, 6}, 0);
  (void)s.next(0);
  s.take({0x21, 7, 8, 9, 10, 11, 12, 13}, 900'000);
  EXPECT_TRUE(s.next(1'899'999).empty());
  EXPECT_TRUE(s.link.busy());
  (void)s.next(1'900'000);
  EXPECT_FALSE(s.link.busy());
  EXPECT_EQ(s.counters().timeouts, 1U);
}

TEST(IsoTp, LateFrameDoesNotContinueWithoutAPoll) {
  Server s;
  s.take({0x10, 13, 1, 2, 3, 4, 5, 6}, 0);
  s.take({0x21, 7, 8, 9, 10, 11, 12, 13}, 1'000'000);
  EXPECT_TRUE(s.request().empty());
  EXPECT_EQ(s.counters().timeouts, 1U);
}

TEST(IsoTp, TesterMayAskToWaitButNotForEver) {
  Server s;
  std::int64_t now = 0;
  for (const unsigned response : {1U, 2U}) {
    ASSERT_TRUE(s.link.send(counting(20)));
    (void)s.next(now);
    for (int i = 0; i < IsoTpLink::kMostWaits; ++i) {
      s.take({0x31, 0, 0}, now += 900'000);
      EXPECT_TRUE(s.next(now).empty());
      EXPECT_TRUE(s.link.busy());
    }
    s.take({0x31, 0, 0}, now);
    EXPECT_FALSE(s.link.busy());
    EXPECT_EQ(s.counters().aborted_responses, response);
  }
}

TEST(IsoTp, OverflowOrUnknownFlowStateEndsTheResponse) {
  for (const std::uint8_t state : Bytes{0x32, 0x33, 0x3F}) {
    Server s;
    ASSERT_TRUE(s.link.send(counting(20)));
    (void)s.next();
    s.take({state, 0, 0});
    EXPECT_FALSE(s.link.busy());
    EXPECT_TRUE(s.next().empty());
    EXPECT_EQ(s.counters().aborted_responses, 1U);
  }
}

TEST(IsoTp, ShortOrUnexpectedFlowControlChangesNothing) {
  Server s;
  ASSERT_TRUE(s.link.send(counting(34)));
  (void)s.next();
  s.take({0x30, 0});
  EXPECT_TRUE(s.next().empty());
  s.take({0x30, 0, 10}, 0);
  EXPECT_EQ(s.next(0)[0], 0x21);
  s.take({0x30, 0, 0}, 1);
  EXPECT_TRUE(s.next(9'999).empty()) << "the separation asked for first stays";
  EXPECT_EQ(s.counters().rejected_frames, 2U);
}

TEST(IsoTp, FunctionalSingleFramesOnly) {
  Server s;
  s.take_from(0x7DF, {0x02, 0x10, 0x01});
  ASSERT_TRUE(s.link.request());
  EXPECT_TRUE(s.link.request()->functional);
  EXPECT_EQ(s.request(), (Bytes{0x10, 0x01}));
  s.link.release();
  EXPECT_FALSE(s.link.busy());
  s.take_from(0x7DF, {0x10, 20, 1, 2, 3, 4, 5, 6});
  EXPECT_TRUE(s.next().empty());
  EXPECT_EQ(s.counters().rejected_frames, 1U);
}

TEST(IsoTp, SendRefusesWhatItCannotSend) {
  Server s;
  EXPECT_FALSE(s.link.send({}));
  EXPECT_FALSE(s.link.send(Bytes(4096)));
  ASSERT_TRUE(s.link.send(Bytes(4095)));
  EXPECT_EQ(s.next(), (Bytes{0x1F, 0xFF, 0, 0, 0, 0, 0, 0}));
  EXPECT_FALSE(s.link.send(Bytes(1))) << "one at a time";
}

TEST(IsoTp, ResetForgetsEverything) {
  Server s;
  s.take({0x10, 13, 1, 2, 3, 4, 5, 6});
  s.take({0x03, 0x22, 0xF1, 0x86});
  s.link.reset();
  EXPECT_FALSE(s.link.busy());
  EXPECT_TRUE(s.next().empty());
  ASSERT_TRUE(s.link.send(counting(20)));
  s.link.reset();
  EXPECT_TRUE(s.next().empty());
  EXPECT_EQ(s.counters().aborted_responses, 1U);
}

TEST(IsoTp, FiltersLetOwnIdentifiersThrough) {
  const auto lets_through = [](const Server& s, std::uint32_t id) {
    return std::ranges::any_of(s.link.filters(), [id](const IsoTpFilter& f) {
      return (id & f.mask) == (f.id & f.mask);
    });
  };
  const Server standard;
  EXPECT_TRUE(lets_through(standard, 0x7E0));
  EXPECT_TRUE(lets_through(standard, 0x7DF));
  EXPECT_FALSE(lets_through(standard, 0x7E1));
  const Server fixed(normal_fixed_settings());
  EXPECT_TRUE(lets_through(fixed, 0x18DA10F1));
  EXPECT_TRUE(lets_through(fixed, 0x18DA10F2));
  EXPECT_TRUE(lets_through(fixed, 0x18DB33F1));
  EXPECT_FALSE(lets_through(fixed, 0x18DA11F1));
}

// A client is the same class with the identifiers swapped: the two talk to each other.
TEST(IsoTp, ClientAndServerExchangeEveryLength) {
  IsoTpSettings swapped;
  swapped.request_id = swapped.functional_id = 0x7E8;
  swapped.response_id = 0x7E0;
  swapped.answer_busy = false;
  swapped.block_size = 3;
  std::array<std::uint8_t, kLongestIsoTpResponse> receive{};
  std::array<std::uint8_t, kLongestIsoTpResponse> transmit{};
  IsoTpLink client(swapped, receive, transmit);
  Server s;
  for (std::size_t size = 1; size <= 4095; size += size < 600 ? 1 : 97) {
    const Bytes request = counting(std::min<std::size_t>(size, 512));
    const Bytes response = counting(size);
    ASSERT_TRUE(client.send(request));
    for (bool moved = true; moved;) {
      moved = false;
      while (const auto frame = client.poll(0)) {
        s.link.on_frame(*frame, 0);
        moved = true;
      }
      while (const auto frame = s.link.poll(0)) {
        client.on_frame(*frame, 0);
        moved = true;
      }
      if (s.link.request()) {
        ASSERT_EQ(s.request(), request);
        ASSERT_TRUE(s.link.send(response));
        moved = true;
      }
    }
    ASSERT_TRUE(client.request());
    ASSERT_TRUE(std::ranges::equal(client.request()->data, response)) << size;
    client.release();
  }
}

TEST(IsoTp, WakesForWhatComesFirst) {
  Server s;
  s.take({0x10, 20, 1, 2, 3, 4, 5, 6}, 0);
  EXPECT_LT(s.link.next_us().value(), 0) << "the flow control waits to be sent";
  (void)s.next(0);
  EXPECT_EQ(s.link.next_us(), 1'000'000) << "the tester's next frame";
  ASSERT_TRUE(s.link.send(counting(20)));
  EXPECT_LT(s.link.next_us().value(), 0) << "the first frame waits to be sent";
  (void)s.next(300);
  EXPECT_EQ(s.link.next_us(), 1'000'000) << "that of the tester, then its flow control";
  s.take({0x21, 7, 8, 9, 10, 11, 12, 13}, 500);
  EXPECT_EQ(s.link.next_us(), 1'000'300);
}

TEST(IsoTp, AResponseThatStandsStillForASecondEnds) {
  Server s;
  s.take({0x02, 0x3E, 0x00}, 0);
  ASSERT_TRUE(s.link.send(counting(40)));
  (void)s.next(0);
  s.take({0x30, 0, 0}, 1000);
  EXPECT_TRUE(s.link.sending());
  s.link.expire(900'000);
  EXPECT_TRUE(s.link.sending());
  s.link.expire(1'001'000);
  EXPECT_FALSE(s.link.sending());
  EXPECT_EQ(s.link.counters().timeouts, 1U);
  EXPECT_EQ(s.link.next_us(), std::nullopt);
}

}  // namespace
}  // namespace wire
