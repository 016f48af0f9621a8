// Lines that run along sharp edges of a form: there it is cut along the edges themselves. Private to the library.
#pragma once

#include "BoxTree.h"
#include "FormLines.h"
#include "LinePlaces.h"

#include <optional>

namespace bolster {

/// Places of a line, one behind the other, mm.
struct LineRun {
    std::vector<Vec3> places;
    bool onEdges = false; ///< on sharp edges, as the ends of runs beside it are
};

/// Edges across which a form bends sharply. Who draws along one means the edge, not what lies a little beside it,
/// now on this side and now on that one.
class SharpEdges {
public:
    explicit SharpEdges(const TriangleSoup& form);

    /// Of a line, which may lie beside the form.
    struct Place {
        Vec3 at, onForm; ///< mm
    };
    /// A line whose places are few mm apart; one run where it nowhere runs along an edge. In a closed one the first
    /// place comes again at the end.
    std::vector<LineRun> runsOf(std::vector<Place> places, bool closed) const;

    /// Of a place that lies by a sharp edge.
    std::optional<Vec3> nearest(const Vec3& at) const;

    /// Makes the edges along a run cuts; false where they do not hang together. A run that ends by a point of the
    /// form ends there afterwards.
    bool cut(TriangleSoup& form, LineRun& run) const;

private:
    using Segment = std::pair<Vec3, Vec3>;

    template <class Visit>
    void eachBeside(const Vec3& at, const Visit& visit) const;
    bool runsAlong(const Vec3& at, const Vec3& direction) const;
    LineRun runOf(const std::vector<Place>& places, std::size_t begin, std::size_t end) const;
    std::set<std::size_t> segmentsBeside(const LineRun& run) const;

    std::vector<Segment> m_segments;
    BoxTree<double> m_boxes; // of those
};

} // namespace bolster
