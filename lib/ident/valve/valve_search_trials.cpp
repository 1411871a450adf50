// The passes that the search for a valve makes without a decision between them.
#include <algorithm>
#include <array>

#include "ident/valve/valve_grid.hpp"
#include "ident/valve/valve_search.hpp"

namespace ident {
namespace {

constexpr double kFirstCycles = 2;  // that a valve with a memory is fitted to
// Shares of the best valve's bands, and stem positions, that are tried nearby.
constexpr int kBands = 12;
constexpr double kNarrowest = 0.7;
constexpr double kNarrower = 0.03;
constexpr int kStarts = 10;

template <class Real>
void narrow(ValveFriction<Real>& friction, Real share) {
  const auto narrowed = [&](Real slip, Real band) {
    return std::max(slip - (Real(1) - share) * band, Real(0));
  };
  friction.slip_ascending = narrowed(friction.slip_ascending, friction.stick_ascending());
  friction.slip_descending =
      narrowed(friction.slip_descending, friction.stick_descending());
}

}  // namespace

template <class Real>
void ValveSearch<Real>::begin(Trials trials, Stage then) {
  trials_ = trials;
  stage_ = then;
  round_ = 0;
}

// The next of the trials; true when there is none left.
template <class Real>
bool ValveSearch<Real>::next_trial() {
  switch (trials_) {
    case Trials::kOne:
      break;
    case Trials::kScreen:
      return screen_next();
    case Trials::kPolish:
      return polish_next();
    case Trials::kBeam:
    case Trials::kJobs:
      return polish_next() && !polish_another();
    case Trials::kPlaces:
    case Trials::kNearby:
      return try_next();
    case Trials::kRounds:
    case Trials::kMeasured:
      if constexpr (kSlipTracker) {
        return follow_next();
      }
      break;
  }
  return true;
}

template <class Real>
void ValveSearch<Real>::screen(SlipMotion motion, Stage then) {
  begin(Trials::kScreen, then);
  motion_ = motion;
  beam_ = {};
  nearby_ = false;
  std::size_t used = whole();
  if (motion_ != SlipMotion::kSlides) {
    const Real cycles = std::max(window().period * Real(kFirstCycles), Real(60));
    used =
        std::min(used, std::max(static_cast<std::size_t>(cycles), window().first_part));
  }
  pass_.use(used);
  index_ = -1;
  time_constant_ = kTimeConstants;
}

// One valve after the other: its positions, then the time constants behind them.
template <class Real>
bool ValveSearch<Real>::screen_next() {
  const bool slides = motion_ == SlipMotion::kSlides;
  // Where there are many candidates, neighbours share the time constants between them.
  const int stride = motion_ == SlipMotion::kResticks ? 2 : 1;
  if (time_constant_ == kNoTimeConstantYet) {
    time_constant_ = index_ % stride;
  } else if (time_constant_ < kTimeConstants) {
    take_screened();
    time_constant_ += stride;
  }
  if (time_constant_ < kTimeConstants) {
    pass_.screen(time_constants_[time_constant_]);
    return false;
  }
  ++index_;
  time_constant_ = kNoTimeConstantYet;
  form_ = ValveForm::kMixed;
  ValveModel<Real> model;
  const bool more = slides
                        ? sliding_start(index_, window().swing, form_, model.friction)
                        : remembering_start(index_, motion_, window().swing,
                                            window().u[0], model.friction, model.start);
  if (more) {
    model.start_known = !slides;
    pass_.place(model);
  }
  return !more;
}

template <class Real>
void ValveSearch<Real>::take_screened() {
  const ValveModel<Real>& model = pass_.model();
  if (motion_ != SlipMotion::kSlides) {
    keep_in_beam(time_constant_, model);
    return;
  }
  const bool integrating = !(model.poles.slow < Real(1));
  ValveModel<Real>& kept =
      beam_[static_cast<int>(form_) + (integrating ? kValveForms : 0)];
  if (better(model, kept)) {
    kept = model;
  }
}

template <class Real>
void ValveSearch<Real>::begin_polish(ValveForm form, const ValveModel<Real>& from) {
  form_ = form;
  polishing_ = Polish::kBegins;
  pass_.fit(from, true);
}

// Takes an evaluation of the present polish and begins the next. What came of it goes
// back to the beam, or is kept if it is the best of its form, with the error of its
// simulation: what least squares leaves is a difference of large sums, and wrong in
// single precision where columns are nearly alike.
template <class Real>
bool ValveSearch<Real>::polish_next() {
  const ValveModel<Real>& model = pass_.model();
  switch (polishing_) {
    case Polish::kIsPlaced:
      if (try_next()) {
        jumps_ = Real(ValvePolish<Real>::kGrownJumps);
        begin_polish(form_, tried_);
      }
      return false;
    case Polish::kBegins:
      polish_.start(form_, model, window(), ValvePolish<Real>::kEvaluations, jumps_);
      polishing_ = Polish::kGoesOn;
      break;
    case Polish::kGoesOn:
      polish_.report(model);
      break;
    case Polish::kIsKept: {
      ValveModel<Real>& kept = best_[static_cast<int>(form_)];
      if (better(model, kept)) {
        kept = model;
      }
      return true;
    }
    case Polish::kNone:
      return true;
  }
  if (!polish_.done()) {
    pass_.fit_next(polish_.propose());
    return false;
  }
  if (trials_ == Trials::kBeam) {
    beam_[index_++] = polish_.best();
    return true;
  }
  polishing_ = Polish::kIsKept;
  pass_.simulate(polish_.best());
  return false;
}

template <class Real>
void ValveSearch<Real>::polish_tried(Real jumps, Stage then) {
  begin(Trials::kPolish, then);
  jumps_ = jumps;
  begin_polish(ValveForm::kMixed, tried_);
}

// From one member or job on.
template <class Real>
void ValveSearch<Real>::polish_all(Trials trials, int from, Real jumps, Stage then) {
  begin(trials, then);
  jumps_ = jumps;
  index_ = from;
  polishing_ = Polish::kNone;
}

template <class Real>
bool ValveSearch<Real>::polish_another() {
  if (trials_ == Trials::kBeam) {
    if (index_ >= beam_size_) {
      return false;
    }
    begin_polish(ValveForm::kMixed, beam_[index_]);
    return true;
  }
  const bool slides = motion_ == SlipMotion::kSlides;
  ValveForm form;
  ValveModel<Real> from;
  while (slides ? slide_job(index_, form, from) : memory_job(index_, form, from)) {
    ++index_;
    if (from.known) {
      begin_job(form, from);
      return true;
    }
  }
  return false;
}

// Where one stroke is set free of its deadband, the stem rests elsewhere after each
// stroke: its place is looked for first, or every trial loses step.
template <class Real>
void ValveSearch<Real>::begin_job(ValveForm form, const ValveModel<Real>& from) {
  const bool one_sided = form == ValveForm::kAscending || form == ValveForm::kDescending;
  if (!one_sided || !from.start_known) {
    begin_polish(form, from);
    return;
  }
  form_ = form;
  polishing_ = Polish::kIsPlaced;
  tracked_[0].model = from;
  tracked_[0].start = from.start;
  round_ = 0;
}

// Simpler forms from what a mixed valve became.
template <class Real>
bool ValveSearch<Real>::simpler_job(int job, ValveForm& form,
                                    ValveFriction<Real>& friction) {
  switch (job) {
    case 0:
      form = ValveForm::kSymmetric;
      friction.slip_ascending = friction.slip_descending =
          (friction.slip_ascending + friction.slip_descending) / Real(2);
      return true;
    case 1:
      form = ValveForm::kAscending;
      friction.slip_ascending += friction.deadband;
      friction.deadband = friction.slip_descending = Real(0);
      return true;
    case 2:
      form = ValveForm::kDescending;
      friction.slip_descending += friction.deadband;
      friction.deadband = friction.slip_ascending = Real(0);
      return true;
    default:
      return false;
  }
}

// Sliding valves: each form from its own screening, the mixed valve from what the simpler
// ones became, and these from that one.
template <class Real>
bool ValveSearch<Real>::slide_job(int job, ValveForm& form,
                                  ValveModel<Real>& from) const {
  if (job < 2 * kValveForms) {
    form = static_cast<ValveForm>(job % kValveForms);
    from = beam_[job];
    return true;
  }
  constexpr std::array kSimpler = {ValveForm::kSymmetric, ValveForm::kAscending,
                                   ValveForm::kDescending, ValveForm::kBacklash};
  constexpr int kSimplerForms = static_cast<int>(kSimpler.size());
  const int later = job - 2 * kValveForms;
  form = ValveForm::kMixed;
  if (later >= kSimplerForms) {
    from = best(ValveForm::kMixed);
    return simpler_job(later - kSimplerForms, form, from.friction);
  }
  from = best(kSimpler[later]);
  if (kSimpler[later] == ValveForm::kBacklash) {
    form = ValveForm::kSymmetric;
    from.friction.slip_ascending = from.friction.slip_descending =
        Real(0.3) * from.friction.deadband;
    from.friction.deadband -= from.friction.slip_ascending;
  }
  return true;
}

// Valves with a memory: the mixed valve from the beam, then the simpler forms from it.
template <class Real>
bool ValveSearch<Real>::memory_job(int job, ValveForm& form,
                                   ValveModel<Real>& from) const {
  if (job < kPolished) {
    form = ValveForm::kMixed;
    from = beam_[job];
    return true;
  }
  from = best(ValveForm::kMixed);
  if (nearby_ ? from.friction.motion != motion_
              : from.friction.motion == SlipMotion::kSlides) {
    from = beam_[0];
  }
  return simpler_job(job - kPolished, form, from.friction);
}

// Where the stem of a tracked valve stood: the best of the places that its band allows.
template <class Real>
void ValveSearch<Real>::place(int tracked, Stage then) {
  begin(Trials::kPlaces, then);
  index_ = tracked;
}

// The best of the places, or of valves like the best one: one that slips at the same
// times but moves otherwise has narrower bands and starts elsewhere.
template <class Real>
bool ValveSearch<Real>::try_next() {
  if (round_ == 1 || (round_ > 1 && pass_.model().fit.error < tried_.fit.error)) {
    tried_ = pass_.model();
  }
  const bool places = trials_ != Trials::kNearby;
  if (round_ == (places ? kRestingPlaces : kBands * kStarts)) {
    return true;
  }
  const State& like = tracked_[trials_ == Trials::kPlaces ? index_ : 0];
  ValveModel<Real> model = like.model;
  const int start = places ? round_ : round_ % kStarts;
  if (!places) {
    narrow(model.friction,
           Real(kNarrowest) + Real(kNarrower) * static_cast<Real>(round_ / kStarts));
  }
  const RestingRange<Real> range = resting_range(model.friction, window().u[0]);
  const Real share = (static_cast<Real>(start) - Real(0.5)) / Real(kStarts - 1);
  model.start = start == 0 ? like.start : places ? range.place(start) : range.at(share);
  model.start_known = true;
  pass_.fit(model, places);
  ++round_;
  return false;
}

#define STICKBAND_INSTANTIATE(Real)                                      \
  template void ValveSearch<Real>::begin(Trials, Stage);                 \
  template bool ValveSearch<Real>::next_trial();                         \
  template void ValveSearch<Real>::screen(SlipMotion, Stage);            \
  template void ValveSearch<Real>::polish_tried(Real, Stage);            \
  template void ValveSearch<Real>::polish_all(Trials, int, Real, Stage); \
  template void ValveSearch<Real>::place(int, Stage);
STICKBAND_INSTANTIATE(float)
STICKBAND_INSTANTIATE(double)

}  // namespace ident
