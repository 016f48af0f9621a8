#include "SewTool.h"

#include "Document.h"
#include "SeamEdits.h"
#include "SeamStretches.h"
#include "Selection.h"
#include "SewPicture.h"
#include "ToolGeometry.h"
#include "Translated.h"

#include <QKeyEvent>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {} // namespace

const Design& SewTool::design() const
{
    return m_context.document().design();
}

void SewTool::forgetOffer()
{
    m_offer.reset();
    m_refusal.clear();
    m_mark.reset();
    m_pointing = false;
}

void SewTool::forgetAll()
{
    m_taken.clear();
    m_from.reset();
    m_dragging = false;
    m_flipped = false;
    m_several = false;
    forgetOffer();
}

/// Undo and the lists can take away what was picked.
void SewTool::forgetGone()
{
    const auto gone = [this](const Stretch& stretch) {
        return edits::stretchProblem(design(), stretch).has_value();
    };
    if (std::ranges::any_of(m_taken, gone) || (m_from && !design().find<Patch>(m_from->patch)))
        forgetAll();
}

void SewTool::takeBack()
{
    if (!m_taken.empty())
        m_taken.pop_back();
    m_several = m_several && !m_taken.empty();
    m_flipped = m_flipped && !m_taken.empty();
}

std::vector<Stretch> SewTool::row() const
{
    return m_taken.empty() ? m_taken : std::vector(m_taken.begin() + 1, m_taken.end());
}

void SewTool::press(const PatternPointer& pointer)
{
    forgetGone();
    if (onFlipButton(pointer.pixel)) {
        m_flipped = !m_flipped;
        m_context.refresh();
        return;
    }
    m_pressed = pointer;
    const std::optional<Place> place = placeAt(pointer.layout);
    m_pressedPlace = place ? std::optional(snapped(*place)) : std::nullopt;
    m_context.refresh();
}

void SewTool::move(const PatternPointer& pointer)
{
    forgetGone();
    const QPointF way = m_pressed ? pointer.pixel - m_pressed->pixel : QPointF();
    if (!m_dragging && m_pressedPlace && m_pressed && std::hypot(way.x(), way.y()) > dragDistance) {
        m_dragging = true;
        m_from = m_pressedPlace;
        m_way = 0;
    }
    offer(pointer);
}

void SewTool::release(const PatternPointer& pointer)
{
    if (!std::exchange(m_pressed, std::nullopt))
        return;
    const std::optional<Place> pressed = std::exchange(m_pressedPlace, std::nullopt);
    const bool point = pointer.modifiers & Qt::ShiftModifier && !m_from && !m_dragging;
    if (point && pressed) {
        m_from = pressed;
    } else if (!point) {
        offer(pointer);
        m_dragging = false;
        m_from.reset();
        take(pointer);
        forgetOffer(); // until the pointer moves: what it is on has just been taken
    }
    m_context.refresh();
}

void SewTool::take(const PatternPointer& pointer)
{
    if (!m_offer || !m_refusal.isEmpty()) {
        m_context.report(m_refusal.isEmpty() ? tr("Click on the outline of a patch.") : m_refusal);
        return;
    }
    m_taken.push_back(*m_offer);
    const bool more = m_several || pointer.modifiers & Qt::ControlModifier;
    if (m_taken.size() >= 2 && !more)
        sew();
}

void SewTool::sew()
{
    Message problem;
    const Edit edit =
        m_taken.size() < 2 ? Edit{} : edits::sewInRow(design(), m_taken.front(), row(), m_flipped, &problem);
    if (edit.empty()) {
        m_context.report(problem.empty() ? tr("Choose the other side first.") : translated(problem));
        return;
    }
    forgetAll();
    m_context.document().commit(edit);
    Selection::Elements added;
    for (const Change& change : edit.changes)
        added.insert(change.id);
    m_context.selection().set(added);
}

void SewTool::doubleClick(const PatternPointer& pointer)
{
    press(pointer); // who sews fast clicks twice without meaning a double click
}

bool SewTool::wants(int key) const
{
    switch (key) {
    case Qt::Key_F:
    case Qt::Key_M:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return !m_taken.empty();
    case Qt::Key_Backspace:
        return true;
    default:
        return false;
    }
}

bool SewTool::keyPress(const QKeyEvent& event)
{
    if (!wants(event.key()))
        return false;
    forgetGone();
    if (event.key() == Qt::Key_F)
        m_flipped = !m_flipped;
    else if (event.key() == Qt::Key_M)
        m_several = !m_several;
    else if (event.key() != Qt::Key_Backspace)
        sew();
    else
        takeBack();
    m_refusal.clear();
    judgeOffer();
    m_context.refresh();
    return true;
}

ToolKeys SewTool::keys() const
{
    if (m_taken.empty())
        return {};
    return {{Qt::Key_Return, tr("&Sew what is marked")},
            {Qt::Key_F, tr("&Flip")},
            {Qt::Key_M, m_several ? tr("Take &one edge") : tr("Take se&veral edges in a row")},
            {Qt::Key_Backspace, tr("&Take back the last edge")},
            {Qt::Key_Escape, tr("&Give up")}};
}

bool SewTool::escape()
{
    m_pressed.reset();
    m_pressedPlace.reset();
    forgetOffer();
    if (m_from || m_dragging) {
        m_from.reset();
        m_dragging = false;
    } else if (!m_taken.empty()) {
        takeBack();
    } else {
        m_context.selection().hover(noElement);
        m_context.endTool();
    }
    m_context.refresh();
    return true;
}

void SewTool::leave()
{
    if (m_pressed)
        return; // a drag outside goes on
    forgetOffer();
    m_context.selection().hover(noElement);
    m_context.refresh();
}

QString SewTool::prompt() const
{
    if (m_dragging)
        return m_refusal.isEmpty() ? tr("Release where the stretch ends") : m_refusal;
    if (m_from)
        return m_refusal.isEmpty() ? tr("Click where the stretch ends \u2013 Esc goes back") : m_refusal;
    if (onFlipButton(m_pointer))
        return tr("Click to sew it the other way round (F)");
    if (!m_refusal.isEmpty())
        return m_refusal;
    if (m_taken.empty())
        return tr("Click the edge to sew \u2013 drag along the outline, or Shift+click twice, for a part of it; "
                  "Esc ends the tool");
    if (m_several)
        return tr("Click the edges of the row one after the other, Enter sews \u2013 F flips, Backspace takes one "
                  "back");
    if (m_taken.size() == 1)
        return tr("Click the edge it is sewn to \u2013 F flips, Ctrl+click or M for several in a row, Backspace "
                  "goes back");
    return tr(
        "Ctrl+click the next edge of the row, click the last one \u2013 Enter sews, F flips, Backspace takes one "
        "back");
}

QCursor SewTool::cursor() const
{
    if (onFlipButton(m_pointer))
        return Qt::PointingHandCursor;
    if (m_offer && !m_refusal.isEmpty())
        return Qt::ForbiddenCursor;
    return m_offer ? Qt::PointingHandCursor : Qt::CrossCursor;
}

/// Beside the middle of the first side, inside its patch, where nothing else is clicked.
std::optional<QPointF> SewTool::flipButton() const
{
    if (m_taken.empty())
        return std::nullopt;
    const SewPicture picture(m_context.scene(), m_context.transform());
    return picture.besideMiddle(m_taken.front());
}

bool SewTool::onFlipButton(QPointF pixel) const
{
    const std::optional<QPointF> button = flipButton();
    return button && std::hypot(pixel.x() - button->x(), pixel.y() - button->y()) <= SewPicture::buttonRadius;
}

void SewTool::paint(QPainter& painter, const ViewColors& colors) const
{
    SewPicture picture(m_context.scene(), m_context.transform());
    picture.design = design();
    picture.taken = m_taken;
    picture.offer = m_offer;
    picture.refused = !m_refusal.isEmpty();
    picture.flipped = m_flipped;
    picture.pointer = m_pointer;
    picture.button = flipButton();
    picture.buttonHovered = onFlipButton(m_pointer);
    if (m_from)
        picture.marks.push_back(m_from->at);
    if (m_mark && (m_from || m_pointing))
        picture.marks.push_back(m_mark->at);
    picture.paint(painter, colors);
}

} // namespace bolster
