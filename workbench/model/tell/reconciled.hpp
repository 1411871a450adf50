// The verdict on the valve beside the model of the loop.
#pragma once

#include <string>

#include "ident/verdict/identification.hpp"
#include "ident/verdict/verdict.hpp"
#include "workbench/model/base/model.hpp"
#include "workbench/model/search/explain.hpp"

namespace workbench {

/// True where the verdict finds a stem that does not follow u, and the model has none and
/// is not said to lack one: what is left may look like noise, and yet all is not told.
/// `missing` as below.
[[nodiscard]] bool lacks_stem(ident::Verdict verdict, const Model& model,
                              const Candidate* missing);

/// Where the verdict on the valve and the model of the loop seem to contradict each
/// other, one sentence that says how both are meant; else empty. `missing` is what
/// explain() says that the model lacks, null where that is nothing; what is in the model
/// and did not lower its error (harm.hpp) does not count. Plain text.
[[nodiscard]] std::string reconciled(ident::Verdict verdict, const Model& model,
                                     const Candidate* missing);

/// The same of what was found in the recording; that it misleads every model of it,
/// exchanged columns or a seam; or that both find a stem of another stick band.
[[nodiscard]] std::string reconciled(const ident::Identification<double>& found,
                                     const Model& model, const Candidate* missing);

}  // namespace workbench
