// A form that a cover is held against: a scan of the design, or a file.
#pragma once

#include "FitGoals.h"
#include "Message.h"
#include "PointCloud.h"

#include <QString>

#include <memory>
#include <optional>
#include <stop_token>

namespace bolster {

/// One of these, or nothing.
struct FitForm {
    std::optional<Scan> scan;
    std::shared_ptr<const PointCloud> cloud;
    QString file; ///< a mesh or points, as they lie in the design; in mm, where they say nothing else

    bool empty() const { return !cloud && file.isEmpty(); }
};

/// False, and why, when it cannot be read. May take its time. Of no form an empty target.
bool readTarget(const FitForm& form, FitTarget& target, Message& problem, const std::stop_token& stop);

} // namespace bolster
