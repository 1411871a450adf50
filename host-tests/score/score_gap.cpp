// The model-gap watch on loops with a hidden effect: which effect it suspects.
//
//   score_gap [SEEDS] [--first-seed N] [--details]
//
// Thresholds of lib/ident/gap/model_gap.cpp were set on seeds from 1000 on; the printed
// table is for seeds 1 … SEEDS (5). Each effect alone and beside stiction, driven by
// setpoint steps and by a limit cycle, at signal-to-noise 40 and 10. The identifier has
// friction, two lags, dead time and an integrator in its model already: of those effects
// none may be suspected.

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ident/base/configurations.hpp"
#include "ident/identifier.hpp"
#include "support/hidden/case.hpp"

namespace {

using Identifier = ident::Identifier<float, ident::kStandardWindow>;
using hidden::Effect;

bool in_reach(Effect effect) {
  switch (effect) {
    case Effect::kStiction:
    case Effect::kBacklash:
    case Effect::kPositionerLag:
    case Effect::kDeadTime:
    case Effect::kSecondLag:
    case Effect::kIntegrating:
    case Effect::kSensorLag:
      return true;
    default:
      return false;
  }
}

bool same_group(std::string_view a, std::string_view b) {
  const auto bends = [](std::string_view code) {
    return code == "valve.characteristic" || code == "process.nonlinear_gain";
  };
  return a == b || (bends(a) && bends(b));
}

struct Row {
  int cases = 0;
  int right = 0;
  int none = 0;
  int wrong = 0;
};

ident::ModelGapReport<float> gap_of(const workbench::Recording& recording) {
  const auto identifier = std::make_unique<Identifier>();
  const auto narrow = [](const std::vector<double>& from) {
    return std::vector<float>(from.begin(), from.end());
  };
  const auto u = narrow(recording.u);
  const auto y = narrow(recording.y);
  const auto sp = narrow(recording.sp);
  return identifier->run(u, y, sp).gap;
}

void judge(const hidden::CaseKey& key, bool details, Row& row) {
  hidden::HiddenCase loop;
  try {
    loop = hidden::make_case(key);
  } catch (const std::exception&) {
    return;  // no draw of this key matters
  }
  const auto gap = gap_of(loop.recording);
  const std::string_view found = name(gap.suspect);
  std::string_view hidden_code;
  for (const Effect effect : key.effects) {
    if (!in_reach(effect)) hidden_code = hidden::code_of(effect);
  }
  ++row.cases;
  row.none += found.empty() ? 1 : 0;
  if (!found.empty()) {
    (same_group(found, hidden_code) ? row.right : row.wrong) += 1;
  }
  if (details) {
    std::fprintf(stderr, "%s: %s share %.2f residual %.3f\n", describe(key).c_str(),
                 found.empty() ? "none" : std::string(found).c_str(),
                 static_cast<double>(gap.share_of_error),
                 static_cast<double>(gap.residual));
  }
}

void print(const std::string& title, const Row& row) {
  std::printf("| %s | %d | %d | %d | %d |\n", title.c_str(), row.cases, row.right,
              row.none, row.wrong);
}

}  // namespace

int main(int argc, char** argv) {
  int seeds = 5;
  int first = 1;
  bool details = false;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--details") == 0) {
      details = true;
    } else if (std::strcmp(argv[i], "--first-seed") == 0 && i + 1 < argc) {
      first = std::atoi(argv[++i]);
    } else {
      seeds = std::atoi(argv[i]);
    }
  }
  if (seeds < 1 || first < 1) {
    std::fputs("usage: score_gap [SEEDS] [--first-seed N] [--details]\n", stderr);
    return 2;
  }
  Row alone;
  Row beside;
  Row reachable;
  std::puts(
      "| hidden effect | loops | suspected | nothing | another |\n"
      "|---|---|---|---|---|");
  const auto run = [&](const std::vector<Effect>& effects) {
    Row row;
    for (int seed = first; seed < first + seeds; ++seed) {
      for (const auto excitation :
           {hidden::Excitation::kSetpointSteps, hidden::Excitation::kLimitCycle}) {
        for (const double ratio : {40.0, 10.0}) {
          judge({effects, excitation, ratio, static_cast<std::uint64_t>(seed), false},
                details, row);
        }
      }
    }
    return row;
  };
  const auto add = [](Row& to, const Row& row) {
    to.cases += row.cases;
    to.right += row.right;
    to.none += row.none;
    to.wrong += row.wrong;
  };
  for (const Effect effect : hidden::all_effects()) {
    const Row row = run({effect});
    print(std::string(hidden::code_of(effect)), row);
    add(in_reach(effect) ? reachable : alone, row);
    if (!in_reach(effect)) {
      const Row pair = run({Effect::kStiction, effect});
      print("valve.stiction + " + std::string(hidden::code_of(effect)), pair);
      add(beside, pair);
    }
  }
  const Row clean = run({});
  print("none", clean);
  print("**all beyond the model, alone**", alone);
  print("**all beyond the model, beside stiction**", beside);
  print("**all within the model**", reachable);
}
