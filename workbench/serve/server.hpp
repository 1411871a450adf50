// The page and its API on 127.0.0.1.
#pragma once

#include <cstddef>
#include <memory>
#include <stdexcept>

#include "workbench/serve/session.hpp"

namespace workbench {

/// The port cannot be had: in use, or not allowed.
class PortError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Largest body of a request, bytes.
inline constexpr std::size_t kMostBodyBytes = std::size_t{64} << 20;
/// First of the ports that are tried where none is asked for.
inline constexpr int kUsualPort = 8316;
inline constexpr int kUsualPorts = 10;

/// Construct → port() → run() … stop(). Answers this machine only: requests by another
/// name or from another web site get 403 (origin.hpp), longer bodies than kMostBodyBytes
/// 413. 32 connections at a time; a client that stalls for 5 s is dropped.
class PageServer {
 public:
  /// Takes `port`, one that is free for 0; without one the first that is free from
  /// kUsualPort on. Throws PortError. `session` must outlive it.
  PageServer(Session& session, std::optional<int> port);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  [[nodiscard]] int port() const { return port_; }
  /// Serves until stop(). False where it ended for another reason.
  [[nodiscard]] bool run();
  /// From another thread; run() returns when what is being answered is. May come before
  /// run().
  void stop();

 private:
  void take_port(std::optional<int> port);

  struct Transport;
  std::unique_ptr<Transport> transport_;
  int port_ = 0;
};

}  // namespace workbench
