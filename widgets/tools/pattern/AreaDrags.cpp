// Drags that select what lies in an area of the pattern view.
#include "CurvePath.h"
#include "PatternDrags.h"
#include "Selection.h"
#include "ViewColors.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>

namespace bolster {

namespace {

/// Selects what lies in an area.
class AreaDrag : public PatternDrag {
public:
    using PatternDrag::PatternDrag;

    void update(const PatternPointer& pointer) override { m_to = pointer; }
    void finish() override
    {
        Selection& selection = m_context.selection();
        const bool add = m_to.modifiers & Qt::ShiftModifier;
        Selection::Elements elements = add ? selection.elements() : Selection::Elements();
        Selection::Points points = add ? selection.points() : Selection::Points();
        const auto addPoints = [&](ElementId id, const std::vector<Vec2>& all) {
            if (!selection.contains(id) || !m_context.pointsShown(id))
                return;
            for (std::size_t i = 0; i < all.size(); ++i)
                if (holds(all[i]))
                    points.emplace(id, static_cast<int>(i));
        };
        for (const auto& [id, patch] : m_context.scene().patches())
            if (holds(patch))
                elements.insert(id);
            else
                addPoints(id, patch.points);
        for (const auto& [id, line] : m_context.scene().lines())
            addPoints(id, line.points);
        selection.set(std::move(elements), std::move(points));
    }
    Qt::CursorShape cursor() const override { return Qt::CrossCursor; }

protected:
    virtual bool holds(const Vec2& point) const = 0;
    virtual bool holds(const PatternPatch& patch) const = 0;

    static void fill(QPainter& painter, const ViewColors& colors)
    {
        QColor inside = colors.accent;
        inside.setAlphaF(0.12F);
        painter.setPen(QPen(colors.accent, 1));
        painter.setBrush(inside);
    }

    PatternPointer m_to = m_from;
};

class BoxDrag : public AreaDrag {
public:
    using AreaDrag::AreaDrag;

    QString prompt() const override
    {
        return QCoreApplication::translate(
            "PatternTool", "Release to select what lies in the box \u2013 Shift adds, Esc takes it back");
    }
    void paint(QPainter& painter, const ViewColors& colors) const override
    {
        fill(painter, colors);
        painter.drawRect(QRectF(m_from.pixel, m_to.pixel).normalized());
    }

private:
    bool holds(const Vec2& point) const override { return box().contains(point); }
    bool holds(const PatternPatch& patch) const override { return box().contains(patch.box); }
    Box2 box() const
    {
        Box2 box(m_from.layout);
        box.extend(m_to.layout);
        return box;
    }
};

class LassoDrag : public AreaDrag {
public:
    LassoDrag(PatternToolContext& context, const PatternPointer& from)
        : AreaDrag(context, from)
        , m_line({toPoint(from.layout)})
    {}

    void update(const PatternPointer& pointer) override
    {
        AreaDrag::update(pointer);
        m_line.append(toPoint(pointer.layout));
    }
    QString prompt() const override
    {
        return QCoreApplication::translate(
            "PatternTool", "Release to select what lies in the loop \u2013 Shift adds, Esc takes it back");
    }
    void paint(QPainter& painter, const ViewColors& colors) const override
    {
        fill(painter, colors);
        painter.drawPolygon(m_context.transform().matrix().map(m_line));
    }

private:
    bool holds(const Vec2& point) const override { return m_line.containsPoint(toPoint(point), Qt::OddEvenFill); }
    bool holds(const PatternPatch& patch) const override
    {
        const QPolygonF outline = patch.path.toFillPolygon();
        return !outline.isEmpty() && std::ranges::all_of(outline, [this](const QPointF& point) {
            return m_line.containsPoint(point, Qt::OddEvenFill);
        });
    }

    QPolygonF m_line; ///< in the layout, mm
};

} // namespace

std::unique_ptr<PatternDrag> selectBox(PatternToolContext& context, const PatternPointer& from)
{
    return std::make_unique<BoxDrag>(context, from);
}

std::unique_ptr<PatternDrag> selectLasso(PatternToolContext& context, const PatternPointer& from)
{
    return std::make_unique<LassoDrag>(context, from);
}

} // namespace bolster
