#include "firmware/process.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "hal/descriptor.hpp"

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::uint16_t free_port() {
  const hal::Descriptor socket(::socket(AF_INET, SOCK_STREAM, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  (void)bind(socket.get(), reinterpret_cast<sockaddr*>(&address), size);
  (void)getsockname(socket.get(), reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.sin_port);
}

Process::Process(const std::vector<std::string>& arguments) {
  std::vector<char*> words;
  for (const std::string& argument : arguments) {
    words.push_back(const_cast<char*>(argument.c_str()));
  }
  words.push_back(nullptr);
  id_ = fork();
  if (id_ == 0) {
    dup2(open(folder_.file("out").c_str(), O_CREAT | O_WRONLY, 0600), 1);
    dup2(open(folder_.file("err").c_str(), O_CREAT | O_WRONLY, 0600), 2);
    execv(words[0], words.data());
    _exit(127);
  }
}

Process::~Process() {
  if (id_ > 0) {
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
  }
}

void Process::signal(int number) const {
  kill(id_, number);
}

bool Process::says(const std::string& text) const {
  using namespace std::chrono_literals;
  for (int k = 0; k < 200; ++k, std::this_thread::sleep_for(50ms)) {
    if (err().find(text) != std::string::npos) return true;
  }
  return false;
}

Process::Result Process::wait() {
  int status = 0;
  waitpid(id_, &status, 0);
  id_ = -1;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(folder_.file("out")),
          err()};
}

long Process::memory_kib(const std::string& line) const {
  const std::string status = text_of("/proc/" + std::to_string(id_) + "/status");
  const std::size_t at = status.find(line + ':');
  return at == std::string::npos ? -1 : std::stol(status.substr(at + line.size() + 1));
}

double Process::cpu_s() const {
  const std::string stat = text_of("/proc/" + std::to_string(id_) + "/stat");
  std::istringstream fields(stat.substr(stat.rfind(')') + 2));
  std::string skipped;
  for (int k = 0; k < 11; ++k) fields >> skipped;  // utime and stime are next
  long user = 0;
  long system = 0;
  fields >> user >> system;
  return static_cast<double>(user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}
