#include "SolveFailure.h"

#include <new>

namespace bolster {

Message failureMessage(const std::exception& error)
{
    if (dynamic_cast<const std::bad_alloc*>(&error))
        return {QT_TRANSLATE_NOOP("Message",
                                  "There is not enough memory for this surface. Choose a larger edge length."),
                {}};
    return {QT_TRANSLATE_NOOP("Message", "The solver failed: %1. The last good surface is kept."), {error.what()}};
}

} // namespace bolster
