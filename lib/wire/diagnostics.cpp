#include "wire/diagnostics.hpp"

#include <algorithm>
#include <cmath>

#include "wire/big_endian.hpp"

namespace wire {
namespace {

constexpr std::uint64_t kI16NotAvailable = 0x7FFF;
constexpr double kPathScale = 0.01;
constexpr std::size_t kKnotBytes = 6;

std::uint64_t all_ones(FieldType type) {
  return ~std::uint64_t{0} >> (64 - 8 * size_of(type));
}
std::uint64_t not_available(FieldType type) {
  return type == FieldType::kI16 ? kI16NotAvailable : all_ones(type);
}

// Appends to a span; what does not fit is counted all the same.
class Writer {
 public:
  explicit Writer(std::span<std::uint8_t> out) : out_(out) {}
  void number(std::uint64_t value, std::size_t bytes) {
    if (fits(bytes)) put_big_endian(value, out_.subspan(at_, bytes));
    at_ += bytes;
  }
  void text(std::string_view text, std::size_t bytes) {
    if (fits(bytes)) {
      const std::size_t length = std::min(text.size(), bytes);
      std::copy_n(text.begin(), length, out_.begin() + at_);
      std::fill_n(out_.begin() + at_ + length, bytes - length, std::uint8_t{0});
    }
    at_ += bytes;
  }
  /// Bytes that were asked for, whether they fitted or not.
  [[nodiscard]] std::size_t needed() const { return at_; }
  [[nodiscard]] std::size_t written() const { return at_ <= out_.size() ? at_ : 0; }

 private:
  [[nodiscard]] bool fits(std::size_t bytes) const {
    return at_ <= out_.size() && bytes <= out_.size() - at_;
  }
  std::span<std::uint8_t> out_;
  std::size_t at_ = 0;
};

void write_path(const LoopStatus& loop, Writer& out) {
  const std::size_t knots = std::min<std::size_t>(loop.path_knots, kMostPathKnots);
  out.number(knots, 1);
  for (const PathKnot& knot : std::span(loop.path).first(knots)) {
    for (const double value : {knot.u_pct, knot.x_ascending_pct, knot.x_descending_pct}) {
      out.number(to_raw(FieldType::kI16, kPathScale, value), kKnotBytes / 3);
    }
  }
}

template <class Subject>
void write_field(const Field<Subject>& field, const Subject& subject, Writer& out) {
  if (field.number != nullptr) {
    out.number(to_raw(field.type, field.scale, field.number(subject)),
               size_of(field.type));
  } else if (field.text != nullptr) {
    const std::string_view text = field.text(subject);
    out.text(text, field.text_bytes != 0 ? field.text_bytes : text.size());
  }
}

void write_loop_object(int offset, const LoopStatus& loop, Writer& out) {
  for (const LoopField& field : loop_fields()) {
    if (field.object != offset) continue;
    if (field.type == FieldType::kPath) {
      write_path(loop, out);
    } else {
      write_field(field, loop, out);
    }
  }
}

bool write_gateway_object(std::uint16_t did, const GatewayView& view, Writer& out) {
  bool found = false;
  for (const GatewayField& field : gateway_fields()) {
    if (field.object != did) continue;
    write_field(field, view, out);
    found = true;
  }
  return found;
}

// Calls `visit(did, write)` for every object but the directory, in the order of the
// table; `write` appends it to a Writer.
template <class Visit>
void for_each_object(const GatewayView& view, Visit visit) {
  std::uint16_t last = 0;
  for (const GatewayField& field : gateway_fields()) {
    if (field.object == last) continue;
    last = field.object;
    visit(last, [&](Writer& out) { (void)write_gateway_object(last, view, out); });
  }
  for (const LoopStatus& loop : view.loops) {
    for (const LoopObject& object : loop_objects()) {
      visit(loop_did(loop.id, object.offset),
            [&](Writer& out) { write_loop_object(object.offset, loop, out); });
    }
  }
}

void write_directory(const GatewayView& view, Writer& out) {
  constexpr std::size_t kEntry = 4;
  std::size_t entries = 1;
  for_each_object(view, [&](std::uint16_t, auto) { ++entries; });
  out.number(kDirectoryDid, 2);
  out.number(kEntry * entries, 2);
  for_each_object(view, [&](std::uint16_t did, auto write) {
    Writer measure({});
    write(measure);
    out.number(did, 2);
    out.number(measure.needed(), 2);
  });
}

template <class Subject>
std::optional<double> shown_number(const Field<Subject>& field, const Subject& subject) {
  if (field.number == nullptr) return std::nullopt;
  return from_raw(field.type, field.scale,
                  to_raw(field.type, field.scale, field.number(subject)));
}

CanFrame cyclic_frame(int number, const LoopStatus& loop, std::uint32_t id) {
  CanFrame frame;
  frame.id = id;
  frame.extended = frame.id > kMaxStandardId;
  frame.dlc = kMaxClassicLength;
  Writer writer(frame.data);
  for (const LoopField& field : loop_fields()) {
    if (field.frame == number) write_field(field, loop, writer);
  }
  return frame;
}

bool is_ne107(std::uint64_t code) {
  return code <= static_cast<std::uint64_t>(Ne107::kMaintenanceRequired);
}

}  // namespace

int severity(Ne107 status) {
  switch (status) {
    case Ne107::kFailure:
      return 4;
    case Ne107::kCheckFunction:
      return 3;
    case Ne107::kOffSpec:
      return 2;
    case Ne107::kMaintenanceRequired:
      return 1;
    case Ne107::kNormal:
      break;
  }
  return 0;
}

bool is_usable(InputStatus status) {
  return status == InputStatus::kGood || status == InputStatus::kUncertain;
}

bool is_valid(const LoopParameters& parameters) {
  constexpr std::uint16_t kMostWindows = 1000;
  constexpr double kMostBand = 100;
  return parameters.on_delay_windows >= 1 &&
         parameters.on_delay_windows <= kMostWindows &&
         parameters.off_delay_windows >= 1 &&
         parameters.off_delay_windows <= kMostWindows && parameters.band_min_pct >= 0 &&
         parameters.band_min_pct <= kMostBand;
}

Ne107 ne107_of(const LoopStatus& loop) {
  if (loop.simulated) return Ne107::kCheckFunction;
  if (!is_usable(loop.input) || loop.verdict == LoopVerdict::kInputInvalid) {
    return loop.parameters.input_invalid;
  }
  if (!loop.confirmed) return Ne107::kNormal;
  switch (loop.verdict) {
    case LoopVerdict::kStiction:
      return loop.parameters.stiction;
    case LoopVerdict::kBacklash:
      return loop.parameters.backlash;
    case LoopVerdict::kOtherOscillation:
      return loop.parameters.oscillation_other;
    default:
      return Ne107::kNormal;
  }
}

Ne107 worst_ne107(std::span<const LoopStatus> loops) {
  Ne107 worst = Ne107::kNormal;
  for (const LoopStatus& loop : loops) {
    const Ne107 status = ne107_of(loop);
    if (severity(status) > severity(worst)) worst = status;
  }
  return worst;
}

std::uint64_t to_raw(FieldType type, double scale, double number) {
  constexpr double kExact = 9007199254740992;  // 2⁵³: the integers that a double holds
  if (std::isnan(number)) return not_available(type);
  const double most = std::min(static_cast<double>(not_available(type) - 1), kExact);
  const double least = type == FieldType::kI16 ? -32768.0 : 0.0;
  const double steps = std::clamp(std::floor(number / scale + 0.5), least, most);
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(steps)) & all_ones(type);
}

std::optional<double> from_raw(FieldType type, double scale, std::uint64_t raw) {
  if (raw == not_available(type)) return std::nullopt;
  // Dividing by the whole number 1/scale gives the double nearest to the decimal.
  const double steps = type == FieldType::kI16
                           ? static_cast<double>(static_cast<std::int16_t>(raw))
                           : static_cast<double>(raw);
  return scale < 1 ? steps / std::floor(1 / scale + 0.5) : steps * scale;
}

std::optional<double> shown(const LoopField& field, const LoopStatus& loop) {
  return shown_number(field, loop);
}
std::optional<double> shown(const GatewayField& field, const GatewayView& view) {
  return shown_number(field, view);
}

std::size_t encode_loop_object(int offset, const LoopStatus& loop,
                               std::span<std::uint8_t> out) {
  Writer writer(out);
  write_loop_object(offset, loop, writer);
  return writer.written();
}

std::optional<std::size_t> encode_did(std::uint16_t did, const GatewayView& view,
                                      std::span<std::uint8_t> out) {
  Writer writer(out);
  if (did == kDirectoryDid) {
    write_directory(view, writer);
    return writer.needed();
  }
  if (write_gateway_object(did, view, writer)) return writer.needed();
  for (const LoopStatus& loop : view.loops) {
    for (const LoopObject& object : loop_objects()) {
      if (did != loop_did(loop.id, object.offset)) continue;
      write_loop_object(object.offset, loop, writer);
      return writer.needed();
    }
  }
  return std::nullopt;
}

bool decode_parameters(std::span<const std::uint8_t> data, LoopParameters& out) {
  if (data.size() != kParameterBytes) return false;
  const auto word = [&](std::size_t at) {
    return static_cast<std::uint16_t>(get_big_endian(data.subspan(at, 2)));
  };
  for (const std::uint8_t code : data.subspan(6)) {
    if (!is_ne107(code)) return false;
  }
  LoopParameters parameters;
  parameters.on_delay_windows = word(0);
  parameters.off_delay_windows = word(2);
  const std::optional<double> band = from_raw(FieldType::kU16, kPathScale, word(4));
  parameters.band_min_pct = band.value_or(kNotAvailable);
  parameters.stiction = static_cast<Ne107>(data[6]);
  parameters.backlash = static_cast<Ne107>(data[7]);
  parameters.oscillation_other = static_cast<Ne107>(data[8]);
  parameters.input_invalid = static_cast<Ne107>(data[9]);
  if (!is_valid(parameters)) return false;
  out = parameters;
  return true;
}

CanFrame broadcast_frame(const LoopStatus& loop, std::uint32_t base_id) {
  return cyclic_frame(1, loop, base_id + loop.id);
}

CanFrame detail_frame(int frame, const LoopStatus& loop, std::uint32_t base_id) {
  return cyclic_frame(frame, loop, detail_id(frame, loop.id, base_id));
}

}  // namespace wire
