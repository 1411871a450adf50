// Which physical valve, if any, the data support, and how much it sticks.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "ident/base/limits.hpp"
#include "ident/valve/earlier_valve.hpp"
#include "ident/valve/slip_tracker.hpp"
#include "ident/valve/stick_slip_valve.hpp"
#include "ident/valve/valve_form.hpp"
#include "ident/valve/valve_model.hpp"
#include "ident/valve/valve_pass.hpp"
#include "ident/valve/valve_polish.hpp"

namespace ident {

/// Fits every form of valve on the simulation error.
///
/// A valve that slides on is fitted to the whole window at once: a grid of stick bands,
/// slip shares and time constants is screened, the best of each form polished by pattern
/// search over deadband, slips and two time constants, with gain, dead time, offset,
/// drift and start solved exactly for each trial.
///
/// A valve that stops or resticks remembers where it slipped. A trial that is slightly
/// wrong loses step with the real valve after some cycles and then fits no better than a
/// bad one. So it is fitted to the first cycles only, from many stem positions, and a
/// beam of the best of both motions is polished there. A SlipTracker follows each of it
/// through the whole window, then the best at length, and each of these is tried running
/// free. If none of them explains everything, the best are left again and again, every
/// other time to move as they did not before, until some end alike; these join the beam
/// on the first cycles, which shrinks and is polished again as the window grows, to the
/// end, and are placed once more on the whole window. The one-sided forms of what comes
/// of it have their stems placed anew, since without a deadband they rest elsewhere.
/// Where there is no room for a tracker (limits.hpp), the best kPolished of the beam grow
/// with the window.
///
/// What cannot pay is left out. Where sticking is doubted anyway and no valve that slides
/// on is better than a linear one by a tenth of the squared error, the search ends. Where
/// a valve leaves nothing but white noise
/// (ResidualStructure), a linear one ends the search, and otherwise the next motions are
/// looked for near that valve only; so they are where the best tracked stem is not better
/// by a tenth of the squared error than the best valve so far. Valves that stop are not
/// tracked unless they are that much better on the first cycles.
///
/// Which cycles come first decides where the search of a valve with a memory ends. Where
/// there is room for it, one that leaves little, but more than noise, is therefore looked
/// for once more from later cycles, and what comes of it is placed on the whole window:
/// docs/model.md (T9).
///
/// The search can stop after any piece of a pass and resume: `start`, then `step` until
/// `done`. Memory: one number for each sample of y, the tracker, and a few kilobytes.
/// Bounds: 4,065 screened valves of kTimeConstants passes (over the first cycles for
/// most), 180 rounds of the tracker, 95 polishes of ValvePolish::kEvaluations passes, 9
/// more for each growth of the window, and 1,100 further passes; from later cycles three
/// times as many at most, the valves that slide aside.
template <class Real>
class ValveSearch {
 public:
  struct LeftOut {};
  /// The tracker's stems.
  using Stems =
      std::conditional_t<kSlipTracker, typename SlipTracker<Real>::Stems, LeftOut>;
  /// What is best on the whole window while a part of it is searched.
  struct Elsewhere {
    std::array<ValveModel<Real>, kValveForms> best;
    std::uint32_t from = 0;     ///< sample of y at which the part begins; 0: the whole
    std::uint32_t warm_up = 0;  ///< of the whole
    int parts = 0;              ///< that were searched
  };

  /// Starts on a window; `x` and `scratch` have the length of window.y or more, `stems`
  /// may lie where x lies. All must outlive the search.
  /// `earlier`: a valve of the same loop that is tried too, or none; it must outlive the
  /// search. `u_range`: what u was divided by. `doubted`: no closed-loop evidence speaks
  /// for any stick band. `elsewhere`: room to search parts of the window, which must
  /// outlive the search, or none.
  void start(const SearchWindow<Real>& window, std::span<Real> x, std::span<Real> scratch,
             Stems& stems, const EarlierValve* earlier = nullptr, Real u_range = Real(1),
             bool doubted = false, Elsewhere* elsewhere = nullptr);
  /// Goes on by about `budget` units; true when everything is done.
  bool step(int budget);
  [[nodiscard]] bool done() const { return stage_ == Stage::kDone; }

  /// The best model of a form, after `done`.
  [[nodiscard]] const ValveModel<Real>& best(ValveForm form) const {
    return best_[static_cast<int>(form)];
  }
  /// Whether valves far from the earlier one were looked for.
  [[nodiscard]] bool searched() const { return searched_; }
  /// Free for others when the search is done, on the whole window. Of the search's own,
  /// `window` and `valve_at_start` are meaningful from `start` on.
  [[nodiscard]] ValvePass<Real>& pass() { return pass_; }
  [[nodiscard]] const ValvePass<Real>& pass() const { return pass_; }
  [[nodiscard]] const SearchWindow<Real>& window() const { return pass_.window(); }

 private:
  // `decide` is the search, from top to bottom: when the trials that a stage waits for
  // are over it says what follows, begins the next trials and names the stage after them.
  // Stages stand in the order in which they come.
  enum class Stage : unsigned char {
    kSlidesScreened,
    kSlidesPolished,
    kExplained,
    kRememberingScreened,
    kStopsPolished,
    kCompared,
    kResticksPolished,
    kSiftPlaced,
    kSifted,
    kBestPlaced,
    kBestMeasured,
    kFollowed,
    kFollowedPlaced,
    kFollowedPolished,
    kFollowedExplained,
    kDeparted,
    kPlaced,
    kGrown,
    kPlacedPolished,
    kRemembered,
    kNearbyVaried,
    kNearbyPolished,
    kNearbySimplified,
    kEarlierPlaced,
    kEarlierPolished,
    kLeftExplained,
    kPartBegun,
    kElsewherePlaced,
    kElsewherePolished,
    kDone
  };
  // Passes, or rounds of the tracker, that follow one another without a decision.
  enum class Trials : unsigned char {
    kOne,      // pass
    kScreen,   // the candidates of a motion
    kBeam,     // polishes of its members, on the present cycles
    kJobs,     // polishes of all forms of the present motion, kept
    kPolish,   // of tried_, kept
    kPlaces,   // stem positions of a valve
    kNearby,   // valves like the best one
    kRounds,   // of the tracker
    kMeasured  // by it
  };
  enum class Polish : unsigned char { kNone, kIsPlaced, kBegins, kGoesOn, kIsKept };
  using State = typename SlipTracker<Real>::State;
  // (T6) Squared error over that of the best valve so far on the same cycles, or misfit
  // of the same kind, above which going on does not pay.
  static constexpr double kPromising = 0.9;
  // Random jumps of a polish near the best valve so far, as a share of the swing of u.
  static constexpr double kNearbyJumps = 0.04;
  static constexpr int kTimeConstants = 9;
  static constexpr int kNoTimeConstantYet = -1;
  static constexpr int kPerTimeConstant = kMostScreened;
  static constexpr int kBeam = kPerTimeConstant * kTimeConstants;
  static constexpr int kPolished = 3;          // of the beam, on the whole window
  static constexpr int kGrown = kMostGrown;    // of which this many see more cycles
  static constexpr int kStopping = 4;          // of them, valves that stop
  static constexpr int kTracked = 4;           // this many are tracked at length
  static constexpr int kDepartures = 10;       // then the best are left so many times
  static constexpr int kLeft = 2;              // these in turn
  static constexpr int kAgreeing = 3;          // or until so many agree
  static constexpr int kIntegratingShare = 4;  // of the beam: one place in so many
  static constexpr int kKept = 5;              // and this many stay beside them untracked

  int piece();
  void decide();
  void remember();
  void track();
  void search_nearby(SlipMotion motion);
  void end();
  void try_earlier();
  [[nodiscard]] bool worth_more() const;
  [[nodiscard]] const ValveModel<Real>& best_of_all() const;
  [[nodiscard]] bool linear_does() const;
  [[nodiscard]] bool trusts() const {
    return earlier_ != nullptr && earlier_->trusted > 0;
  }
  [[nodiscard]] ValveModel<Real> earlier_here() const;
  [[nodiscard]] bool does_as_before() const;
  [[nodiscard]] bool may_be_elsewhere() const;
  [[nodiscard]] bool searches_part() const {
    return elsewhere_ != nullptr && elsewhere_->from > 0;
  }
  void search_elsewhere();
  void come_back();
  void use_from(std::size_t from);
  void grow_back(const ValveModel<Real>& found);
  void take_elsewhere();

  // Each begins trials, after which the search is at the stage `then`.
  void begin(Trials trials, Stage then);
  void screen(SlipMotion motion, Stage then);
  void polish_all(Trials trials, int from, Real jumps, Stage then);
  void polish_tried(Real jumps, Stage then);
  void place(int tracked, Stage then);
  void follow(int rounds, Real spread, Stage then);
  bool next_trial();
  bool screen_next();
  void take_screened();
  void begin_job(ValveForm form, const ValveModel<Real>& from);
  void begin_polish(ValveForm form, const ValveModel<Real>& from);
  bool polish_next();
  bool polish_another();
  [[nodiscard]] bool slide_job(int job, ValveForm& form, ValveModel<Real>& from) const;
  [[nodiscard]] static bool simpler_job(int job, ValveForm& form,
                                        ValveFriction<Real>& friction);
  [[nodiscard]] bool memory_job(int job, ValveForm& form, ValveModel<Real>& from) const;
  bool try_next();
  bool follow_next();

  [[nodiscard]] bool alike(const ValveModel<Real>& a, const ValveModel<Real>& b) const;
  void keep_in_beam(int time_constant, const ValveModel<Real>& model);
  void sort_beam();
  void prune_beam(int most);
  void keep_stopping();
  void join_stopping();
  void see_more_cycles();
  void sift();
  void sort_tracked();
  [[nodiscard]] bool promises() const;
  [[nodiscard]] int at_length() const { return std::min(beam_size_, kTracked); }
  void follow_at_length();
  void depart();
  [[nodiscard]] bool settled() const;
  [[nodiscard]] std::size_t whole() const { return window().y.size(); }

  ValvePass<Real> pass_;
  std::span<Real> x_;
  std::span<Real> scratch_;
  Stems* stems_ = nullptr;
  Elsewhere* elsewhere_ = nullptr;
  const EarlierValve* earlier_ = nullptr;  // null once it was tried
  Real u_range_ = 1;
  std::size_t first_used_ = 0;  // samples of y, of the beam, while a tracked one is tried
  std::array<ValveModel<Real>, kValveForms> best_;
  // Of valves that slide, the best of each form that were screened: self-regulating, then
  // integrating.
  std::array<ValveModel<Real>, kBeam> beam_;
  std::array<ProcessPoles<Real>, kTimeConstants> time_constants_;
  std::conditional_t<kSlipTracker, SlipTracker<Real>, LeftOut> tracker_;
  std::array<State, kSlipTracker ? kGrown : kStopping> tracked_;
  ValveModel<Real> tried_;  // the best of the places, or of those nearby
  ValvePolish<Real> polish_;
  Real spread_ = 0;  // of the stick bands in the tracker's bundle
  Real rival_ = 0;   // error of the best valve that does not restick
  Real jumps_ = 0;   // of the polish that begins
  int index_ = 0;  // screened candidate, member of the beam, tracked valve or polish job
  int time_constant_ = kNoTimeConstantYet;  // that the screened candidate comes to
  int beam_size_ = 0;  // members at the front of the beam, once it grows
  int placed_ = 0;     // tracked valves that join the beam
  Stage stage_ = Stage::kDone;
  Trials trials_ = Trials::kOne;
  std::int16_t round_ = 0;  // of the tracker, or of trials from which one is taken
  Polish polishing_ = Polish::kNone;
  ValveForm form_ = ValveForm::kLinear;
  SlipMotion motion_ = SlipMotion::kSlides;
  std::int8_t stopping_ = 0;  // valves that stop, left at the front of tracked_
  bool nearby_ = false;       // this motion is looked for near the best valve only
  bool searched_ = true;      // for others than that one
  bool doubted_ = false;      // no evidence speaks for a stick band
};

}  // namespace ident
