// A daemon for the diagnostic server in tests: keeps what it was asked to do.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "support/gateway/sample_status.hpp"
#include "wire/recording_image.hpp"
#include "wire/uds_server.hpp"

namespace support {

class UdsDaemon final : public wire::UdsActions {
 public:
  static constexpr std::uint32_t kSamples = 200;

  UdsDaemon() {
    for (const wire::LoopStatus& loop : loops) dtcs->update(loop);
  }

  [[nodiscard]] bool fill_random(std::span<std::uint8_t> out) override {
    for (std::uint8_t& byte : out) byte = static_cast<std::uint8_t>(++random_ * 37);
    return has_random;
  }
  [[nodiscard]] bool write_parameters(int loop,
                                      const wire::LoopParameters& parameters) override {
    status(loop).parameters = parameters;
    return willing;
  }
  [[nodiscard]] bool reset(int loop) override {
    resets.push_back(loop);
    return willing;
  }
  [[nodiscard]] bool evaluate(int loop) override {
    evaluations.push_back(loop);
    return willing;
  }
  [[nodiscard]] bool simulate(int loop, wire::LoopVerdict verdict) override {
    if (!willing) return false;
    for (wire::LoopStatus& status : loops) {
      if (loop != 0 && status.id != loop) continue;
      status.simulated = true;
      status.verdict = verdict;
    }
    return true;
  }
  void end_simulation(int loop) override {
    for (wire::LoopStatus& status : loops) {
      if (loop == 0 || status.id == loop) status.simulated = false;
    }
  }
  [[nodiscard]] std::uint32_t begin_recording(int loop) override {
    if (!willing) return 0;
    recording = image_of(loop);
    recording_open = true;
    return static_cast<std::uint32_t>(recording.size());
  }
  [[nodiscard]] std::uint32_t begin_history(int loop) override {
    history_loop = loop;
    recording = history;
    recording_open = !recording.empty();
    return static_cast<std::uint32_t>(recording.size());
  }
  void read_recording(std::uint32_t offset, std::span<std::uint8_t> out) override {
    std::copy_n(recording.begin() + offset, out.size(), out.begin());
  }
  void end_recording() override { recording_open = false; }
  void tell(wire::UdsAct act, std::uint8_t /*tester*/, int loop) override {
    told.emplace_back(act, loop);
  }

  [[nodiscard]] wire::LoopStatus& status(int loop) {
    return *std::find_if(
        loops.begin(), loops.end(),
        [loop](const wire::LoopStatus& candidate) { return candidate.id == loop; });
  }
  [[nodiscard]] static std::vector<std::uint8_t> image_of(int loop) {
    std::vector<std::uint8_t> image(wire::recording_bytes(kSamples));
    const std::span<std::uint8_t> out(image);
    wire::encode_recording_header(
        {static_cast<std::uint8_t>(loop), true, kSamples, 500'000, 1'700'000'000'000},
        out.first<wire::kRecordingHeaderBytes>());
    for (std::uint32_t k = 0; k < kSamples; ++k) {
      const float value = 0.25F * static_cast<float>(k);
      wire::encode_recording_sample(
          {value, -value, 50},
          out.subspan(wire::recording_bytes(k)).first<wire::kRecordingSampleBytes>());
    }
    return image;
  }

  std::array<wire::LoopStatus, 2> loops = sample_loops();
  wire::GatewayStatus gateway = sample_gateway();
  std::unique_ptr<wire::DtcStore> dtcs = std::make_unique<wire::DtcStore>();
  bool willing = true;  ///< false: refuses everything
  bool has_random = true;
  std::vector<int> resets;
  std::vector<int> evaluations;
  std::vector<std::pair<wire::UdsAct, int>> told;
  std::vector<std::uint8_t> recording;
  std::vector<std::uint8_t> history;  // empty: none is to be had
  int history_loop = 0;
  bool recording_open = false;

 private:
  unsigned random_ = 0;
};

}  // namespace support
