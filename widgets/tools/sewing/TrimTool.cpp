#include "TrimTool.h"

#include "Document.h"
#include "Selection.h"
#include "StretchPick.h"
#include "Translated.h"
#include "TrimEdits.h"
#include "ViewColors.h"

#include <QCursor>
#include <QPainter>

#include <array>

namespace bolster {

TrimTool::Target TrimTool::targetAt(QPointF pixel) const
{
    const PatternHit hit = m_context.hit(pixel);
    const ElementPtr element = hit ? m_context.document().design().element(hit.element()) : nullptr;
    Target target;
    if (hit.kind == PatternHit::Kind::Outline || hit.kind == PatternHit::Kind::Point)
        target.stretch = stretchUnder(m_context, pixel);
    if (element && seamTrim(*element))
        target.element = hit.element();
    return target;
}

void TrimTool::press(const PatternPointer& pointer)
{
    const Target target = targetAt(pointer.pixel);
    Document& document = m_context.document();
    const Design& design = document.design();
    SeamTrim stitched;
    stitched.stitch = SeamTrim::Stitch::Single;
    if (target.element != noElement) {
        if (!seamTrim(*design.element(target.element))->hasTrimmings())
            document.commit(edits::setTrim(design, std::array{target.element}, stitched));
        m_context.selection().set({target.element});
    } else if (target.stretch) {
        const ElementId added = design.nextId();
        Message problem;
        const Edit edit = edits::addOutlineTrim(design, *target.stretch, stitched, &problem);
        if (edit.empty()) {
            m_context.report(translated(problem));
            return;
        }
        document.commit(edit);
        m_context.selection().set({added});
    } else {
        m_context.report(tr("Click a seam or an edge of an outline."));
    }
    m_context.refresh();
}

void TrimTool::move(const PatternPointer& pointer)
{
    m_hover = targetAt(pointer.pixel);
    m_context.refresh();
}

bool TrimTool::escape()
{
    m_context.endTool();
    return true;
}

void TrimTool::leave()
{
    m_hover = {};
    m_context.refresh();
}

QString TrimTool::prompt() const
{
    if (m_hover.element != noElement)
        return tr("Click to stitch this seam; stitches and piping are in the properties");
    if (m_hover.stretch)
        return tr("Click to stitch this edge; stitches and piping are in the properties");
    return tr("Click a seam or an edge of an outline to stitch it \u2013 Esc ends the tool");
}

QCursor TrimTool::cursor() const
{
    return m_hover.stretch || m_hover.element != noElement ? Qt::PointingHandCursor : Qt::CrossCursor;
}

void TrimTool::paint(QPainter& painter, const ViewColors& colors) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_hover.stretch)
        paintStretch(painter, m_context, *m_hover.stretch, colors.accent);
}

} // namespace bolster
