#include "wire/signal.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace wire {
namespace {

constexpr unsigned kFrameBits = 8 * kMaxFdLength;

// Position of the first bit when the bits of the frame are numbered in the order in
// which the signal runs through them.
constexpr unsigned first_bit(const Signal& signal) {
  return signal.byte_order == ByteOrder::kBigEndian
             ? signal.start / 8U * 8U + (7U - signal.start % 8U)
             : signal.start;
}

constexpr std::uint64_t mask(unsigned length) {
  return length >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << length) - 1;
}

// A signal covers 1 to 9 bytes. Each gives its part of the value: its `bits` from bit
// `low` of the byte on, which come to stand at bit `at` of the value.
struct Part {
  unsigned byte;
  unsigned low;
  unsigned bits;
  unsigned at;
};

template <class Take>
constexpr void for_parts(const Signal& signal, Take take) {
  const unsigned first = first_bit(signal);
  unsigned done = 0;
  for (unsigned byte = first / 8U; done < signal.length; ++byte) {
    const unsigned begin = done == 0 ? first % 8U : 0U;
    const unsigned bits = std::min(8U - begin, signal.length - done);
    if (signal.byte_order == ByteOrder::kBigEndian) {
      take(Part{byte, 8U - begin - bits, bits, signal.length - done - bits});
    } else {
      take(Part{byte, begin, bits, done});
    }
    done += bits;
  }
}

constexpr bool carries(const FrameSignal& signal, const CanFrame& frame) {
  return (frame.id & ~signal.ignored) == signal.frame_id &&
         frame.extended == signal.extended && !frame.remote && !frame.error;
}

}  // namespace

const char* describe(SignalError error) {
  switch (error) {
    case SignalError::kNone:
      return "nothing is wrong";
    case SignalError::kLength:
      return "the length is not 1 to 64 bits";
    case SignalError::kOutsideFrame:
      return "the signal reaches beyond the 64th byte";
    case SignalError::kFloatLength:
      return "a float needs 32 bits and a double 64";
    case SignalError::kScale:
      return "the scale is 0 or scale or offset are not finite";
    case SignalError::kOtherFrame:
      return "the frame has another identifier or no data";
    case SignalError::kShortFrame:
      return "the frame is too short for the signal";
    case SignalError::kNotSelected:
      return "the multiplexor selects another signal";
    case SignalError::kNotFinite:
      return "the value is not finite";
    case SignalError::kNotRepresentable:
      return "the value does not fit the signal";
  }
  return "unknown";
}

SignalError check(const Signal& signal) {
  if (signal.length < 1 || signal.length > 64) return SignalError::kLength;
  if (first_bit(signal) + signal.length > kFrameBits) return SignalError::kOutsideFrame;
  if ((signal.type == ValueType::kFloat32 && signal.length != 32) ||
      (signal.type == ValueType::kFloat64 && signal.length != 64)) {
    return SignalError::kFloatLength;
  }
  if (!std::isfinite(signal.scale) || signal.scale == 0 ||
      !std::isfinite(signal.offset)) {
    return SignalError::kScale;
  }
  return SignalError::kNone;
}

SignalError check(const FrameSignal& signal) {
  const SignalError error = check(signal.signal);
  if (error != SignalError::kNone || !signal.multiplexed) return error;
  return check(signal.multiplexor);
}

std::uint8_t bytes_needed(const Signal& signal) {
  return static_cast<std::uint8_t>((first_bit(signal) + signal.length + 7U) / 8U);
}

bool needs_fd(const FrameSignal& signal) {
  return bytes_needed(signal.signal) > kMaxClassicLength ||
         (signal.multiplexed && bytes_needed(signal.multiplexor) > kMaxClassicLength);
}

std::uint64_t extract_raw(const Signal& signal, const CanFrame& frame) {
  std::uint64_t raw = 0;
  for_parts(signal, [&](const Part& part) {
    const std::uint64_t bits = frame.data[part.byte] >> part.low & mask(part.bits);
    raw |= bits << part.at;
  });
  return raw;
}

bool is_highest_raw(const Signal& signal, const CanFrame& frame) {
  constexpr std::uint16_t kFewestBits = 8;
  if (signal.type != ValueType::kInteger || signal.length < kFewestBits) return false;
  const std::uint64_t all = ~std::uint64_t{0} >> (64U - signal.length);
  return extract_raw(signal, frame) == (signal.is_signed ? all >> 1U : all);
}

void insert_raw(const Signal& signal, std::uint64_t raw, CanFrame& frame) {
  for_parts(signal, [&](const Part& part) {
    const std::uint64_t mine = mask(part.bits) << part.low;
    const std::uint64_t bits = raw >> part.at << part.low & mine;
    frame.data[part.byte] =
        static_cast<std::uint8_t>((frame.data[part.byte] & ~mine) | bits);
  });
}

double to_physical(const Signal& signal, std::uint64_t raw) {
  double value = 0;
  if (signal.type == ValueType::kFloat32) {
    value = static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(raw)));
  } else if (signal.type == ValueType::kFloat64) {
    value = std::bit_cast<double>(raw);
  } else if (signal.is_signed) {
    const unsigned unused = 64U - signal.length;
    value = static_cast<double>(static_cast<std::int64_t>(raw << unused) >> unused);
  } else {
    value = static_cast<double>(raw);
  }
  return value * signal.scale + signal.offset;
}

SignalError to_raw(const Signal& signal, double physical, std::uint64_t& raw) {
  const double value = (physical - signal.offset) / signal.scale;
  if (!std::isfinite(value)) return SignalError::kNotRepresentable;
  if (signal.type == ValueType::kFloat64) {
    raw = std::bit_cast<std::uint64_t>(value);
    return SignalError::kNone;
  }
  if (signal.type == ValueType::kFloat32) {
    constexpr double kLargestFloat = 3.4028234663852886e38;
    if (std::abs(value) > kLargestFloat) return SignalError::kNotRepresentable;
    raw = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    return SignalError::kNone;
  }
  const double steps = std::round(value);
  const double range =
      std::ldexp(1.0, signal.is_signed ? signal.length - 1 : signal.length);
  if (steps >= range || steps < (signal.is_signed ? -range : 0)) {
    return SignalError::kNotRepresentable;
  }
  raw = (signal.is_signed ? static_cast<std::uint64_t>(static_cast<std::int64_t>(steps))
                          : static_cast<std::uint64_t>(steps)) &
        mask(signal.length);
  return SignalError::kNone;
}

bool within_limits(const Signal& signal, double physical) {
  const double half =
      signal.type == ValueType::kInteger ? std::abs(signal.scale) / 2 : 0.0;
  return signal.minimum >= signal.maximum ||
         (physical >= signal.minimum - half && physical <= signal.maximum + half);
}

SignalError extract(const FrameSignal& signal, const CanFrame& frame, double& physical) {
  if (!carries(signal, frame)) return SignalError::kOtherFrame;
  if (signal.multiplexed) {
    if (frame.dlc < bytes_needed(signal.multiplexor)) return SignalError::kShortFrame;
    if (extract_raw(signal.multiplexor, frame) != signal.multiplex_value) {
      return SignalError::kNotSelected;
    }
  }
  if (frame.dlc < bytes_needed(signal.signal)) return SignalError::kShortFrame;
  const double value = to_physical(signal.signal, extract_raw(signal.signal, frame));
  if (!std::isfinite(value)) return SignalError::kNotFinite;
  physical = value;
  return SignalError::kNone;
}

SignalError insert(const FrameSignal& signal, double physical, CanFrame& frame) {
  if (!carries(signal, frame)) return SignalError::kOtherFrame;
  if (frame.dlc < bytes_needed(signal.signal) ||
      (signal.multiplexed && frame.dlc < bytes_needed(signal.multiplexor))) {
    return SignalError::kShortFrame;
  }
  std::uint64_t raw = 0;
  const SignalError error = to_raw(signal.signal, physical, raw);
  if (error != SignalError::kNone) return error;
  if (signal.multiplexed) insert_raw(signal.multiplexor, signal.multiplex_value, frame);
  insert_raw(signal.signal, raw, frame);
  return SignalError::kNone;
}

}  // namespace wire
