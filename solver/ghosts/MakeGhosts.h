// From the design's elements to soft targets.
#pragma once

#include "FrameFields.h"
#include "Ghosts.h"
#include "Problem.h"
#include "ScanIndex.h"
#include "SolveInput.h"

#include <map>
#include <stop_token>

namespace bolster {

/// Scans ready to be searched, by element, each kept while its points and cuts stay as they are.
class ScanIndexCache {
public:
    /// Null when the scan's file is not there, or when stopped.
    std::shared_ptr<const ScanIndex> index(ElementId id, const Scan& scan, const DesignFiles& files,
                                           const std::stop_token& stop = {});
    void forgetOthers(const Design& design);

private:
    struct Entry {
        std::shared_ptr<const PointCloud> cloud;
        std::vector<ScanCut> cuts;
        std::shared_ptr<const ScanIndex> index;
    };
    std::map<ElementId, Entry> m_entries;
};

/// What is costly to make for ghosts and does not depend on the cover: kept while its element stays as it is.
struct GhostCache {
    FrameFields frames;
    ScanIndexCache scans;
};

/// The sources that the input asks for. Elements whose files are not there are left out; `problems` gets what
/// prevents others. When stopped they are not all there.
Ghosts makeGhosts(const SolveInput& input, const SewnMesh& mesh, GhostCache& cache, Problems& problems,
                  WorkerPool& pool, const std::stop_token& stop = {});

} // namespace bolster
