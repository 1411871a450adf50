// One tag of an export in which each has times of its own.
#pragma once

#include <cstdint>
#include <vector>

#include "workbench/recording/csv_source.hpp"
#include "workbench/recording/resample.hpp"
#include "workbench/recording/row_table.hpp"
#include "workbench/recording/time_column.hpp"

namespace workbench {

/// One signal with its own times.
struct Stream {
  Stream(SignalRows of, TimeColumn at) : signal(std::move(of)), times(std::move(at)) {}

  SignalRows signal;
  TimeColumn times;
  TimeCell first_cell;
  std::vector<std::uint32_t> line;
  std::vector<double> t;

  [[nodiscard]] bool is_of_loop() const {
    return signal.column == Column::u || signal.column == Column::y;
  }
};

/// Brings the samples into the order of their times.
void sort(Stream& stream);

/// Samples without value go, with a note; the grid then holds the one before.
void drop_gaps(Stream& stream, ResampleReport& report);

}  // namespace workbench
