// The bytes of the diagnostic services (UDS, ISO 14229-1) that are used here.
#pragma once

#include <cstdint>

namespace wire {

namespace uds {

inline constexpr std::uint8_t kSessionControl = 0x10;
inline constexpr std::uint8_t kClearDtcs = 0x14;
inline constexpr std::uint8_t kReadDtcs = 0x19;
inline constexpr std::uint8_t kReadData = 0x22;
inline constexpr std::uint8_t kSecurityAccess = 0x27;
inline constexpr std::uint8_t kWriteData = 0x2E;
inline constexpr std::uint8_t kRoutine = 0x31;
inline constexpr std::uint8_t kRequestUpload = 0x35;
inline constexpr std::uint8_t kTransferData = 0x36;
inline constexpr std::uint8_t kTransferExit = 0x37;
inline constexpr std::uint8_t kTesterPresent = 0x3E;

inline constexpr std::uint8_t kPositive = 0x40;  ///< added to the service
inline constexpr std::uint8_t kNegative = 0x7F;  ///< then the service and an Nrc
inline constexpr std::uint8_t kSuppress = 0x80;  ///< of a sub-function: no response

}  // namespace uds

enum class Nrc : std::uint8_t {
  kNone = 0,
  kServiceNotSupported = 0x11,
  kSubFunctionNotSupported = 0x12,
  kIncorrectLength = 0x13,
  kResponseTooLong = 0x14,
  kBusyRepeatRequest = 0x21,
  kConditionsNotCorrect = 0x22,
  kRequestSequenceError = 0x24,
  kRequestOutOfRange = 0x31,
  kSecurityAccessDenied = 0x33,
  kInvalidKey = 0x35,
  kExceededAttempts = 0x36,
  kTimeDelayNotExpired = 0x37,
  kWrongBlockSequence = 0x73,
  kResponsePending = 0x78,
  kSubFunctionNotInSession = 0x7E,
  kServiceNotInSession = 0x7F,
};

}  // namespace wire
