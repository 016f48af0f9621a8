// Trees of parts from CAD and modelling programs: STEP, IGES, glTF, FBX, COLLADA and 3MF. Untrusted input:
// processes of their own read them, with limits on memory and time, so that whatever a broken or malicious file
// does to the large libraries for them, it does it there.
#pragma once

#include "Assembly.h"
#include "HelperProcess.h"
#include "ImportWatch.h"
#include "TriangleMesh.h"

#include <functional>
#include <memory>

namespace bolster {

struct ImportedAssembly {
    std::shared_ptr<const Assembly> assembly; ///< null when refused or stopped
    Message problem;                          ///< why, with the file; empty when stopped
    std::vector<Message> warnings{};          ///< what is odd about it, though it was read
    std::string beside{};                     ///< a file of its own folder that belongs to it, if there is one
};

inline constexpr double usualTolerance = 0.2;                     ///< mm
inline constexpr double finestTolerance = 0.01, coarsest = 100.0; ///< mm

struct AssemblyOrder {
    double tolerance = usualTolerance; ///< mm between CAD faces and their triangles
    bool edges = false;                ///< of CAD faces
};

/// The processes that read, and how far they may go before they are killed.
struct AssemblyReaders {
    QString cad = usualCad();
    QString scene = usualScene();
    HelperLimits limits{4'000'000'000, std::chrono::seconds(600), false};
    std::chrono::milliseconds time{900'000};

    /// Of this installation, or of this build; "" when there is none.
    static QString usualCad();
    static QString usualScene();
};

/// The format is that of the file's ending. Parts with triangles have names, no two the same; numbers and axes are
/// those of the file. At most 10 million triangles. Of a .gltf file the .bin files of its own folder are read, too.
/// Takes 0.1 s to minutes: call it on a thread of its own (inBackground); the watch ends it within 0.1 s.
ImportedAssembly importAssembly(const QString& path, const ImportWatch& watch = {}, const AssemblyOrder& order = {},
                                const AssemblyReaders& readers = {});

/// Whether importAssembly reads files with this ending (lower case, without the dot).
bool isAssemblyEnding(const QString& ending);
/// Whether these hold curves, and not only triangles.
bool isCadEnding(const QString& ending);

/// The wanted parts as one mesh: a part each, with its name. Parts without triangles are left out.
TriangleMesh meshOf(const Assembly& assembly, const std::function<bool(std::uint32_t part)>& wanted);

} // namespace bolster
