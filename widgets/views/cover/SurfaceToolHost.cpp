#include "SurfaceToolHost.h"

#include "Document.h"
#include "PointerNote.h"
#include "ScanCutTool.h"
#include "SectionHandle.h"
#include "Selection.h"
#include "ShownScene.h"

#include <QKeyEvent>
#include <QMouseEvent>

namespace bolster {

SurfaceToolHost::SurfaceToolHost(Document& document, Selection& selection, ShownScene& shown, const Camera& camera,
                                 const SectionHandle& section, QWidget& view)
    : ToolHostOf(document, selection, view, &makeSurfaceTool)
    , m_shown(shown)
    , m_camera(camera)
    , m_section(section)
    , m_note(new PointerNote(&view))
{}

void SurfaceToolHost::startScanCut(ElementId scan, bool keep)
{
    setTool(SurfaceToolKind::CutScan);
    replaceTool(std::make_unique<ScanCutTool>(static_cast<SurfaceToolContext&>(*this), scan, keep));
}

QString SurfaceToolHost::prompt() const
{
    return m_section.hovering() ? m_section.prompt() : tool().prompt();
}

QCursor SurfaceToolHost::cursor() const
{
    return m_section.hovering() ? QCursor(Qt::SizeAllCursor) : tool().cursor();
}

void SurfaceToolHost::refresh()
{
    announce();
    m_view.setCursor(cursor());
    m_note->showNote(tool().note());
    const auto hovered = tool().hoveredPoint();
    const bool guided = !tool().guides().empty();
    if (hovered != m_hoveredPoint || guided || m_guided) {
        m_hoveredPoint = hovered;
        m_guided = guided;
        m_shown.setHoveredPoint(hovered);
        m_shown.refreshMarks(m_document.gestureRunning());
    }
}

bool SurfaceToolHost::takesShortcut(const QKeyEvent& event)
{
    if (tool().wants(event.key()) || (m_section.dragging() && event.key() == Qt::Key_Escape))
        return true;
    if (!m_document.gestureRunning())
        return false;
    const bool nudges = event.key() >= Qt::Key_Left && event.key() <= Qt::Key_PageDown;
    if (!nudges && event.key() != Qt::Key_Shift)
        m_document.finishGesture(); // other keys mean what they always do
    if (!m_document.gestureRunning())
        return false;
    // During a drag these belong to the tool, whatever the menus say.
    const bool command = event.modifiers() & (Qt::ControlModifier | Qt::MetaModifier | Qt::AltModifier);
    const int key = command ? 0 : event.key();
    return key == Qt::Key_Escape || key == Qt::Key_S || key == Qt::Key_X || key == Qt::Key_Y || key == Qt::Key_Z;
}

void SurfaceToolHost::rightClick(const QMouseEvent& event)
{
    if (m_document.gestureRunning())
        return;
    const SurfaceHit found = kind() == SurfaceToolKind::Select ? hit(event.position()) : SurfaceHit();
    if (found.kind == SurfaceHit::Kind::Point) {
        if (const Selection::Point point{found.element, found.point}; !m_selection.contains(point))
            m_selection.set({found.element}, {point});
    } else if (found && !m_selection.contains(found.element)) {
        m_selection.set({found.element});
    }
    askForMenu(event.globalPosition().toPoint(), bool(found));
}

void SurfaceToolHost::menuKey()
{
    if (!m_document.gestureRunning())
        askForMenu(m_view.mapToGlobal(m_view.rect().center()),
                   kind() == SurfaceToolKind::Select && !m_selection.elements().empty());
}

SurfaceHit SurfaceToolHost::hit(QPointF pixel) const
{
    return m_shown.hit(m_camera, pixel);
}

const ViewColors& SurfaceToolHost::colors() const
{
    return m_shown.scene().colors;
}

SurfaceHit SurfaceToolHost::ground(QPointF pixel) const
{
    return m_shown.hits().hitGround(m_camera, pixel);
}

std::optional<SurfaceFoot> SurfaceToolHost::nearest(const Vec3& point, SurfaceHit::Kind on) const
{
    return m_shown.hits().nearest(point, on);
}

Vec3 SurfaceToolHost::middleOf(ElementId id) const
{
    return m_shown.middleOf(id);
}

} // namespace bolster
