#include <array>

#include "wire/dbc.hpp"

namespace wire {
namespace {

struct Expected {
  DbcError error;
  const char* text;
};

constexpr std::array kExpected = std::to_array<Expected>({
    {DbcError::kNone, "nothing else"},
    {DbcError::kMessageId,
     "a CAN identifier in decimal (up to 2047, or bit 31 and up to 29 bits)"},
    {DbcError::kMessageName, "a message name"},
    {DbcError::kMessageColon, "':' after the message name"},
    {DbcError::kMessageLength, "the length of the message in bytes"},
    {DbcError::kSignalOutsideMessage, "a BO_ message before the first SG_"},
    {DbcError::kSignalName, "a signal name"},
    {DbcError::kMultiplexing, "M, m followed by a number, or ':'"},
    {DbcError::kSignalColon, "':' after the signal name"},
    {DbcError::kStart, "the start bit and '|'"},
    {DbcError::kLength, "the length in bits and '@'"},
    {DbcError::kByteOrder, "the byte order, 0 (Motorola) or 1 (Intel)"},
    {DbcError::kSign, "the sign, + or -"},
    {DbcError::kScaleOffset, "(scale,offset) with finite numbers, scale not 0"},
    {DbcError::kLimits, "[minimum|maximum]"},
    {DbcError::kUnit, "the unit in quotes"},
    {DbcError::kValueType, "SIG_VALTYPE_ id signal : 0, 1 (float) or 2 (double)"},
    {DbcError::kMultiplexRange, "SG_MUL_VAL_ id signal multiplexor from-to"},
    {DbcError::kOpenString, "a closing quote before the end of the file"},
    {DbcError::kTooManyMessages, "fewer messages"},
    {DbcError::kTooManySignals, "fewer signals"},
    {DbcError::kNoMessage, "a DBC file with at least one BO_ message"},
    {DbcError::kReference, "a signal as MESSAGE.SIGNAL"},
    {DbcError::kUnknownMessage, "the name of a message in the DBC file"},
    {DbcError::kUnknownSignal, "the name of a signal of that message"},
    {DbcError::kAmbiguous, "a name that is defined once"},
    {DbcError::kNoMultiplexor, "one multiplexor (M) in the message of a signal mN"},
    {DbcError::kExtendedMultiplexing, "a signal without extended multiplexing"},
    {DbcError::kLayout, "a signal within the data bytes of its message"},
});

}  // namespace

const char* expected_at(DbcError error) {
  for (const Expected& one : kExpected) {
    if (one.error == error) return one.text;
  }
  return "a DBC file";
}

}  // namespace wire
