#include "LabelDrag.h"

#include "CutPattern.h"
#include "CuttingEdits.h"
#include "Document.h"
#include "PatternCut.h"
#include "SnapHints.h"
#include "ViewColors.h"

#include <QCoreApplication>
#include <QFont>
#include <QPainter>

#include <cmath>

namespace bolster {

namespace {

constexpr double labelReach = 7; // pixels, of the middle

/// Around the label of a patch's piece, in pixels; empty without one.
QPolygonF frameOf(const PatternToolContext& context, ElementId id)
{
    const PatternPatch* patch = context.scene().patch(id);
    const CutPiece* piece = patch ? labelledPiece(context.cut(), id) : nullptr;
    return piece ? labelFrame(*piece, *patch, context.transform(), QFont()) : QPolygonF();
}

class LabelDrag : public PatternDrag {
public:
    LabelDrag(PatternToolContext& context, const PatternPointer& from, const PatternPatch& patch,
              const CutPiece& piece)
        : PatternDrag(context, from)
        , m_gesture(context.document())
        , m_patch(patch.patch())
        , m_id(patch.id)
        , m_rotation(piece.label.rotation)
        , m_frame(frameOf(context, patch.id))
        , m_start(context.transform().toLayout(m_frame.boundingRect().center()))
        , m_at(m_start)
        , m_middle(patch.box.center())
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
        m_at = at;
        m_gesture.update(
            edits::setLabel(m_gesture.start(), m_id, PieceLabelPlace{fromLayout(m_patch, at), m_rotation}));
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
        const PatternTransform& transform = m_context.transform();
        painter.drawPolygon(m_frame.translated(transform.toPixels(m_at) - transform.toPixels(m_start)));
    }

private:
    Gesture m_gesture;
    Patch m_patch; ///< at the press
    ElementId m_id;
    double m_rotation;
    QPolygonF m_frame; ///< at the press, pixels
    Vec2 m_start;      ///< of its middle, in the layout
    Vec2 m_at;         ///< the same, now
    Vec2 m_middle;     ///< of the patch, in the layout
    std::vector<SnapHint> m_hints;
};

} // namespace

ElementId labelAt(const PatternToolContext& context, QPointF pixel)
{
    for (const auto& [id, patch] : context.scene().patches())
        if (frameOf(context, id).containsPoint(pixel, Qt::OddEvenFill))
            return id;
    return noElement;
}

void paintLabelFrame(QPainter& painter, const ViewColors& colors, const PatternToolContext& context,
                     ElementId patch)
{
    painter.setPen(QPen(colors.accent, 1, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(frameOf(context, patch));
}

std::unique_ptr<PatternDrag> dragLabel(PatternToolContext& context, const PatternPointer& from, ElementId patch)
{
    const PatternPatch* shown = context.scene().patch(patch);
    const CutPiece* piece = shown ? labelledPiece(context.cut(), patch) : nullptr;
    return piece ? std::make_unique<LabelDrag>(context, from, *shown, *piece) : nullptr;
}

} // namespace bolster
