#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "workbench/recording/input_error.hpp"
#include "workbench/recording/tag_stream.hpp"

namespace workbench {
namespace {

Stream sampled(Column column, const std::vector<double>& t) {
  SignalRows signal;
  signal.column = column;
  signal.name = std::string(name_of(column));
  signal.values = t;
  Stream stream(std::move(signal), TimeColumn(TimeForm::kNumber, 1, false, {}));
  stream.t = t;
  stream.line.assign(t.size(), 2);
  return stream;
}

class StreamGrids : public testing::Test {
 protected:
  RowTable table_of(std::vector<Stream> streams) {
    return merged(std::move(streams), {file_, 1, required_}, report_, on_grid_);
  }
  std::string file_ = "f.csv";
  std::vector<Column> required_ = {Column::u, Column::y};
  ResampleReport report_;
  bool on_grid_ = false;
};

TEST_F(StreamGrids, EqualTimesStayAsTheyAre) {
  const RowTable table =
      table_of({sampled(Column::u, {0, 1, 5}), sampled(Column::y, {0, 1, 5})});
  EXPECT_EQ(table.t, (std::vector<double>{0, 1, 5}));
  EXPECT_FALSE(on_grid_);
}

TEST_F(StreamGrids, OtherTimesMeetOnAGrid) {
  const RowTable table =
      table_of({sampled(Column::u, {0, 1, 2, 3}), sampled(Column::y, {0, 2, 3})});
  EXPECT_TRUE(on_grid_);
  EXPECT_EQ(table.signals.at(1).values, (std::vector<double>{0, 0, 2, 3}));
}

TEST_F(StreamGrids, RefusesSignalsOfDifferentTimes) {
  EXPECT_THROW(table_of({sampled(Column::u, {0, 1}), sampled(Column::y, {5, 6})}),
               InputError);
  EXPECT_THROW(table_of({sampled(Column::u, {0}), sampled(Column::y, {0, 1})}),
               InputError);
}

}  // namespace
}  // namespace workbench
