#include "PatternDrags.h"

#include "Document.h"
#include "EditingDrag.h"
#include "LengthExpression.h"
#include "PatchDrawingTool.h"
#include "PatchEdits.h"
#include "PatchShapeEdits.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "Units.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

QString movedText(bool typing, const Vec2& delta)
{
    if (typing)
        return QCoreApplication::translate("PatternTool", "Enter moves it so far: 50, or 30, 20");
    return QCoreApplication::translate("PatternTool",
                                       "Moved by %1, %2 \u2013 Shift keeps to one axis, Esc takes it back")
        .arg(lengthText(delta.x()), lengthText(delta.y()));
}

class PointDrag : public EditingDrag {
public:
    PointDrag(PatternToolContext& context, const PatternPointer& from, Selection::Points points)
        : EditingDrag(context, from)
        , m_points(std::move(points))
        , m_grabbed(from.layout)
    {
        double nearest = context.transform().millimetres(20);
        for (const auto& [id, index] : m_points)
            if (const auto at = place(id, index); at && (*at - from.layout).norm() < nearest) {
                nearest = (*at - from.layout).norm();
                m_grabbed = *at;
            }
        findNeighbours();
    }

    QString prompt() const override { return movedText(m_typed.open(), m_delta); }
    Qt::CursorShape cursor() const override { return Qt::SizeAllCursor; }

private:
    Edit editAt(const PatternPointer& pointer) override
    {
        m_delta = moved(pointer);
        if (!free(pointer)) {
            PatternPointer grabbed = pointer;
            grabbed.layout = m_grabbed + m_delta;
            SnapQuery query;
            query.ignoredPoints = m_points;
            query.lengthsFrom = m_neighbours;
            Snapped snapped = snappedPointer(m_context, grabbed, query);
            if (!snapped.hints.empty())
                m_delta = snapped.point - m_grabbed;
            m_hints = std::move(snapped.hints);
        }
        m_delta = typedOr(m_delta);
        return movePointsInLayout(m_gesture.start(), m_points, m_delta);
    }

    std::optional<Vec2> place(ElementId id, int index) const
    {
        const auto line = m_context.scene().lines().find(id);
        const PatternPatch* patch = m_context.scene().patch(id);
        const std::vector<Vec2>* points = patch                                     ? &patch->points
                                          : line != m_context.scene().lines().end() ? &line->second.points
                                                                                    : nullptr;
        if (!points || index < 0 || index >= static_cast<int>(points->size()))
            return std::nullopt;
        return (*points)[static_cast<std::size_t>(index)];
    }

    /// Of a single corner of a polygon: its edges can become as long as others.
    void findNeighbours()
    {
        const PatternPatch* patch =
            m_points.size() == 1 ? m_context.scene().patch(m_points.begin()->first) : nullptr;
        if (!patch || patch->patch().outline.degree() != 1)
            return;
        const std::size_t count = patch->points.size();
        const auto index = static_cast<std::size_t>(m_points.begin()->second);
        if (index < count)
            m_neighbours = {patch->points[(index + count - 1) % count], patch->points[(index + 1) % count]};
    }

    Selection::Points m_points;
    std::vector<Vec2> m_neighbours; ///< layout mm
    Vec2 m_grabbed;                 ///< the point under the pointer, layout mm
    Vec2 m_delta = Vec2::Zero();
};

class PatchDrag : public EditingDrag {
public:
    PatchDrag(PatternToolContext& context, const PatternPointer& from)
        : EditingDrag(context, from)
        , m_patches(selectedOf<Patch>(m_gesture.start(), context.selection().elements()))
    {
        for (const ElementId id : m_patches)
            if (const PatternPatch* patch = context.scene().patch(id))
                for (std::size_t i = 0; i < patch->points.size(); ++i)
                    if (patch->corners[i])
                        m_corners.push_back(patch->points[i]);
    }

    QString prompt() const override { return movedText(m_typed.open(), m_delta); }
    Qt::CursorShape cursor() const override { return Qt::ClosedHandCursor; }

private:
    Edit editAt(const PatternPointer& pointer) override
    {
        m_delta = moved(pointer);
        if (!free(pointer)) {
            const Snapper snapper(m_context.scene(), m_context.transform(), m_context.snapSettings());
            Snapped snapped = snapper.snapMove(m_corners, m_delta, {m_patches.begin(), m_patches.end()});
            m_delta = snapped.point;
            m_hints = std::move(snapped.hints);
        }
        m_delta = typedOr(m_delta);
        return edits::movePatches(m_gesture.start(), m_patches, m_delta);
    }

    std::vector<ElementId> m_patches;
    std::vector<Vec2> m_corners; ///< at the press, layout mm
    Vec2 m_delta = Vec2::Zero();
};

class TurnDrag : public EditingDrag {
public:
    TurnDrag(PatternToolContext& context, const PatternPointer& from)
        : EditingDrag(context, from)
        , m_patches(selectedOf<Patch>(m_gesture.start(), context.selection().elements()))
        , m_centre(context.scene().boundingBox({m_patches.begin(), m_patches.end()}).center())
    {}

    QString prompt() const override
    {
        if (m_typed.open())
            return QCoreApplication::translate("PatternTool",
                                               "Enter turns it by this angle, counter-clockwise: 45");
        return QCoreApplication::translate(
                   "PatternTool", "Turned by %1 \u2013 Shift turns in steps of 15\u00b0, Esc takes it back")
            .arg(angleText(m_degrees));
    }
    Qt::CursorShape cursor() const override { return Qt::ClosedHandCursor; }
    void paint(QPainter& painter, const ViewColors& colors) const override
    {
        const QPointF centre = m_context.transform().toPixels(m_centre);
        painter.setPen(QPen(colors.accent, 1, Qt::DashLine));
        painter.drawLine(centre, m_pointer.pixel);
        painter.setBrush(colors.accent);
        painter.drawEllipse(centre, 2.5, 2.5);
        EditingDrag::paint(painter, colors);
    }

private:
    Edit editAt(const PatternPointer& pointer) override
    {
        const Vec2 a = m_from.layout - m_centre;
        const Vec2 b = pointer.layout - m_centre;
        m_degrees = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) * 180 / M_PI;
        if (pointer.modifiers & Qt::ShiftModifier)
            m_degrees = std::round(m_degrees / 15) * 15;
        m_degrees = typedOr(m_degrees, [](QString text) { return parseNumber(text.remove(u'\u00b0')); });
        return edits::turnPatches(m_gesture.start(), m_patches, m_centre, m_degrees);
    }

    std::vector<ElementId> m_patches;
    Vec2 m_centre;
    double m_degrees = 0;
};

class ScaleDrag : public EditingDrag {
public:
    ScaleDrag(PatternToolContext& context, const PatternPointer& from, Box2::CornerType corner)
        : EditingDrag(context, from)
        , m_patches(selectedOf<Patch>(m_gesture.start(), context.selection().elements()))
        , m_box(context.scene().boundingBox({m_patches.begin(), m_patches.end()}))
        , m_corner(m_box.corner(corner))
        , m_anchor(m_box.min() + m_box.max() - m_corner)
    {}

    QString prompt() const override
    {
        if (m_typed.open())
            return QCoreApplication::translate(
                "PatternTool", "Enter makes it this size: 300 x 200, 300 (wide, in proportion), or 120 %");
        const Vec2 size = m_box.sizes().cwiseProduct(m_factors);
        return QCoreApplication::translate(
                   "PatternTool",
                   "Scaled to %1 \u00d7 %2 \u2013 or type the size; Shift keeps the proportions, Esc takes it back")
            .arg(lengthText(size.x()), lengthText(size.y()));
    }
    Qt::CursorShape cursor() const override { return Qt::SizeAllCursor; }

private:
    static constexpr double leastFactor = 0.01;

    Edit editAt(const PatternPointer& pointer) override
    {
        PatternPointer grabbed = pointer;
        grabbed.layout = m_corner + pointer.layout - m_from.layout;
        if (!free(pointer)) {
            SnapQuery query;
            query.ignored = {m_patches.begin(), m_patches.end()};
            Snapped snapped = snappedPointer(m_context, grabbed, query);
            grabbed.layout = snapped.point;
            m_hints = std::move(snapped.hints);
        }
        const Vec2 way = grabbed.layout - m_anchor;
        const Vec2 whole = m_corner - m_anchor;
        m_factors = way.cwiseQuotient(whole).cwiseMax(leastFactor); // mirroring is another operation
        if (pointer.modifiers & Qt::ShiftModifier)
            m_factors.setConstant(std::max(way.dot(whole) / whole.squaredNorm(), leastFactor));
        m_factors = typedOr(m_factors, [this](const QString& text) { return typedFactors(text); });
        return edits::scalePatches(m_gesture.start(), m_patches, m_anchor, m_factors);
    }

    std::optional<Vec2> typedFactors(QString text) const
    {
        std::optional<Vec2> factors;
        if (text.endsWith(u'%')) {
            text.chop(1);
            if (const auto share = parseNumber(text))
                factors = Vec2::Constant(*share / 100);
        } else if (const auto width = parseLength(text)) {
            factors = Vec2::Constant(*width / m_box.sizes().x());
        } else if (const auto size = typedSize(text, Vec2(1, 1))) {
            factors = size->cwiseQuotient(m_box.sizes());
        }
        return factors && factors->minCoeff() >= 1e-3 && factors->maxCoeff() <= 1e3 ? factors : std::nullopt;
    }

    std::vector<ElementId> m_patches;
    Box2 m_box; ///< at the press
    Vec2 m_corner;
    Vec2 m_anchor; ///< the corner that stays
    Vec2 m_factors = Vec2::Ones();
};

} // namespace

std::unique_ptr<PatternDrag> dragPoints(PatternToolContext& context, const PatternPointer& from,
                                        Selection::Points points)
{
    return std::make_unique<PointDrag>(context, from, std::move(points));
}

std::unique_ptr<PatternDrag> dragPatches(PatternToolContext& context, const PatternPointer& from)
{
    return std::make_unique<PatchDrag>(context, from);
}

std::unique_ptr<PatternDrag> turnPatches(PatternToolContext& context, const PatternPointer& from)
{
    return std::make_unique<TurnDrag>(context, from);
}

std::unique_ptr<PatternDrag> scalePatches(PatternToolContext& context, const PatternPointer& from,
                                          Box2::CornerType corner)
{
    return std::make_unique<ScaleDrag>(context, from, corner);
}

} // namespace bolster
