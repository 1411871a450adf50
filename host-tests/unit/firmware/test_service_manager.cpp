#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdlib>

#include "firmware/service_manager.hpp"
#include "hal/descriptor.hpp"
#include "support/base/temporary_folder.hpp"

namespace firmware {
namespace {

TEST(ServiceManager, DoesNothingWithoutOne) {
  unsetenv("NOTIFY_SOCKET");
  unsetenv("WATCHDOG_USEC");
  const ServiceManager manager;
  manager.tell("READY=1");
  EXPECT_EQ(manager.watchdog_us(), 0);
}

TEST(ServiceManager, SendsToTheNotifySocketAndWatchesThreeTimesAsOften) {
  const TemporaryFolder folder;
  const std::string path = folder.file("notify.sock");
  const hal::Descriptor socket(::socket(AF_UNIX, SOCK_DGRAM, 0));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(bind(socket.get(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  setenv("NOTIFY_SOCKET", path.c_str(), 1);
  setenv("WATCHDOG_USEC", "30000000", 1);
  const ServiceManager manager;
  unsetenv("NOTIFY_SOCKET");
  unsetenv("WATCHDOG_USEC");
  manager.tell("READY=1");
  char text[32] = {};
  EXPECT_EQ(recv(socket.get(), text, sizeof text, MSG_DONTWAIT), 7);
  EXPECT_STREQ(text, "READY=1");
  EXPECT_EQ(manager.watchdog_us(), 10'000'000);
}

}  // namespace
}  // namespace firmware
