#include "AttachTool.h"

#include "Document.h"
#include "ElementText.h"
#include "FixationEdits.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "StretchLength.h"
#include "StretchPick.h"
#include "StretchToFix.h"
#include "Translated.h"
#include "Units.h"
#include "ViewColors.h"

#include <QKeyEvent>
#include <QPainter>

#include <algorithm>

namespace bolster {

std::vector<ElementId> AttachTool::curves() const
{
    return selectedOf<FixationCurve>(design(), m_context.selection().elements());
}

QString AttachTool::problemOf(const Stretch& stretch) const
{
    const auto problem = edits::fixationProblem(design(), stretch);
    return problem ? translated(*problem) : QString();
}

void AttachTool::press(const PatternPointer& pointer)
{
    const std::optional<Stretch> stretch = stretchUnder(m_context, pointer.pixel);
    if (!stretch) {
        m_context.report(tr("Click an edge of an outline."));
        return;
    }
    if (const QString problem = problemOf(*stretch); !problem.isEmpty()) {
        m_context.report(problem);
        return;
    }
    std::vector<Stretch> stretches = m_collected;
    if (const auto known = std::ranges::find(stretches, *stretch); known == stretches.end())
        stretches.push_back(*stretch);
    else if (pointer.modifiers & Qt::ShiftModifier)
        stretches.erase(known);
    if (pointer.modifiers & Qt::ShiftModifier)
        m_collected = stretches;
    else
        attach(stretches);
    m_context.refresh();
}

void AttachTool::move(const PatternPointer& pointer)
{
    m_hover = stretchUnder(m_context, pointer.pixel);
    m_context.refresh();
}

bool AttachTool::wants(int key) const
{
    return key == Qt::Key_Return || key == Qt::Key_Enter || (key == Qt::Key_Backspace && !m_collected.empty());
}

bool AttachTool::keyPress(const QKeyEvent& event)
{
    if (!wants(event.key()))
        return false;
    if (event.key() == Qt::Key_Backspace)
        m_collected.pop_back();
    else if (const auto selected = stretchToFix(design(), m_context.selection()); m_collected.empty() && selected)
        attach({*selected});
    else
        attach(m_collected);
    m_context.refresh();
    return true;
}

ToolKeys AttachTool::keys() const
{
    if (m_collected.empty())
        return {};
    return {{Qt::Key_Return, tr("&Attach what is marked")},
            {Qt::Key_Backspace, tr("&Take back the last edge")},
            {Qt::Key_Escape, tr("&Give up")}};
}

bool AttachTool::escape()
{
    if (m_collected.empty())
        m_context.endTool();
    m_collected.clear();
    m_hover.reset();
    m_context.refresh();
    return true;
}

void AttachTool::leave()
{
    m_hover.reset();
    m_context.refresh();
}

Edit AttachTool::edit(const std::vector<Stretch>& stretches) const
{
    const SurfaceMeshPtr surface = m_context.surface();
    const std::vector<ElementId> to = curves();
    return to.size() == 1 ? edits::attachStretches(design(), stretches, to.front(), surface.get())
                          : edits::attachToCurves(design(), stretches.front(), to, surface.get());
}

void AttachTool::attach(const std::vector<Stretch>& stretches)
{
    const std::size_t curveCount = curves().size();
    if (stretches.empty())
        m_context.report(tr("Click an edge of an outline."));
    else if (curveCount == 0)
        m_context.report(tr("Select a fixation curve first, in the 3D view or in the list."));
    else if (curveCount > 1 && stretches.size() > 1)
        m_context.report(tr("Several stretches go with one curve, or one stretch with several curves."));
    else if (const Edit added = edit(stretches); !added.empty()) {
        m_collected.clear();
        m_hover.reset();
        // The curves stay selected: the next click fixes another edge to them.
        m_context.document().commit(added);
    } else {
        const QString problem = problemOf(stretches.front());
        m_context.report(!problem.isEmpty() ? problem
                         : stretches.size() > 1
                             ? tr("The stretches overlap each other, or are attached like this already.")
                             : tr("This stretch is attached like this already."));
    }
}

QString AttachTool::prompt() const
{
    const std::vector<ElementId> to = curves();
    if (to.empty())
        return tr(
            "Select a fixation curve in the 3D view or in the list, then click an edge of an outline \u2013 Esc "
            "ends the tool");
    const QString name = to.size() == 1 ? displayName(design(), to.front()) : tr("%1 curves").arg(to.size());
    if (m_hover) {
        const QString problem = problemOf(*m_hover);
        return problem.isEmpty() ? tr("Click to fix this stretch of %1 to %2 \u2013 Shift+click collects several")
                                       .arg(lengthText(stretchLength(design(), *m_hover)), name)
                                 : problem;
    }
    return m_collected.empty()
               ? tr("Click an edge of an outline to fix it to %1 \u2013 Enter takes the selected stretch, Esc ends "
                    "the "
                    "tool")
                     .arg(name)
               : tr("Click the last edge, or Enter attaches %1 stretches to %2 \u2013 Backspace takes one back")
                     .arg(m_collected.size())
                     .arg(name);
}

QCursor AttachTool::cursor() const
{
    if (m_hover && !problemOf(*m_hover).isEmpty())
        return Qt::ForbiddenCursor;
    return m_hover ? Qt::PointingHandCursor : Qt::CrossCursor;
}

void AttachTool::paint(QPainter& painter, const ViewColors& colors) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Stretch& stretch : m_collected)
        paintStretch(painter, m_context, stretch, colors.accent);
    if (m_hover)
        paintStretch(painter, m_context, *m_hover, problemOf(*m_hover).isEmpty() ? colors.accent : colors.error);
    else if (const auto selected = stretchToFix(design(), m_context.selection()); selected && m_collected.empty())
        paintStretch(painter, m_context, *selected, colors.accent);
}

} // namespace bolster
