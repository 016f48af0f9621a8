// Something wrong with one element of a design: bad input is data, not an accident.
#pragma once

#include "ElementId.h"
#include "Message.h"

#include <vector>

namespace bolster {

enum class Severity { Warning, Error };

/// `element` is the element as the file numbers it (settingsId when the whole design is meant), `field` the
/// key in the text form, with dots and brackets ("outline.points[3]"), `label` a name for the element that
/// a person recognises ("patch 2 \"Seat\"").
struct Problem {
    ElementId element = settingsId;
    std::string label;
    std::string field;
    Message message;
    Severity severity = Severity::Error;

    /// "patch 2 "Seat", outline.points: the outline crosses itself ..."
    std::string english() const;

    friend bool operator==(const Problem&, const Problem&) = default;
};

using Problems = std::vector<Problem>;

/// Appends those that are not there yet, each once.
void addNew(Problems& problems, const Problems& more);

bool hasErrors(const Problems& problems);

} // namespace bolster
