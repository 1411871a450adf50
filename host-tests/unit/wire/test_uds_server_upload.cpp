#include <gtest/gtest.h>

#include "support/uds/tester.hpp"
#include "wire/big_endian.hpp"
#include "wire/crc32.hpp"
#include "wire/uds_server.hpp"

namespace wire {
namespace {

using support::Bytes;
using support::refusal;
using support::writing_settings;
using support::operator+;
using Tester = support::UdsTester;

const Bytes kUpload = {0x35, 0x00, 0x44, 0, 0, 0, 1, 0xFF, 0xFF, 0xFF, 0xFF};

TEST(UdsServer, UploadsTheRecording) {
  UdsSettings settings;
  settings.block_bytes = 100;
  Tester t(settings);
  EXPECT_EQ(t.ask(kUpload), (Bytes{0x75, 0x20, 0, 102}));
  const Bytes expected = support::UdsDaemon::image_of(1);
  Bytes image;
  for (std::uint8_t counter = 1; image.size() < expected.size(); ++counter) {
    Bytes block = t.ask({0x36, counter});
    ASSERT_GE(block.size(), 3U);
    ASSERT_LE(block.size(), 102U);
    EXPECT_EQ(block[0], 0x76);
    EXPECT_EQ(block[1], counter);
    EXPECT_EQ(t.ask({0x36, counter}), block) << "repeated for a tester that lost it";
    image.insert(image.end(), block.begin() + 2, block.end());
  }
  EXPECT_EQ(image, expected);
  const std::uint8_t next = static_cast<std::uint8_t>((image.size() + 99) / 100 + 1);
  EXPECT_EQ(t.ask({0x36, next}), refusal(0x36, Nrc::kRequestSequenceError));
  const Bytes end = t.ask({0x37});
  ASSERT_EQ(end.size(), 5U);
  EXPECT_EQ(get_big_endian(std::span(end).subspan(1)), crc32(expected));
  EXPECT_FALSE(t.daemon.recording_open);
}

TEST(UdsServer, UploadOfAHistory) {
  Tester t;
  const Bytes start = {0x35, 0, 0x44, 0, 0, 0x01, 0x01, 0xFF, 0xFF, 0xFF, 0xFF};
  EXPECT_EQ(t.ask(start), refusal(0x35, Nrc::kConditionsNotCorrect)) << "there is none";
  t.daemon.history = {1, 2, 3, 4, 5};
  EXPECT_EQ(t.ask(start)[0], 0x75);
  EXPECT_EQ(t.daemon.history_loop, 1);
  EXPECT_EQ(t.ask({0x36, 1}), (Bytes{0x76, 1, 1, 2, 3, 4, 5}));
  EXPECT_EQ(t.ask({0x37})[0], 0x77);
  for (const std::uint8_t loop : {std::uint8_t{0}, std::uint8_t{2}, std::uint8_t{32}}) {
    EXPECT_EQ(t.ask({0x35, 0, 0x44, 0, 0, 0x01, loop, 0, 0, 0, 9}),
              refusal(0x35, Nrc::kRequestOutOfRange))
        << int{loop};
  }
}

TEST(UdsServer, BlockCounterWraps) {
  UdsSettings settings;
  settings.block_bytes = 5;
  Tester t(settings);
  EXPECT_EQ(t.ask(kUpload), (Bytes{0x75, 0x20, 0, 7}));
  const Bytes expected = support::UdsDaemon::image_of(1);
  ASSERT_GT(expected.size(), 5 * 256U);
  Bytes image;
  for (std::uint8_t counter = 1; image.size() < expected.size(); ++counter) {
    const Bytes block = t.ask({0x36, counter});
    ASSERT_EQ(block[0], 0x76);
    image.insert(image.end(), block.begin() + 2, block.end());
  }
  EXPECT_EQ(image, expected);
}

TEST(UdsServer, UploadOfAPart) {
  Tester t;
  EXPECT_EQ(t.ask({0x35, 0x00, 0x11, 31, 24}), (Bytes{0x75, 0x20, 0x04, 0x02}));
  EXPECT_EQ(t.ask({0x36, 1}).size(), 2 + 24U);
  EXPECT_EQ(t.ask({0x36, 2}), refusal(0x36, Nrc::kRequestSequenceError));
}

TEST(UdsServer, UploadRefusals) {
  Tester t;
  const auto with = [](std::size_t at, std::uint8_t value) {
    Bytes request = kUpload;
    request[at] = value;
    return request;
  };
  EXPECT_EQ(t.ask({0x36, 1}), refusal(0x36, Nrc::kRequestSequenceError));
  EXPECT_EQ(t.ask({0x37}), refusal(0x37, Nrc::kRequestSequenceError));
  EXPECT_EQ(t.ask({0x35, 0x00}), refusal(0x35, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x35, 0x00, 0x44, 0}), refusal(0x35, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x36}), refusal(0x36, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x36, 1, 0}), refusal(0x36, Nrc::kIncorrectLength));
  EXPECT_EQ(t.ask({0x37, 0}), refusal(0x37, Nrc::kIncorrectLength));
  const Nrc range = Nrc::kRequestOutOfRange;
  EXPECT_EQ(t.ask(with(1, 0x10)), refusal(0x35, range)) << "compressed";
  EXPECT_EQ(t.ask(with(2, 0x04)), refusal(0x35, range));
  EXPECT_EQ(t.ask(with(2, 0x54)), refusal(0x35, range));
  EXPECT_EQ(t.ask(with(6, 2)), refusal(0x35, range)) << "no such loop";
  EXPECT_EQ(t.ask(with(6, 0)), refusal(0x35, range));
  EXPECT_EQ(t.ask(with(3, 1)), refusal(0x35, range)) << "far beyond";
  EXPECT_EQ(t.ask({0x35, 0x00, 0x11, 1, 0}), refusal(0x35, range)) << "nothing wanted";
  t.daemon.willing = false;
  EXPECT_EQ(t.ask(kUpload), refusal(0x35, Nrc::kConditionsNotCorrect));
  t.daemon.willing = true;
  EXPECT_EQ(t.ask(kUpload)[0], 0x75);
  EXPECT_EQ(t.ask(kUpload), refusal(0x35, Nrc::kConditionsNotCorrect)) << "one at a time";
  EXPECT_EQ(t.ask({0x36, 2}), refusal(0x36, Nrc::kWrongBlockSequence));
  EXPECT_EQ(t.ask({0x36, 0}), refusal(0x36, Nrc::kWrongBlockSequence));
  EXPECT_EQ(t.ask({0x37}), (Bytes{0x77, 0, 0, 0, 0})) << "given up";
}

TEST(UdsServer, UploadEndsWithSilenceOrANewSession) {
  Tester t;
  EXPECT_EQ(t.ask(kUpload)[0], 0x75);
  t.server.advance(t.now_us += UdsServer::kS3Us);
  EXPECT_FALSE(t.daemon.recording_open);
  EXPECT_EQ(t.ask(kUpload)[0], 0x75);
  EXPECT_EQ(t.ask({0x10, 0x01})[0], 0x50);
  EXPECT_FALSE(t.daemon.recording_open);
}

TEST(UdsServer, AnAbandonedUploadEndsWhateverOthersDo) {
  Tester t;
  EXPECT_EQ(t.ask(kUpload)[0], 0x75);
  EXPECT_EQ(t.ask({0x36, 1})[0], 0x76);
  for (int k = 0; k < 50; ++k) {
    EXPECT_TRUE(t.daemon.recording_open) << k;
    t.now_us += UdsServer::kTransferUs / 50;
    t.server.advance(t.now_us);
    (void)t.ask({0x3E, 0x00});
    (void)t.ask_all({0x22, 0xF1, 0x86});
  }
  EXPECT_FALSE(t.daemon.recording_open);
  EXPECT_EQ(t.ask({0x36, 2}), refusal(0x36, Nrc::kRequestSequenceError));
  EXPECT_EQ(t.ask(kUpload)[0], 0x75);
}

TEST(UdsServer, AnUploadThatGoesOnDoesNotEnd) {
  UdsSettings settings;
  settings.block_bytes = 50;
  Tester t(settings);
  EXPECT_EQ(t.ask(kUpload)[0], 0x75);
  for (std::uint8_t counter = 1; counter < 20; ++counter) {
    t.server.advance(t.now_us += UdsServer::kTransferUs - 1);
    EXPECT_EQ(t.ask({0x36, counter})[0], 0x76);
  }
}

TEST(UdsServer, AnUploadIsOfTheTesterWhoBeganIt) {
  Tester t;
  EXPECT_EQ(t.ask_as(0xF1, kUpload)[0], 0x75);
  EXPECT_EQ(t.ask_as(0xF9, {0x36, 1}), refusal(0x36, Nrc::kRequestSequenceError));
  EXPECT_EQ(t.ask_as(0xF9, {0x37}), refusal(0x37, Nrc::kRequestSequenceError));
  EXPECT_EQ(t.ask_as(0xF9, kUpload), refusal(0x35, Nrc::kConditionsNotCorrect));
  EXPECT_EQ(t.ask_as(0xF9, {0x10, 0x01})[0], 0x50);
  EXPECT_EQ(t.ask_as(0xF1, {0x36, 1})[0], 0x76);
}

TEST(UdsServer, BlocksFitTheStorage) {
  Tester t;
  std::array<std::uint8_t, 64> small{};
  const auto first = t.server.handle(kUpload, false, t.now_us, small);
  ASSERT_EQ(first.size(), 4U);
  const std::uint64_t longest = get_big_endian(first.subspan(2, 2));
  EXPECT_LE(longest, small.size());
  const Bytes next = {0x36, 1};
  EXPECT_EQ(t.server.handle(next, false, t.now_us, small).size(), longest);
}

TEST(UdsServer, EachUploadHasAChecksumOfItsOwn) {
  Tester t;
  for (const Bytes& content : {Bytes{1, 2, 3}, Bytes{4, 5}}) {
    t.daemon.history = content;
    ASSERT_EQ(t.ask({0x35, 0, 0x44, 0, 0, 0x01, 0x01, 0xFF, 0xFF, 0xFF, 0xFF})[0], 0x75);
    ASSERT_EQ(t.ask({0x36, 1}), (Bytes{0x76, 1} + content));
    const Bytes end = t.ask({0x37});
    ASSERT_EQ(end.size(), 5U);
    EXPECT_EQ(get_big_endian(std::span(end).subspan(1)), crc32(content));
  }
}

TEST(UdsServer, ATesterThatIsPresentKeepsItsUpload) {
  UdsSettings settings;
  settings.block_bytes = 100;
  Tester t(settings);
  ASSERT_EQ(t.ask(kUpload)[0], 0x75);
  for (int times = 0; times < 10; ++times) {
    t.now_us += UdsServer::kS3Us - 1;
    t.server.keep_alive(t.now_us, 0);
    t.server.advance(t.now_us);
  }
  EXPECT_EQ(t.ask({0x36, 1})[0], 0x76) << "the upload goes on";
  t.server.keep_alive(t.now_us, 7);
  t.now_us += 3600'000'000LL;
  t.server.advance(t.now_us);
  EXPECT_EQ(t.ask({0x36, 2}), refusal(0x36, Nrc::kRequestSequenceError));
  EXPECT_FALSE(t.daemon.recording_open);
}

}  // namespace
}  // namespace wire
