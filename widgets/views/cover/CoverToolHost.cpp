#include "CoverToolHost.h"

#include "CoverMeasures.h"
#include "Document.h"
#include "PointerNote.h"
#include "ScanCutTool.h"
#include "SectionHandle.h"
#include "Selection.h"
#include "ShownScene.h"

#include <QKeyEvent>
#include <QMouseEvent>

namespace bolster {

CoverToolHost::CoverToolHost(Document& document, Selection& selection, ShownScene& shown, const Camera& camera,
                             const SectionHandle& section, const CoverMeasures& measures, QWidget& view)
    : ToolHostOf(document, selection, view, &makeSurfaceTool)
    , m_shown(shown)
    , m_camera(camera)
    , m_section(section)
    , m_measures(measures)
    , m_note(new PointerNote(&view))
{}

void CoverToolHost::startScanCut(ElementId scan, bool keep)
{
    setTool(CoverToolKind::CutScan);
    replaceTool(std::make_unique<ScanCutTool>(static_cast<CoverToolContext&>(*this), scan, keep));
}

void CoverToolHost::startScanAlign(ElementId scan, ScanAlignTool::Done done, std::vector<ScanMark> marks)
{
    setTool(CoverToolKind::AlignScan);
    replaceTool(std::make_unique<ScanAlignTool>(static_cast<CoverToolContext&>(*this), scan, std::move(done),
                                                std::move(marks)));
}

void CoverToolHost::startFrameEdges(OfferedEdgesPtr edges)
{
    setTool(CoverToolKind::FixEdge);
    replaceTool(std::make_unique<FrameEdgeTool>(static_cast<CoverToolContext&>(*this), std::move(edges)));
}

void CoverToolHost::startAreaBrush(double radius, AreaBrushTool::Take take)
{
    setTool(CoverToolKind::PaintArea);
    replaceTool(std::make_unique<AreaBrushTool>(static_cast<CoverToolContext&>(*this), radius, std::move(take)));
}

QString CoverToolHost::prompt() const
{
    return m_section.hovering() ? m_section.prompt() : tool().prompt();
}

QCursor CoverToolHost::cursor() const
{
    return m_section.hovering() ? QCursor(Qt::SizeAllCursor) : tool().cursor();
}

void CoverToolHost::refresh()
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

bool CoverToolHost::takesShortcut(const QKeyEvent& event)
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

void CoverToolHost::rightClick(const QMouseEvent& event)
{
    if (m_document.gestureRunning())
        return;
    const CoverHit found = kind() == CoverToolKind::Select ? hit(event.position()) : CoverHit();
    if (found.kind == CoverHit::Kind::Point) {
        if (const Selection::Point point{found.element, found.point}; !m_selection.contains(point))
            m_selection.set({found.element}, {point});
    } else if (found && !m_selection.contains(found.element)) {
        m_selection.set({found.element});
    }
    askForMenu(event.globalPosition().toPoint(), bool(found));
}

void CoverToolHost::menuKey()
{
    if (!m_document.gestureRunning())
        askForMenu(m_view.mapToGlobal(m_view.rect().center()),
                   kind() == CoverToolKind::Select && !m_selection.elements().empty());
}

CoverHit CoverToolHost::hit(QPointF pixel) const
{
    CoverHit found = m_shown.hit(m_camera, pixel);
    if (found.kind == CoverHit::Kind::Point || found.kind == CoverHit::Kind::Curve)
        return found; // it can be dragged
    if (const ElementId measure = m_measures.at(pixel); measure != noElement) {
        found.kind = CoverHit::Kind::Seam; // a line on the cover, like these
        found.element = measure;
    }
    return found;
}

const ViewColors& CoverToolHost::colors() const
{
    return m_shown.scene().colors;
}

CoverHit CoverToolHost::ground(QPointF pixel) const
{
    return m_shown.hits().hitGround(m_camera, pixel);
}

CoverHit CoverToolHost::solid(QPointF pixel) const
{
    return m_shown.hits().hitSolid(m_camera, pixel);
}

std::optional<Vec3> CoverToolHost::scanPoint(ElementId scan, QPointF pixel) const
{
    return m_shown.scanPoint(scan, m_camera, pixel);
}

std::optional<CoverFoot> CoverToolHost::nearest(const Vec3& point, CoverHit::Kind on) const
{
    return m_shown.hits().nearest(point, on);
}

std::optional<Vec3> CoverToolHost::onCover(const PatchPoint& point) const
{
    return m_shown.onCover({point.patch, point.position});
}

std::optional<PatchPoint> CoverToolHost::inPattern(const CoverHit& solid) const
{
    const std::optional<CoverPoint> found = m_shown.inPattern(solid);
    return found ? std::optional(PatchPoint{found->patch, found->outline}) : std::nullopt;
}

const std::vector<std::vector<Vec3>>& CoverToolHost::catching() const
{
    return m_shown.guests().catching;
}

Vec3 CoverToolHost::middleOf(ElementId id) const
{
    return m_shown.middleOf(id);
}

} // namespace bolster
