// Exceptions and sheets that run away, in the user's words.
#pragma once

#include "Design.h"
#include "Message.h"

#include <exception>

namespace bolster {

class Relaxation;

/// What a solve says when it was ended by this exception.
Message failureMessage(const std::exception& error);

struct SolveFailure {
    Message reason;
    ElementId element{}; ///< most likely at fault
};
/// Of a relaxation that has failed. `design`: the one its mesh was made of.
SolveFailure explainFailure(const Relaxation& failed, const Design& design);

} // namespace bolster
