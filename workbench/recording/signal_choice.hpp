// Which columns or tags are u, y, sp, x and loads.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "workbench/recording/named_signal.hpp"
#include "workbench/recording/recording.hpp"

namespace workbench {

/// Names given by the user (--time, --u, ...); "" is not given. A name fits without
/// regard to case, unit, separators, .Value and the like, and without what all columns
/// have in front; some of its pieces are enough where only one column has them. #3 is the
/// third.
struct ColumnNames {
  std::string time;
  std::string u;
  std::string y;
  std::string sp;
  std::string x;
  std::vector<std::string> loads;  ///< "all": every further measured signal

  [[nodiscard]] const std::string& of(Column column) const;
  [[nodiscard]] bool names_signals() const {
    return !(u.empty() && y.empty() && sp.empty() && x.empty());
  }
};

/// What is chosen.
struct PickedSignal {
  Column column = Column::u;    ///< of a load: Column::t
  std::size_t index = 0;        ///< of the candidate
  bool by_elimination = false;  ///< u or y: no other candidate may be it
  [[nodiscard]] bool is_load() const { return column == Column::t; }
};

/// Takes what `names` says; the rest is the one tag prefix that has all of `required`
/// (t aside), the contract's bare names first. sp and x of that prefix come along. MV is
/// u where the prefix has no other, else x. Where blocks of one loop stand apart
/// (FIC101.PIDA.OP, FIC101.DACA.PV), ColumnName::loop counts as prefix.
/// Where no prefix has both, the only candidates that may be u and y are taken
/// (signal_suggestion.hpp). Throws InputError when there is no such prefix or more than
/// one, with what there is and a command line that would do, and std::invalid_argument
/// when a given name fits no candidate or several.
[[nodiscard]] std::vector<PickedSignal> choose_signals(
    const std::vector<NamedSignal>& candidates, const ColumnNames& names,
    const std::vector<Column>& required, const ChoiceContext& context);

/// What to say of u and y that were found by elimination; "": none were.
[[nodiscard]] std::string elimination_note(const std::vector<PickedSignal>& picked,
                                           const std::vector<NamedSignal>& candidates);

}  // namespace workbench
