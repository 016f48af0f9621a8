// From a design to a mesh that can be optimised.
#pragma once

#include "OutlineSampling.h"
#include "PatchTriangulator.h"
#include "SewnMesh.h"
#include "SolveInput.h"

#include <map>
#include <optional>
#include <stop_token>

namespace bolster {

/// Triangulations by patch, kept while a patch's outline samples and inner lines stay as they are.
class TriangulationCache {
public:
    /// Those that have changed. When stopped some are missing.
    void triangulate(const std::vector<OutlineSampling::Outline>& outlines, double edgeLength, WorkerPool& pool,
                     const std::stop_token& stop = {});
    const PatchMesh& mesh(ElementId patch) const { return m_entries.at(patch).mesh; }
    void forgetOthers(const OutlineSampling& sampling);

private:
    struct Entry {
        std::vector<Vec2> boundary;
        std::vector<InnerLine> lines;
        double edgeLength = 0;
        PatchMesh mesh;
    };
    std::map<ElementId, Entry> m_entries;
};

struct PreparedSheet {
    Design design; ///< the part that can be used
    DesignFiles files;
    OutlineSampling sampling;
    SewnMesh mesh;
    Problems errors; ///< what is wrong with the input
    Problems warnings;
    Problems leftOut;           ///< elements that are not in `design`, with the reason
    double triangulateTime = 0; ///< ms
    double assembleTime = 0;    ///< ms
};

/// Checks, samples, triangulates and sews; bad elements are left out and named. Nothing when stopped.
std::optional<PreparedSheet> prepareSheet(const SolveInput& input, TriangulationCache& cache, WorkerPool& pool,
                                          const std::stop_token& stop = {});
/// The same with edges of another length, mm.
SolveInput withEdgeLength(const SolveInput& input, double length);
/// On one thread.
std::optional<PreparedSheet> prepareSheet(const SolveInput& input, TriangulationCache& cache);

} // namespace bolster
