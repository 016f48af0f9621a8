// Surfaces that designs have come to rest in lately, so that undo need not solve again.
#pragma once

#include "SheetState.h"
#include "SolveInput.h"
#include "SolveReport.h"
#include "SurfaceMesh.h"

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>

namespace bolster {

struct RestingSurface {
    SolveInput input;
    SurfaceMeshPtr surface;
    SheetState state; ///< from which a drag goes on
    SolveReport report;
    Problems problems;
    Message reason; ///< when it did not converge
    int iterations = 0;
};
using RestingSurfacePtr = std::shared_ptr<const RestingSurface>;

/// Several solver threads may share one.
class RestingCache {
public:
    /// `most`: bytes; the two surfaces used last are kept however large they are, so that a drag can be cancelled.
    explicit RestingCache(std::size_t most)
        : m_most(most)
    {}

    /// That of a design which differs in nothing that the solver asks for; null: none. It is the last to be
    /// forgotten then.
    RestingSurfacePtr find(const SolveInput& input);
    /// Replaces one of the same design.
    void keep(RestingSurface surface);
    void clear();
    std::size_t count() const;

private:
    RestingSurfacePtr findLocked(const SolveInput& input);

    mutable std::mutex m_mutex;
    std::list<RestingSurfacePtr> m_surfaces; ///< the one used last first
    std::size_t m_most;
};

} // namespace bolster
