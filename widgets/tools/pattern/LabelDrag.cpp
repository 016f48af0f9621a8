#include "LabelDrag.h"

#include "CutPattern.h"
#include "CuttingEdits.h"
#include "Document.h"
#include "PatternCut.h"
#include "SnapHints.h"
#include "ViewColors.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr double labelReach = 7; // pixels, of the middle

const PieceLabel* labelOf(const PatternToolContext& context, ElementId patch)
{
    return context.scene().patch(patch) ? readableLabel(context.cut(), patch, context.transform()) : nullptr;
}

/// Around its lines, in pixels.
QPolygonF labelFrame(const PatternToolContext& context, const Patch& patch, const PieceLabel& label)
{
    const double height = label.height * static_cast<double>(label.lines.size());
    const Eigen::Rotation2Dd turn(label.rotation * std::numbers::pi / 180);
    QPolygonF frame;
    for (const auto& [x, y] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
        const Vec2 corner = label.at + turn * Vec2(x * (label.width + label.height), y * (height + label.height));
        frame << context.transform().toPixels(toLayout(patch, corner));
    }
    return frame;
}

class LabelDrag : public PatternDrag {
public:
    LabelDrag(PatternToolContext& context, const PatternPointer& from, const Patch& patch, ElementId id,
              PieceLabel label)
        : PatternDrag(context, from)
        , m_gesture(context.document())
        , m_patch(patch)
        , m_id(id)
        , m_label(std::move(label))
        , m_start(toLayout(patch, m_label.at))
        , m_middle(context.scene().patch(id)->box.center())
    {}

    void update(const PatternPointer& pointer) override
    {
        Vec2 at = m_start + moved(pointer);
        m_hints.clear();
        if (!(pointer.modifiers & (Qt::ControlModifier | Qt::AltModifier)))
            for (const int axis : {0, 1})
                if (std::abs(at[axis] - m_middle[axis]) < m_context.transform().millimetres(labelReach)) {
                    at[axis] = m_middle[axis];
                    m_hints.push_back({SnapHint::Kind::Alignment, m_middle, at});
                }
        for (SnapHint& hint : m_hints)
            hint.to = at; // both ways
        m_label.at = fromLayout(m_patch, at);
        m_gesture.update(edits::setLabel(m_gesture.start(), m_id, PieceLabelPlace{m_label.at, m_label.rotation}));
    }
    void finish() override { m_gesture.commit(); }
    bool active() const override { return m_gesture.active(); }
    Qt::CursorShape cursor() const override { return Qt::ClosedHandCursor; }

    QString prompt() const override
    {
        return QCoreApplication::translate("LabelDrag",
                                           "Drag the label to where it can be read \u2013 Shift keeps to "
                                           "one axis, Ctrl does not snap, Esc takes it back");
    }

    void paint(QPainter& painter, const ViewColors& colors) const override
    {
        paintSnapHints(painter, colors, m_context.transform(), m_hints);
        painter.setPen(QPen(colors.accent, 1.4));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolygon(labelFrame(m_context, m_patch, m_label));
    }

private:
    Gesture m_gesture;
    Patch m_patch; ///< at the press
    ElementId m_id;
    PieceLabel m_label;
    Vec2 m_start;  ///< of its middle, in the layout
    Vec2 m_middle; ///< of the patch, in the layout
    std::vector<SnapHint> m_hints;
};

} // namespace

ElementId labelAt(const PatternToolContext& context, QPointF pixel)
{
    for (const auto& [id, patch] : context.scene().patches())
        if (const PieceLabel* label = labelOf(context, id);
            label && labelFrame(context, patch.patch(), *label).containsPoint(pixel, Qt::OddEvenFill))
            return id;
    return noElement;
}

void paintLabelFrame(QPainter& painter, const ViewColors& colors, const PatternToolContext& context,
                     ElementId patch)
{
    if (const PieceLabel* label = labelOf(context, patch)) {
        painter.setPen(QPen(colors.accent, 1, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolygon(labelFrame(context, context.scene().patch(patch)->patch(), *label));
    }
}

std::unique_ptr<PatternDrag> dragLabel(PatternToolContext& context, const PatternPointer& from, ElementId patch)
{
    const PieceLabel* label = labelOf(context, patch);
    return label ? std::make_unique<LabelDrag>(context, from, context.scene().patch(patch)->patch(), patch, *label)
                 : nullptr;
}

} // namespace bolster
