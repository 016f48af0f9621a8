#include "DartTool.h"

#include "DartPicture.h"
#include "Document.h"
#include "DrawingKeys.h"
#include "LengthExpression.h"
#include "Selection.h"
#include "SnapHints.h"
#include "Translated.h"

#include <QKeyEvent>
#include <QPainter>

#include <cmath>

namespace bolster {

namespace {

// Pixels.
constexpr double mouthPointRadius = 4;

bool isFree(const PatternPointer& pointer)
{
    return pointer.modifiers & (Qt::ControlModifier | Qt::AltModifier);
}

} // namespace

const Patch* DartTool::patch() const
{
    const Patch* found = m_context.document().design().find<Patch>(m_patch);
    return found && !found->outline.empty() ? found : nullptr;
}

void DartTool::press(const PatternPointer& pointer)
{
    move(pointer);
    accept();
}

void DartTool::move(const PatternPointer& pointer)
{
    m_pointer = pointer;
    pointerMoved();
    m_context.refresh();
}

ElementId DartTool::outlineAtPointer() const
{
    const PatternHit hit = m_context.hit(m_pointer->pixel);
    if (m_context.scene().patch(hit.patch) &&
        (hit.kind == PatternHit::Kind::Outline || hit.kind == PatternHit::Kind::Point))
        return hit.patch;
    return noElement;
}

void DartTool::pointerMoved()
{
    m_next.reset();
    m_tip.reset();
    m_problem = {};
    m_typedGood = false;
    if (!m_ends.empty() && !patch())
        m_ends.clear(); // undone meanwhile
    if (m_pointer && m_ends.empty()) {
        m_patch = outlineAtPointer();
        m_next = placeOnOutline(m_context, m_patch, *m_pointer);
    } else if (m_pointer && m_ends.size() == 1) {
        findMouth();
    } else if (m_pointer) {
        findTip();
    }
}

/// So wide as is typed, else a whole number of millimetres.
void DartTool::findMouth()
{
    m_next = placeOnOutline(m_context, m_patch, *m_pointer);
    const BSpline2& outline = patch()->outline;
    if (!m_next)
        return;
    const edits::DartShape mouth = edits::dartBetween(m_context.document().design(), m_patch, m_ends[0], *m_next);
    const bool ahead = mouth.from == outline.wrapped(m_ends[0]);
    const auto typed = m_typed.open() ? parseLength(m_typed.text()) : std::nullopt;
    const bool snapped = *m_next != outline.closest(fromLayout(*patch(), m_pointer->layout)).parameter;
    const double width = edits::dartAxis(outline, mouth).width;
    const double wanted = typed ? *typed : isFree(*m_pointer) || snapped ? width : std::round(width);
    if (wanted == width || !(wanted > 0))
        return;
    if (const auto end = edits::mouthEnd(outline, m_ends[0], wanted, ahead)) {
        m_next = end;
        m_typedGood = typed.has_value();
    }
}

/// So deep as is typed, else where the pointer is.
void DartTool::findTip()
{
    m_tip = fromLayout(*patch(), m_pointer->layout);
    edits::DartShape dart = *shape();
    const edits::DartAxis axis = edits::dartAxis(patch()->outline, dart);
    if (const auto typed = m_typed.open() ? parseLength(m_typed.text()) : std::nullopt; typed && *typed > 0) {
        m_tip = axis.middle + *typed * axis.inwards;
        m_typedGood = true;
    } else if (!isFree(*m_pointer)) {
        m_tip = snappedTip(m_context, *patch(), dart, m_pointer->modifiers & Qt::ShiftModifier);
    }
    edits::addDart(m_context.document().design(), *shape(), &m_problem);
}

std::optional<edits::DartShape> DartTool::shape() const
{
    if (m_ends.size() < 2 || !m_tip || !patch())
        return std::nullopt;
    edits::DartShape dart = edits::dartBetween(m_context.document().design(), m_patch, m_ends[0], m_ends[1]);
    dart.tip = *m_tip;
    return dart;
}

/// What a click or Enter means now.
void DartTool::accept()
{
    if (m_typed.open() && !m_typedGood)
        m_context.report(m_ends.size() == 1 ? tr("There is no room for a mouth of \"%1\".").arg(m_typed.text())
                                            : tr("\"%1\" is no depth: try 60").arg(m_typed.text()));
    else if (m_ends.size() == 2)
        add();
    else if (!m_next)
        m_context.report(prompt());
    else {
        m_ends.push_back(*m_next);
        m_typed.clear();
        pointerMoved();
    }
    m_context.refresh();
}

void DartTool::add()
{
    const std::optional<edits::DartShape> dart = shape();
    if (!dart)
        return;
    Document& document = m_context.document();
    Message problem;
    const Edit added = edits::addDart(document.design(), *dart, &problem);
    if (added.empty()) {
        m_context.report(translated(problem));
        return;
    }
    m_ends.clear();
    m_typed.clear();
    document.commit(added);
    for (const Change& change : added.changes) {
        const auto made = change.before ? std::nullopt : edits::dartOf(document.design(), change.id);
        if (made && made->patch == m_patch) // its twin has one, too
            m_context.selection().set({change.id});
    }
    m_context.endTool();
}

void DartTool::takeBack()
{
    if (!m_ends.empty())
        m_ends.pop_back();
    pointerMoved();
}

bool DartTool::keyPress(const QKeyEvent& event)
{
    if (!m_ends.empty() && m_typed.keyPress(event))
        pointerMoved();
    else if (event.key() == Qt::Key_Backspace && !m_ends.empty())
        takeBack();
    else if (isEnterKey(event.key()))
        accept();
    else if (isDigitKey(event.key()) && !event.modifiers().testFlag(Qt::ControlModifier))
        m_context.report(prompt()); // of nothing that has been begun
    else
        return false;
    m_context.refresh();
    return true;
}

bool DartTool::wants(int key) const
{
    return isEnterKey(key) || isDigitKey(key) ||
           (!m_ends.empty() && (m_typed.wants(key) || key == Qt::Key_Backspace));
}

ToolKeys DartTool::keys() const
{
    return m_ends.empty() ? ToolKeys() : DrawingKeys::ofLine(false);
}

bool DartTool::escape()
{
    if (m_typed.open()) {
        m_typed.clear();
        pointerMoved();
    } else if (!m_ends.empty()) {
        takeBack();
    } else {
        m_context.endTool();
    }
    m_context.refresh();
    return true;
}

void DartTool::leave()
{
    m_pointer.reset();
    pointerMoved();
    m_context.refresh();
}

QString DartTool::prompt() const
{
    if (!m_problem.empty())
        return translated(m_problem);
    if (m_ends.size() == 2)
        return tr(
            "Click the tip inside the patch, or type how deep it lies \u2013 on the dotted line both legs are "
            "of one length (Shift keeps to it, Ctrl lets go), Esc takes a click back");
    if (m_ends.size() == 1)
        return tr(
            "Click where the mouth ends on the same outline, or type how wide it is \u2013 Ctrl does not snap, "
            "Esc takes the click back");
    return tr("Click an outline where the mouth of the dart begins \u2013 Esc ends the tool");
}

void DartTool::paint(QPainter& painter, const ViewColors& colors) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    const Patch* on = patch();
    if (!on)
        return;
    const std::optional<edits::DartShape> dart = shape();
    if (dart)
        paintDart(painter, colors, m_context, *on, *dart, m_problem.empty());
    QString note;
    std::vector<double> ends = m_ends;
    if (m_next)
        ends.push_back(*m_next);
    if (ends.size() == 2 && m_next) {
        const edits::DartShape mouth = edits::dartBetween(m_context.document().design(), m_patch, ends[0], ends[1]);
        note = mouthText(*on, mouth);
    }
    painter.setPen(QPen(colors.accent, 1.6));
    painter.setBrush(colors.pointFill);
    for (const double end : ends)
        painter.drawEllipse(m_context.transform().toPixels(toLayout(*on, on->outline.at(end))), mouthPointRadius,
                            mouthPointRadius);
    if (!m_pointer)
        return;
    if (m_typed.open())
        m_typed.paint(painter, colors, m_pointer->pixel, m_typedGood);
    else
        paintNote(painter, colors, m_pointer->pixel, {note});
}

} // namespace bolster
