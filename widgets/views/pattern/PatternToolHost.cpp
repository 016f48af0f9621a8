#include "PatternToolHost.h"

#include "Document.h"
#include "DrawingAids.h"
#include "HitSelection.h"
#include "PatternNavigation.h"
#include "Selection.h"
#include "ShownPattern.h"
#include "Translated.h"

#include <QContextMenuEvent>
#include <QScopeGuard>

namespace bolster {

PatternToolHost::PatternToolHost(Document& document, Selection& selection, const ShownPattern& shown,
                                 const PatternNavigation& navigation, DrawingAids& aids, QWidget& view)
    : ToolHostOf(document, selection, view, &makePatternTool)
    , m_shown(shown)
    , m_navigation(navigation)
    , m_aids(aids)
{}

QString PatternToolHost::prompt() const
{
    if (const auto& breakage = m_document.breakage())
        return tr("%1 Let go here, and it goes back to where it was.").arg(translated(breakage->why));
    return tool().prompt();
}

std::optional<CoverPoint> PatternToolHost::move(const PatternPointer& pointer)
{
    m_hit.reset();
    m_moving = true;
    const auto moved = qScopeGuard([this] { m_moving = false; });
    tool().move(pointer);
    return m_shown.pointOf(hit(pointer.pixel), transform(), pointer.pixel);
}

PatternHit PatternToolHost::hit(QPointF pixel) const
{
    if (m_moving && m_hit && m_hit->first == pixel)
        return m_hit->second;
    PatternHit found = m_shown.hit(transform(), pixel);
    // Tools that draw mean the place below a seam's letter.
    if (kind() == PatternToolKind::Select &&
        (found.kind == PatternHit::Kind::Inside || found.kind == PatternHit::Kind::Nothing))
        if (const PatternHit badge = m_shown.hitBadge(pixel))
            found = badge;
    m_hit = {pixel, found};
    return found;
}

void PatternToolHost::selectForMenu(QPointF pixel)
{
    if (!rightButtonSelects())
        return;
    const PatternHit found = hit(pixel);
    const bool alone = m_selection.elements().size() == 1 && m_selection.edges().empty(); // its edge is meant
    if (found && (!isSelected(m_selection, scene(), found) || (alone && edgeAt(scene(), found))))
        selectOnly(m_selection, scene(), found);
}

/// Not while something is being drawn or dragged, nor with tools that draw.
bool PatternToolHost::rightButtonSelects() const
{
    return !m_document.gestureRunning() && tool().keys().empty() &&
           (kind() == PatternToolKind::Select || kind() == PatternToolKind::Sew ||
            kind() == PatternToolKind::Trim || kind() == PatternToolKind::Measure);
}

void PatternToolHost::menu(const QContextMenuEvent& event)
{
    if (m_document.gestureRunning())
        return;
    const bool byKey = event.reason() == QContextMenuEvent::Keyboard;
    const bool onSomething = byKey ? !m_selection.elements().empty() : bool(hit(event.pos()));
    askForMenu(byKey ? m_view.mapToGlobal(m_view.rect().center()) : event.globalPos(),
               rightButtonSelects() && onSomething);
}

const PatternScene& PatternToolHost::scene() const
{
    return m_shown.scene();
}

const PatternTransform& PatternToolHost::transform() const
{
    return m_navigation.transform();
}

bool PatternToolHost::pointsShown(ElementId id) const
{
    return m_shown.pointsShown(id, transform());
}

const SnapSettings& PatternToolHost::snapSettings() const
{
    return m_aids.snapSettings();
}

bool PatternToolHost::lasso() const
{
    return m_aids.lasso();
}

const BackgroundPicture& PatternToolHost::background() const
{
    return m_aids.background();
}

void PatternToolHost::setBackground(const BackgroundPicture& picture)
{
    m_aids.setBackground(picture);
}

SurfaceMeshPtr PatternToolHost::surface() const
{
    return m_shown.surface();
}

const CutPattern* PatternToolHost::cut() const
{
    return m_shown.cut().get();
}

} // namespace bolster
