// The recording window of a gateway's loop, or its history, fetched over UDS.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "wire/history_row.hpp"
#include "wire/recording_image.hpp"
#include "workbench/pull/uds_client.hpp"

namespace workbench {

struct PulledRecording {
  std::string tag;  ///< of the loop
  wire::RecordingHeader header;
  std::vector<wire::RecordingSample> samples;  ///< NaN: missing
};

/// Fetches the window of loop 1 … 31. `progress` gets bytes so far and in all. Throws
/// DeviceError, also when what came is damaged.
[[nodiscard]] PulledRecording pull_recording(
    UdsClient& client, int loop,
    const std::function<void(std::size_t, std::size_t)>& progress);

struct PulledHistory {
  std::string tag;                     ///< of the loop
  std::vector<wire::HistoryRow> rows;  ///< by time
};

/// Fetches what windows of loop 1 … 31 said, for years. As above.
[[nodiscard]] PulledHistory pull_history(
    UdsClient& client, int loop,
    const std::function<void(std::size_t, std::size_t)>& progress);

/// The history as CSV (wire/history_csv.hpp).
[[nodiscard]] std::string csv_of(const PulledHistory& history);

/// The recording as CSV: t from 0, u, y and, where it was recorded, sp. Rows without u or
/// y are left out.
[[nodiscard]] std::string csv_of(const PulledRecording& recording);

}  // namespace workbench
