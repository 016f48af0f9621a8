#include "DartDrag.h"

#include "CornerMeasure.h"
#include "DartPicture.h"
#include "Document.h"
#include "EditingDrag.h"
#include "LengthExpression.h"
#include "Selection.h"
#include "Translated.h"
#include "ViewColors.h"

#include <QCoreApplication>
#include <QPainter>

#include <cmath>

namespace bolster {

namespace {

// Pixels.
constexpr double dartHandleSize = 6;
constexpr double dartHandleReach = 8;

QString dragText(const char* words)
{
    return QCoreApplication::translate("DartDrag", words);
}

bool hasTipAt(const Design& design, ElementId seam, const Selection::Point& point)
{
    const auto dart = edits::dartOf(design, seam);
    if (!dart || dart->patch != point.first)
        return false;
    const auto& points = design.find<Patch>(dart->patch)->outline.points();
    const auto index = static_cast<std::size_t>(point.second);
    return point.second >= 0 && index < points.size() && (points[index] - dart->tip).norm() < 1e-6;
}

/// Where the handles of the selected dart lie, in the layout.
std::optional<Vec2> handlePlace(PatternToolContext& context, DartHandle handle)
{
    const Design& design = context.document().design();
    const auto dart = edits::dartOf(design, selectedDart(design, context.selection()));
    if (!dart)
        return std::nullopt;
    const Patch& patch = *design.find<Patch>(dart->patch);
    const Vec2 at = handle == DartHandle::Tip ? dart->tip : edits::dartAxis(patch.outline, *dart).middle;
    return toLayout(patch, at);
}

class DartDrag : public EditingDrag {
public:
    DartDrag(PatternToolContext& context, const PatternPointer& from, ElementId seam, DartHandle handle)
        : EditingDrag(context, from)
        , m_seam(seam)
        , m_handle(handle)
        , m_dart(*edits::dartOf(m_gesture.start(), seam))
        , m_patch(*m_gesture.start().find<Patch>(m_dart.patch))
        , m_closed(m_patch)
    {
        const Vec2 at = handle == DartHandle::Tip ? m_dart.tip : edits::dartAxis(m_patch.outline, m_dart).middle;
        m_grabbed = at - fromLayout(m_patch, from.layout);
        const Edit closed = edits::removeDart(m_gesture.start(), seam);
        if (!closed.empty())
            m_closed = *m_gesture.start().with(closed).find<Patch>(m_dart.patch);
        m_shown = m_dart;
    }

    Qt::CursorShape cursor() const override { return Qt::SizeAllCursor; }

    QString prompt() const override
    {
        if (!m_problem.empty())
            return translated(m_problem);
        return m_handle == DartHandle::Tip
                   ? dragText(QT_TRANSLATE_NOOP(
                         "DartDrag", "Near the dotted line both legs become of one length, or type how deep "
                                     "it is \u2013 Shift keeps to it, Ctrl lets go, Esc takes it back"))
                   : dragText(QT_TRANSLATE_NOOP(
                         "DartDrag", "Drag the dart along the outline, or type how far its middle is from "
                                     "the corner \u2013 Esc takes it back"));
    }

    void paint(QPainter& painter, const ViewColors& colors) const override
    {
        const Patch* now = m_context.document().design().find<Patch>(m_dart.patch);
        if (!now || now->outline.empty())
            return;
        painter.setRenderHint(QPainter::Antialiasing);
        paintDart(painter, colors, m_context, *now, m_shown, m_problem.empty(), m_handle == DartHandle::Tip);
        if (m_handle == DartHandle::Mouth && m_middle)
            paintWayFromCorner(painter, colors, m_context, m_dart.patch, m_closed, *m_middle);
        EditingDrag::paint(painter, colors);
    }

private:
    /// Where it cannot be, it stays where it could.
    Edit editAt(const PatternPointer& pointer) override
    {
        const Vec2 at = fromLayout(m_patch, pointer.layout) + m_grabbed;
        m_problem = {};
        const Edit edit = m_handle == DartHandle::Tip ? tipEdit(at, pointer.modifiers) : mouthEdit(at);
        if (!edit.empty())
            m_possible = edit;
        m_typedGood = m_typedGood && m_problem.empty();
        if (const auto now = edits::dartOf(m_gesture.start().with(m_possible), m_seam); now && m_problem.empty())
            m_shown = *now;
        return m_possible;
    }

    /// So deep as is typed, both legs of one length.
    Edit tipEdit(const Vec2& at, Qt::KeyboardModifiers modifiers)
    {
        edits::DartShape wanted = m_dart;
        wanted.tip = at;
        if (!(modifiers & (Qt::ControlModifier | Qt::AltModifier)))
            wanted.tip = snappedTip(m_context, m_patch, wanted, modifiers & Qt::ShiftModifier);
        wanted.tip = typedOr(wanted.tip, [&](const QString& text) -> std::optional<Vec2> {
            const edits::DartAxis axis = edits::dartAxis(m_patch.outline, m_dart);
            const std::optional<double> depth = parseLength(text);
            if (!depth || !(*depth > 0))
                return std::nullopt;
            return Vec2(axis.middle + *depth * axis.inwards);
        });
        m_shown = wanted;
        return edits::moveDartTip(m_gesture.start(), m_seam, wanted.tip, &m_problem);
    }

    Edit mouthEdit(const Vec2& at)
    {
        const double dragged = m_closed.outline.closest(at).parameter;
        m_middle = typedOr(dragged,
                           [&](const QString& text) { return typedAlongOutline(m_closed.outline, dragged, text); });
        return edits::moveDart(m_gesture.start(), m_seam, *m_middle, &m_problem);
    }

    ElementId m_seam;
    DartHandle m_handle;
    edits::DartShape m_dart; ///< at the press
    Patch m_patch;
    Patch m_closed; ///< without the dart
    Vec2 m_grabbed = Vec2::Zero();
    edits::DartShape m_shown;
    Edit m_possible;                ///< the last one that could be
    std::optional<double> m_middle; ///< of the mouth, on the outline without the dart
    Message m_problem;
};

} // namespace

ElementId selectedDart(const Design& design, const Selection& selection)
{
    if (selection.points().size() == 1) {
        ElementId found = noElement;
        design.each<Seam>([&](ElementId id, const Seam& seam) {
            if (seam.a.patch == seam.b.patch && hasTipAt(design, id, *selection.points().begin()))
                found = id;
        });
        return found;
    }
    const bool alone = selection.elements().size() == 1 && selection.points().empty();
    return alone && edits::dartOf(design, *selection.elements().begin()) ? *selection.elements().begin()
                                                                         : noElement;
}

std::optional<DartHandle> dartHandleAt(PatternToolContext& context, QPointF pixel)
{
    for (const DartHandle handle : {DartHandle::Tip, DartHandle::Mouth})
        if (const auto place = handlePlace(context, handle)) {
            const QPointF way = pixel - context.transform().toPixels(*place);
            if (std::hypot(way.x(), way.y()) < dartHandleReach)
                return handle;
        }
    return std::nullopt;
}

void paintDartHandles(QPainter& painter, const ViewColors& colors, PatternToolContext& context,
                      std::optional<DartHandle> over)
{
    painter.setPen(QPen(colors.accent, 1.6));
    for (const DartHandle handle : {DartHandle::Tip, DartHandle::Mouth})
        if (const auto place = handlePlace(context, handle)) {
            const QPointF at = context.transform().toPixels(*place);
            painter.setBrush(over == handle ? colors.accent : colors.pointFill);
            const double size = dartHandleSize;
            if (handle == DartHandle::Tip)
                painter.drawEllipse(at, size - 1, size - 1);
            else
                painter.drawPolygon(QPolygonF{at + QPointF(0, -size), at + QPointF(size, 0), at + QPointF(0, size),
                                              at + QPointF(-size, 0)});
        }
}

std::unique_ptr<PatternDrag> dragDart(PatternToolContext& context, const PatternPointer& from, DartHandle handle)
{
    const ElementId seam = selectedDart(context.document().design(), context.selection());
    return seam == noElement ? nullptr : std::make_unique<DartDrag>(context, from, seam, handle);
}

} // namespace bolster
