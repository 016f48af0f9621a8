// Projects of older versions of the format.
#pragma once

#include "Message.h"

#include <QString>

#include <cstdint>
#include <functional>
#include <span>

namespace bolster {

class Database;

/// From one version of the format to the next: `change` is called within a transaction.
struct UpgradeStep {
    std::int64_t from = 0;
    std::function<void(Database&)> change;
};

/// Those that this program knows. Version 1 is the first that there was.
std::span<const UpgradeStep> upgradeSteps();

/// The version of the format that a project file says it has, or -1 if it is none.
std::int64_t formatVersionOf(const QString& project);

/// Writes a project of an older version as one of version `to` to a new file, through all steps between; `out` must
/// not be there. The old file is not touched: it stays beside the new one. Returns what went wrong, or an empty
/// message.
Message upgradeProject(const QString& project, const QString& out, std::int64_t to,
                       std::span<const UpgradeStep> steps = upgradeSteps());

} // namespace bolster
