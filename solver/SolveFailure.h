// Exceptions in the user's words.
#pragma once

#include "Message.h"

#include <exception>

namespace bolster {

/// What a solve says when it was ended by this exception.
Message failureMessage(const std::exception& error);

} // namespace bolster
