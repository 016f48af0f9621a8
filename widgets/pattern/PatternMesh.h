// The triangulation of the patches as lines to draw.
#pragma once

#include "PatternTransform.h"
#include "SurfaceEdges.h"

#include <QLineF>
#include <QVector>

#include <map>

namespace bolster {

struct Patch;

/// Each edge once; found anew only when the topology changes.
class PatternMesh {
public:
    void setTopology(std::shared_ptr<const SurfaceTopology> topology);
    bool empty() const { return !m_topology; }
    /// Mean length of the edges, mm.
    double edgeLength() const { return m_edgeLength; }
    /// The edges of one patch in pixels, placed where the patch lies now.
    QVector<QLineF> lines(ElementId id, const Patch& patch, const PatternTransform& transform) const;

private:
    struct PatchEdges {
        SurfaceTopology::PatchRange range;
        std::vector<SurfaceEdge> edges;
    };

    std::shared_ptr<const SurfaceTopology> m_topology;
    std::map<ElementId, PatchEdges> m_patches;
    double m_edgeLength = 0;
};

} // namespace bolster
