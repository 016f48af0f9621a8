#include "MarkDrag.h"

#include "AllowanceFields.h"
#include "CornerMeasure.h"
#include "CuttingEdits.h"
#include "Document.h"
#include "EditingDrag.h"
#include "LengthExpression.h"
#include "Units.h"

#include <QCoreApplication>

#include <array>
#include <cmath>

namespace bolster {

namespace {

QString markText(const char* words)
{
    return QCoreApplication::translate("MarkDrag", words);
}

class MarkDrag : public EditingDrag {
public:
    MarkDrag(PatternToolContext& context, const PatternPointer& from, ElementId mark, const Patch& patch)
        : EditingDrag(context, from)
        , m_mark(mark)
        , m_patch(patch)
    {}

    Qt::CursorShape cursor() const override { return Qt::SizeAllCursor; }

    QString prompt() const override
    {
        const Design& design = m_context.document().design();
        if (const auto* edge = design.find<EdgeAllowance>(m_mark))
            return markText(
                       QT_TRANSLATE_NOOP(
                           "MarkDrag", "Allowance of %1 \u2013 or type it; Ctrl for any width, Esc takes it back"))
                .arg(lengthText(edge->width));
        if (design.find<DrillHole>(m_mark))
            return markText(QT_TRANSLATE_NOOP(
                "MarkDrag", "Drag it to where it belongs, or type its place: 120, 40 \u2013 Esc takes it back"));
        if (design.find<Notch>(m_mark))
            return markText(QT_TRANSLATE_NOOP("MarkDrag",
                                              "Drag it along the outline, or type how far it is from the "
                                              "corner \u2013 Esc takes it back"));
        return markText(QT_TRANSLATE_NOOP("MarkDrag", "Drag it to where it belongs \u2013 Esc takes it back"));
    }

    void paint(QPainter& painter, const ViewColors& colors) const override
    {
        if (m_at && m_gesture.start().find<Notch>(m_mark))
            paintWayFromCorner(painter, colors, m_context, m_gesture.start().find<Notch>(m_mark)->place.patch,
                               m_patch, *m_at);
        EditingDrag::paint(painter, colors);
    }

private:
    Edit editAt(const PatternPointer& pointer) override
    {
        const Design& start = m_gesture.start();
        const Vec2 at = fromLayout(m_patch, pointer.layout);
        if (const auto* hole = start.find<DrillHole>(m_mark)) {
            const Vec2 dragged = hole->place.position + at - fromLayout(m_patch, m_from.layout);
            const Vec2 to = typedOr(dragged, typedPosition);
            return edits::moveDrillHoles(start, std::array{m_mark}, to - hole->place.position);
        }
        if (const auto* edge = start.find<EdgeAllowance>(m_mark)) {
            const double width = typedOr(widthOutside(at, pointer.modifiers), typedAllowance);
            return edits::setEdgeAllowance(start, edge->stretch, width);
        }
        const BSpline2& outline = m_patch.outline;
        const double dragged = outline.closest(at).parameter;
        m_at = typedOr(dragged, [&](const QString& text) { return typedAlongOutline(outline, dragged, text); });
        return edits::movePlace(start, m_mark, *m_at);
    }

    /// How far outside of the sewing line the pointer is.
    double widthOutside(const Vec2& at, Qt::KeyboardModifiers modifiers) const
    {
        const BSpline2& outline = m_patch.outline;
        const BSpline2::Closest closest = outline.closest(at);
        const Vec2 along = outline.derivative(closest.parameter);
        const bool left = cross(along, at - closest.point) > 0;
        const double width =
            left == (outline.signedArea() > 0) ? 0 : std::min(closest.distance, allowanceWidth.most);
        return modifiers & (Qt::ControlModifier | Qt::AltModifier) ? width : std::round(2 * width) / 2;
    }

    ElementId m_mark;
    Patch m_patch;
    std::optional<double> m_at; ///< of the outline
};

} // namespace

std::optional<Vec2> typedPosition(const QString& text)
{
    const std::optional<Vec3> place = typedPlace(text, 0);
    return place && place->z() == 0 ? std::optional<Vec2>(place->head<2>()) : std::nullopt;
}

std::optional<double> typedAllowance(const QString& text)
{
    const std::optional<double> width = parseLength(text);
    return width && *width >= allowanceWidth.least && *width <= allowanceWidth.most ? width : std::nullopt;
}

std::optional<Edit> typedMark(const Design& design, ElementId mark, const QString& text)
{
    if (const auto* edge = design.find<EdgeAllowance>(mark)) {
        if (const auto width = typedAllowance(text))
            return edits::setEdgeAllowance(design, edge->stretch, *width);
    } else if (const auto* hole = design.find<DrillHole>(mark)) {
        if (const auto at = typedPosition(text))
            return edits::moveDrillHoles(design, std::array{mark}, *at - hole->place.position);
    } else if (const auto* notch = design.find<Notch>(mark)) {
        const Patch* patch = design.find<Patch>(notch->place.patch);
        if (const auto at =
                patch ? typedAlongOutline(patch->outline, notch->place.at, text) : std::optional<double>())
            return edits::movePlace(design, mark, *at);
    }
    return std::nullopt;
}

std::unique_ptr<PatternDrag> dragMark(PatternToolContext& context, const PatternPointer& from, ElementId mark)
{
    const auto found = context.scene().marks().find(mark);
    const PatternPatch* patch =
        found == context.scene().marks().end() ? nullptr : context.scene().patch(found->second.patch);
    return patch ? std::make_unique<MarkDrag>(context, from, mark, patch->patch()) : nullptr;
}

} // namespace bolster
