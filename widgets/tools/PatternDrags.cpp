#include "PatternDrags.h"

#include "Document.h"
#include "PatchEdits.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "Units.h"
#include "ViewColors.h"

#include <QCoreApplication>
#include <QPainter>

#include <cmath>

namespace bolster {

Vec2 PatternDrag::moved(const PatternPointer& pointer) const
{
    Vec2 delta = pointer.layout - m_from.layout;
    if (pointer.modifiers & Qt::ShiftModifier)
        (std::abs(delta.x()) < std::abs(delta.y()) ? delta.x() : delta.y()) = 0;
    return delta;
}

namespace {

/// A drag that changes the design.
class EditingDrag : public PatternDrag {
public:
    EditingDrag(PatternToolContext& context, const PatternPointer& from)
        : PatternDrag(context, from)
        , m_gesture(context.document())
    {}

    void finish() override { m_gesture.commit(); }
    bool active() const override { return m_gesture.active(); }

protected:
    static QString shift(const Vec2& delta)
    {
        return QCoreApplication::translate("PatternTool",
                                           "Moved by %1, %2 \u2013 Shift keeps to one axis, Esc takes it back")
            .arg(lengthText(delta.x()), lengthText(delta.y()));
    }

    Gesture m_gesture;
};

class PointDrag : public EditingDrag {
public:
    PointDrag(PatternToolContext& context, const PatternPointer& from, Selection::Points points)
        : EditingDrag(context, from)
        , m_points(std::move(points))
    {}

    void update(const PatternPointer& pointer) override
    {
        m_delta = moved(pointer);
        m_gesture.update(movePointsInLayout(m_gesture.start(), m_points, m_delta));
    }
    QString prompt() const override { return shift(m_delta); }
    Qt::CursorShape cursor() const override { return Qt::SizeAllCursor; }

private:
    Selection::Points m_points;
    Vec2 m_delta = Vec2::Zero();
};

class PatchDrag : public EditingDrag {
public:
    PatchDrag(PatternToolContext& context, const PatternPointer& from)
        : EditingDrag(context, from)
        , m_patches(selectedOf<Patch>(m_gesture.start(), context.selection().elements()))
    {}

    void update(const PatternPointer& pointer) override
    {
        m_delta = moved(pointer);
        m_gesture.update(edits::movePatches(m_gesture.start(), m_patches, m_delta));
    }
    QString prompt() const override { return shift(m_delta); }
    Qt::CursorShape cursor() const override { return Qt::ClosedHandCursor; }

private:
    std::vector<ElementId> m_patches;
    Vec2 m_delta = Vec2::Zero();
};

class TurnDrag : public EditingDrag {
public:
    TurnDrag(PatternToolContext& context, const PatternPointer& from)
        : EditingDrag(context, from)
        , m_patches(selectedOf<Patch>(m_gesture.start(), context.selection().elements()))
        , m_centre(context.scene().boundingBox({m_patches.begin(), m_patches.end()}).center())
    {}

    void update(const PatternPointer& pointer) override
    {
        const Vec2 a = m_from.layout - m_centre;
        const Vec2 b = pointer.layout - m_centre;
        m_degrees = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) * 180 / M_PI;
        if (pointer.modifiers & Qt::ShiftModifier)
            m_degrees = std::round(m_degrees / 15) * 15;
        m_pointer = pointer.pixel;
        m_gesture.update(edits::turnPatches(m_gesture.start(), m_patches, m_centre, m_degrees));
    }
    QString prompt() const override
    {
        return QCoreApplication::translate(
                   "PatternTool", "Turned by %1 \u2013 Shift turns in steps of 15\u00b0, Esc takes it back")
            .arg(angleText(m_degrees));
    }
    Qt::CursorShape cursor() const override { return Qt::ClosedHandCursor; }
    void paint(QPainter& painter, const ViewColors& colors) const override
    {
        const QPointF centre = m_context.transform().toPixels(m_centre);
        painter.setPen(QPen(colors.accent, 1, Qt::DashLine));
        painter.drawLine(centre, m_pointer);
        painter.setBrush(colors.accent);
        painter.drawEllipse(centre, 2.5, 2.5);
    }

private:
    std::vector<ElementId> m_patches;
    Vec2 m_centre;
    double m_degrees = 0;
    QPointF m_pointer;
};

class BoxDrag : public PatternDrag {
public:
    using PatternDrag::PatternDrag;

    void update(const PatternPointer& pointer) override { m_to = pointer; }
    void finish() override
    {
        Box2 box(m_from.layout);
        box.extend(m_to.layout);
        Selection& selection = m_context.selection();
        const bool add = m_to.modifiers & Qt::ShiftModifier;
        Selection::Elements elements = add ? selection.elements() : Selection::Elements();
        Selection::Points points = add ? selection.points() : Selection::Points();
        for (const auto& [id, patch] : m_context.scene().patches()) {
            if (box.contains(patch.box)) {
                elements.insert(id);
            } else if (selection.contains(id) && m_context.pointsShown(id)) {
                for (std::size_t i = 0; i < patch.points.size(); ++i)
                    if (box.contains(patch.points[i]))
                        points.emplace(id, static_cast<int>(i));
            }
        }
        for (const auto& [id, line] : m_context.scene().lines())
            if (selection.contains(id) && m_context.pointsShown(id))
                for (std::size_t i = 0; i < line.points.size(); ++i)
                    if (box.contains(line.points[i]))
                        points.emplace(id, static_cast<int>(i));
        selection.set(std::move(elements), std::move(points));
    }
    QString prompt() const override
    {
        return QCoreApplication::translate(
            "PatternTool", "Release to select what lies in the box \u2013 Shift adds, Esc takes it back");
    }
    Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
    void paint(QPainter& painter, const ViewColors& colors) const override
    {
        QColor inside = colors.accent;
        inside.setAlphaF(0.12F);
        painter.setPen(QPen(colors.accent, 1));
        painter.setBrush(inside);
        painter.drawRect(QRectF(m_from.pixel, m_to.pixel).normalized());
    }

private:
    PatternPointer m_to = m_from;
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

std::unique_ptr<PatternDrag> selectBox(PatternToolContext& context, const PatternPointer& from)
{
    return std::make_unique<BoxDrag>(context, from);
}

} // namespace bolster
