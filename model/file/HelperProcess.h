// Small programs beside Bolster that meet files of unknown origin, so that whatever these do, they do it there.
#pragma once

#include <QString>

#include <chrono>
#include <cstdint>

class QProcess;

namespace bolster {

/// The program of this installation ("../libexec/bolster" from this program), or that of this build; "" when there
/// is none.
QString helperProgram(const QString& name, const QString& ofThisBuild);

struct HelperLimits {
    std::uint64_t memory = 0;          ///< bytes of address space, libraries included
    std::chrono::seconds processor{0}; ///< of processor time
    bool writesFiles = false;
};

/// Before it is started: the limits, which hold for whatever runs in its place, and an empty environment but for
/// `temporaryFolder`, if there is one.
void confine(QProcess& process, const HelperLimits& limits, const QString& temporaryFolder = {});

} // namespace bolster
