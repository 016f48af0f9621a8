// How the pattern view shows mirror twins: the axis, a mark at patches, exceptions, and where the other point is.
#pragma once

#include "PatternTransform.h"
#include "Symmetry.h"
#include "Twins.h"

#include <QRectF>

#include <map>
#include <optional>
#include <set>

class QPainter;

namespace bolster {

struct PatternPatch;
struct ViewColors;
class PatternScene;

/// What a design says about twins; as seen from both of them.
struct PatternTwins {
    std::optional<Symmetry> symmetry;
    std::map<ElementId, ElementId> others;
    std::map<ElementId, std::set<int>> released;

    static PatternTwins of(const Design& design);

    bool has(ElementId id) const { return others.contains(id); }
    bool isReleased(ElementId id, int point) const;
    /// Where the point of the other one is that moves along with this one, in layout mm.
    std::optional<Vec2> follower(const PatternScene& scene, ElementId id, int point) const;
};

/// A dash-dotted line through the whole view.
void paintSymmetryAxis(QPainter& painter, const Symmetry& symmetry, const PatternTransform& transform,
                       const QSizeF& size, const ViewColors& colors);
/// Two wings at a line, above what is written in the patch; with a dot when there are exceptions.
void paintTwinMark(QPainter& painter, QPointF at, bool exceptions, const QColor& color);
/// A dashed ring around a hollow diamond: a released point.
void paintReleasedPoint(QPainter& painter, QPointF at, double size);
/// A ring around a point that moves along.
void paintFollower(QPainter& painter, QPointF at, const ViewColors& colors);

} // namespace bolster
