#include "firmware/notice_text.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace firmware {
namespace {

using hal::Message;

struct Kind {
  NoticeKind kind;
  std::string_view name;
  Priority priority;
  Topic topic;
};

constexpr std::array kKinds = {
    Kind{NoticeKind::kMonitor, "", Priority::kInfo, Topic::kLoops},  // as its event
    Kind{NoticeKind::kInputFault, "input_fault", Priority::kWarning, Topic::kInputs},
    Kind{NoticeKind::kInputRestored, "input_restored", Priority::kNotice, Topic::kInputs},
    Kind{NoticeKind::kFlagRaised, "flag_raised", Priority::kWarning, Topic::kFlags},
    Kind{NoticeKind::kFlagKept, "flag_kept", Priority::kWarning, Topic::kFlags},
    Kind{NoticeKind::kFlagLowered, "flag_lowered", Priority::kNotice, Topic::kFlags},
    Kind{NoticeKind::kBandChanged, "band_changed", Priority::kWarning, Topic::kLoops},
    Kind{NoticeKind::kTrend, "trend", Priority::kWarning, Topic::kLoops},
    Kind{NoticeKind::kSpanDoubted, "span_doubted", Priority::kWarning, Topic::kLoops},
    Kind{NoticeKind::kSignalsSwapped, "signals_swapped", Priority::kWarning,
         Topic::kLoops},
    Kind{NoticeKind::kSlowSignal, "slow_signal", Priority::kWarning, Topic::kLoops},
    Kind{NoticeKind::kTwoSenders, "two_senders", Priority::kWarning, Topic::kLoops},
    Kind{NoticeKind::kSuspended, "suspended", Priority::kNotice, Topic::kInputs},
    Kind{NoticeKind::kResumed, "resumed", Priority::kNotice, Topic::kInputs},
    Kind{NoticeKind::kBusUp, "bus_up", Priority::kNotice, Topic::kGateway},
    Kind{NoticeKind::kBusDown, "bus_down", Priority::kWarning, Topic::kGateway},
    Kind{NoticeKind::kBusOff, "bus_off", Priority::kError, Topic::kGateway},
    Kind{NoticeKind::kAccess, "access", Priority::kWarning, Topic::kGateway},
    Kind{NoticeKind::kGap, "gap", Priority::kWarning, Topic::kGateway},
};

constexpr bool kInOrder = [] {
  for (std::size_t k = 0; k < kKinds.size(); ++k) {
    if (kKinds[k].kind != static_cast<NoticeKind>(k)) return false;
  }
  return kKinds.back().kind == NoticeKind::kGap;
}();
static_assert(kInOrder, "kind_of() takes a kind for its place");

const Kind& kind_of(const Notice& notice) {
  return kKinds[static_cast<std::size_t>(notice.kind)];
}

void put_band(char* out, std::size_t size, const ident::Estimate<float>& band) {
  if (band.known) {
    std::snprintf(out, size, "%.4g", static_cast<double>(band.value));
  } else {
    std::snprintf(out, size, "unknown");
  }
}

Message describe_kept_flag(const Notice& notice, const char* tag) {
  if (std::isnan(notice.age_s)) {
    return Message::of("%s: FLAG RAISED as before, by a window of unknown age", tag);
  }
  return Message::of("%s: FLAG RAISED as before, by a window that ended %.4g h ago", tag,
                     notice.age_s / 3600);
}

Message describe_band(const Notice& notice, const char* tag) {
  const wire::StrokeValues& low = notice.band_low_pct;
  const wire::StrokeValues& high = notice.band_high_pct;
  return Message::of(
      "%s: the stick band has changed: now %.4g to %.4g %% of span ascending, "
      "%.4g to %.4g %% descending",
      tag, low.ascending, high.ascending, low.descending, high.descending);
}

Message describe_trend(const Trend& trend, const char* tag) {
  const double per_week = 7 * trend.slope;
  if (std::isnan(trend.days)) {
    return Message::of("%s: the stick band falls: %.3g %% of span a week (%.3g to %.3g)",
                       tag, per_week, 7 * trend.low, 7 * trend.high);
  }
  return Message::of(
      "%s: the stick band grows: %.3g %% of span a week (%.3g to %.3g); needs "
      "attention in about %.0f days, %.0f to %.0f",
      tag, per_week, 7 * trend.low, 7 * trend.high, trend.days, trend.days_early,
      trend.days_late);
}

Message describe_event(const ident::Event<float>& event, const char* tag,
                       double period_s) {
  switch (event.kind) {
    case ident::EventKind::kOscillationStarted:
      return Message::of("%s: oscillation started, period %.4g s", tag,
                         static_cast<double>(event.period_samples) * period_s);
    case ident::EventKind::kOscillationEnded:
      return Message::of("%s: oscillation ended", tag);
    case ident::EventKind::kStictionRaised: {
      char ascending[16];
      char descending[16];
      put_band(ascending, sizeof ascending, event.stick_band.ascending);
      put_band(descending, sizeof descending, event.stick_band.descending);
      return Message::of("%s: STICTION RAISED, stick band %s ascending, %s descending",
                         tag, ascending, descending);
    }
    case ident::EventKind::kStictionCleared:
      return Message::of("%s: stiction cleared", tag);
    default: {
      const std::string_view why = ident::sentence(event.reason);
      return Message::of("%s: undecided: %.*s", tag, static_cast<int>(why.size()),
                         why.data());
    }
  }
}

Message describe_fault(const Notice& notice, const config::Loop& loop) {
  const std::string_view input = name_of(notice.input);
  const char* tag = loop.tag.c_str();
  if (!notice.far) {
    return Message::of("%s: input fault: %.*s", tag, static_cast<int>(input.size()),
                       input.data());
  }
  const bool is_u = notice.far->role == Role::kU;
  const std::array<double, 2>& span = is_u ? loop.span : loop.y_span;
  return Message::of(
      "%s: input fault: out_of_range: %s reads %.4g, a span or more outside %.4g to "
      "%.4g; "
      "correct scale, offset or `%s`, or refuse it by `minimum` and `maximum`",
      tag, name_of(notice.far->role), notice.far->value, span[0], span[1],
      is_u ? "span" : "y_span");
}

// A key of the configuration that what comes does not bear out.
Message describe_doubt(const Notice& notice, const config::Loop& loop) {
  if (notice.kind == NoticeKind::kSpanDoubted) {
    return Message::of(
        "%s: u ran from %.4g to %.4g, expected most of it in the span %.4g to %.4g, "
        "and 2 %% of that; correct `span`",
        loop.tag.c_str(), notice.u_range[0], notice.u_range[1], loop.span[0],
        loop.span[1]);
  }
  if (notice.kind == NoticeKind::kSignalsSwapped) {
    return Message::of(
        "%s: y moves as a controller moves its output, and u does not: expected the "
        "controller output as u and the process output as y; exchange `u` and `y`",
        loop.tag.c_str());
  }
  if (notice.kind == NoticeKind::kTwoSenders) {
    return Message::of(
        "%s: %s comes from the source addresses 0x%02X and 0x%02X: only the first is "
        "used; expected one sender, give its source_address",
        loop.tag.c_str(), name_of(notice.senders.role), notice.senders.used,
        notice.senders.other);
  }
  return Message::of(
      "%s: sample_period_s is %.4g, but %s comes every %.3g s: what lies between is "
      "held; expected at least that, correct sample_period_s",
      loop.tag.c_str(), loop.sample_period_s, name_of(notice.slow.role),
      notice.slow.interval_s);
}

const char* what_was_done(wire::UdsAct act) {
  switch (act) {
    case wire::UdsAct::kUnlocked:
      return "unlocked";
    case wire::UdsAct::kRefusedKey:
      return "sent a wrong key";
    case wire::UdsAct::kWritten:
      return "wrote parameters";
    case wire::UdsAct::kCleared:
      return "cleared DTCs";
    case wire::UdsAct::kReset:
      return "reset";
    case wire::UdsAct::kSimulated:
      return "began or ended a simulation";
  }
  return "";
}

Message describe_access(const Notice& notice) {
  const char* what = what_was_done(notice.act);
  if (notice.act == wire::UdsAct::kUnlocked || notice.act == wire::UdsAct::kRefusedKey) {
    return Message::of("tester %02X %s", notice.tester, what);
  }
  if (notice.loop == 0) {
    return Message::of("tester %02X %s, all loops", notice.tester, what);
  }
  return Message::of("tester %02X %s, loop %d", notice.tester, what, notice.loop);
}

Message describe_loop(const Notice& notice, const config::Loop& loop) {
  const char* tag = loop.tag.c_str();
  switch (notice.kind) {
    case NoticeKind::kMonitor:
      return describe_event(notice.event, tag, loop.sample_period_s);
    case NoticeKind::kInputFault:
      return describe_fault(notice, loop);
    case NoticeKind::kInputRestored:
      return Message::of("%s: input restored", tag);
    case NoticeKind::kFlagRaised:
      return Message::of("%s: FLAG RAISED", tag);
    case NoticeKind::kFlagKept:
      return describe_kept_flag(notice, tag);
    case NoticeKind::kBandChanged:
      return describe_band(notice, tag);
    case NoticeKind::kTrend:
      return describe_trend(notice.trend, tag);
    case NoticeKind::kSpanDoubted:
    case NoticeKind::kSignalsSwapped:
    case NoticeKind::kSlowSignal:
    case NoticeKind::kTwoSenders:
      return describe_doubt(notice, loop);
    case NoticeKind::kSuspended:
    case NoticeKind::kResumed:
      return Message::of(
          "%s: %s", tag,
          text_of_mode(loop, notice.kind == NoticeKind::kSuspended, notice.mode).c_str());
    default:
      return Message::of("%s: flag lowered", tag);
  }
}

}  // namespace

std::string_view name_of(wire::InputStatus status) {
  for (const wire::LoopField& field : wire::loop_fields()) {
    if (field.name != "input_status") continue;
    for (const wire::Choice& choice : field.choices) {
      if (choice.value == static_cast<std::uint8_t>(status)) return choice.name;
    }
  }
  return "good";
}

hal::Message text_of_mode(const config::Loop& loop, bool suspended, double mode) {
  std::array<char, 96> automatic{};
  std::size_t used = 0;
  const std::size_t count = loop.auto_values.size();
  for (std::size_t k = 0; k < count && used + 1 < automatic.size(); ++k) {
    const char* const before = k == 0 ? "" : k + 1 == count ? " or " : ", ";
    used +=
        static_cast<std::size_t>(std::snprintf(&automatic[used], automatic.size() - used,
                                               "%s%.6g", before, loop.auto_values[k]));
  }
  return Message::of("%s: mode reads %.6g, automatic is %s",
                     suspended ? "suspended" : "resumed", mode, automatic.data());
}

hal::Message text_of(const Notice& notice, const config::Gateway& gateway) {
  if (notice.kind == NoticeKind::kAccess) return describe_access(notice);
  if (notice.kind == NoticeKind::kGap) {
    return Message::of("gap: the clock of the log goes %s by %.6g s",
                       notice.gap_s < 0 ? "back" : "on", std::abs(notice.gap_s));
  }
  if (notice.kind >= NoticeKind::kBusUp) {
    const char* bus = gateway.buses[notice.index].name.c_str();
    const char* what = notice.kind == NoticeKind::kBusUp     ? "is up"
                       : notice.kind == NoticeKind::kBusDown ? "is down"
                                                             : "is off: too many errors";
    return Message::of("bus %s %s", bus, what);
  }
  return describe_loop(notice, gateway.loops[notice.index]);
}

Priority priority_of(const Notice& notice) {
  const bool raised = notice.kind == NoticeKind::kMonitor &&
                      notice.event.kind == ident::EventKind::kStictionRaised;
  return raised ? Priority::kWarning : kind_of(notice).priority;
}

Topic topic_of(const Notice& notice) {
  return kind_of(notice).topic;
}

std::string_view name_of(const Notice& notice) {
  return notice.kind == NoticeKind::kMonitor ? ident::name(notice.event.kind)
                                             : kind_of(notice).name;
}

}  // namespace firmware
