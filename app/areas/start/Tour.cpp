#include "Tour.h"

#include "Commands.h"
#include "CoverView.h"
#include "DesignSession.h"
#include "Docks.h"
#include "FileFlows.h"
#include "MapLink.h"
#include "PatternView.h"
#include "Samples.h"
#include "Selection.h"
#include "TourMark.h"
#include "TourPanel.h"

#include <QDir>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QToolBar>

#include <algorithm>
#include <utility>

namespace bolster {

namespace {

const QString tourStepKey = QStringLiteral("tour/step");

QString tourSample()
{
    return QDir(samplesFolder()).filePath(QStringLiteral("car-seat/car-seat.json"));
}

/// Elements of this kind that are others in `after`; of those that came or went none.
template <class T>
bool anyChanged(const Design& before, const Design& after)
{
    bool changed = false;
    after.each<T>([&](ElementId id, const T& now) {
        const T* then = before.find<T>(id);
        changed = changed || (then && !(*then == now));
    });
    return changed;
}

/// A patch that lies elsewhere on the table is the same piece.
bool anyOutlineChanged(const Design& before, const Design& after)
{
    bool changed = false;
    after.each<Patch>([&](ElementId id, const Patch& now) {
        const auto* then = before.find<Patch>(id);
        changed = changed || (then && !(then->outline == now.outline));
    });
    return changed;
}

} // namespace

Tour::Tour(Commands& commands, const Parts& parts)
    : m_commands(commands)
    , m_parts(parts)
{
    commands.add({.id = "help.tour", .text = tr("&Tour"), .places = {"help/1"}, .does = [this] { start(); }});
    addSteps();
    watch();
}

Tour::~Tour()
{
    delete m_panel;
    delete m_mark;
}

void Tour::addSteps()
{
    const auto cover = [this] { pointAtDock(m_parts.docks.cover); };
    const auto pattern = [this] { pointAtDock(m_parts.docks.pattern); };
    m_steps = {
        {Deed::CurveDragged, tr("Drag a fixation curve"),
         tr("The coloured curves on the frame are where the cloth is tied down. Click one of them, then drag one "
            "of its "
            "points: the cover follows."),
         tr("The cover follows while you drag, and comes to rest when you let go."), cover},
        {Deed::Undone, tr("Take it back"),
         tr("Ctrl+Z, or this button, takes back whatever was done, as far as you like. Nothing is lost by it: the "
            "history "
            "keeps what was undone, too."),
         tr("It is as it was. Undone steps are still in the history."),
         [this] {
             QAction* undo = m_commands["edit.undo"];
             QWidget* button = nullptr;
             for (QToolBar* bar : m_parts.window.findChildren<QToolBar*>())
                 if (QWidget* found = bar->widgetForAction(undo))
                     button = found;
             if (button && button->isVisible())
                 m_mark->pointAt(button);
             else
                 pointAtMenu("edit");
         }},
        {Deed::SeamSelected, tr("Choose a seam"),
         tr("Seams join two edges of the pattern. Click one, in the pattern or on the cover: both of its edges "
            "light up, "
            "and the cover shows where it is."),
         tr("Its properties are at the right now."), pattern},
        {Deed::SeamChanged, tr("Change how it is sewn"),
         tr("With the seam selected, choose another continuity in its properties, or another stitching: an edge, a "
            "rounded "
            "seam or a smooth one."),
         tr("The cover shows the seam as it will be sewn."), [this] { pointAtDock(m_parts.docks.inspector); }},
        {Deed::StrainSeen, tr("Look at the strain"),
         tr("View > Map colours the cover by what the cloth has to bear. Choose Largest strain to see where it is "
            "stretched "
            "most."),
         tr("The legend says how much, and the pointer reads it at any place."), [this] { pointAtMenu("view"); }},
        {Deed::OutlineChanged, tr("Change the pattern"),
         tr("Drag a point of an outline, or cut a dart (Pattern > Draw dart): what you change in the flat is sewn "
            "at "
            "once."),
         tr("Seams keep their places on an outline that changes."), pattern},
        {Deed::Exported, tr("Take it with you"),
         tr("File > Export pattern writes DXF, PDF or SVG with seam allowances and notches; Export cover writes "
            "the cover "
            "for others."),
         tr("The file is written."), [this] { pointAtMenu("file"); }},
    };
}

/// What was done is seen in the design and in what the parts say, whichever way it was done.
void Tour::watch()
{
    connect(&m_parts.session, &DesignSession::opened, this, [this] {
        m_onSample = false;
        leave();
    });
    connect(&m_parts.session.document(), &Document::historyChanged, this, &Tour::historyChanged);
    connect(&m_parts.selection, &Selection::changed, this, [this] {
        const auto& chosen = m_parts.selection.elements();
        if (std::ranges::any_of(chosen, [&](ElementId id) {
                return m_parts.session.document().design().find<Seam>(id) != nullptr;
            }))
            did(Deed::SeamSelected);
    });
    connect(&m_parts.maps, &MapLink::measured, this, [this] {
        using Kind = CoverMap::Kind;
        const std::optional<Kind> kind = m_parts.maps.kind();
        if (m_parts.maps.map() && (kind == Kind::Strain || kind == Kind::Along || kind == Kind::Across))
            did(Deed::StrainSeen);
    });
    connect(&m_parts.files.exports, &ExportFlow::exported, this, [this] { did(Deed::Exported); });
}

void Tour::historyChanged()
{
    if (!running())
        return;
    const Document& document = m_parts.session.document();
    const Design before = std::exchange(m_before, document.committed());
    const NodeId node = std::exchange(m_node, document.history().current());
    const bool more = std::exchange(m_count, document.history().count()) < m_count;
    if (node == m_node)
        return;
    if (!more)
        did(Deed::Undone);
    else if (anyChanged<FixationCurve>(before, m_before))
        did(Deed::CurveDragged);
    else if (anyOutlineChanged(before, m_before))
        did(Deed::OutlineChanged);
    else if (anyChanged<Seam>(before, m_before))
        did(Deed::SeamChanged);
}

void Tour::start()
{
    if (running()) {
        m_panel->raise();
        return;
    }
    m_step = std::clamp(QSettings().value(tourStepKey).toInt(), 0, static_cast<int>(m_steps.size()) - 1);
    if (m_onSample) {
        begin();
        return;
    }
    m_parts.files.opening.open(tourSample(), [this] {
        m_onSample = true;
        begin();
    });
}

void Tour::begin()
{
    const Document& document = m_parts.session.document();
    m_before = document.committed();
    m_node = document.history().current();
    m_count = document.history().count();
    m_mark = new TourMark(&m_parts.window);
    m_panel = new TourPanel(&m_parts.window);
    connect(m_mark, &TourMark::moved, m_panel, [this] {
        if (running())
            m_panel->placeBeside(m_mark->target());
    });
    connect(m_panel, &TourPanel::nextWanted, this, [this] { go(m_step + 1); });
    connect(m_panel, &TourPanel::backWanted, this, [this] { go(m_step - 1); });
    connect(m_panel, &TourPanel::leaveWanted, this, &Tour::leave);
    show();
}

void Tour::go(int step)
{
    const auto steps = static_cast<int>(m_steps.size());
    if (m_step == steps) { // the end was read
        leave();
        return;
    }
    m_step = std::clamp(step, 0, steps);
    QSettings().setValue(tourStepKey, m_step % steps); // the next time it begins anew
    show();
}

void Tour::show()
{
    const auto steps = static_cast<int>(m_steps.size());
    if (m_step == steps) {
        m_mark->pointAt(nullptr);
        m_panel->sayTheEnd(
            tr("That was the tour"),
            tr("You have seen how pattern, seams and frame make the cover. Begin with a design of your own: "
               "File > Start page has templates. What each key does is under Help > Keys and mouse."));
        return;
    }
    const Step& step = m_steps[static_cast<std::size_t>(m_step)];
    step.point();
    m_panel->say(m_step + 1, steps, step.title, step.text);
    m_panel->placeBeside(m_mark->target());
}

void Tour::did(Deed deed)
{
    if (!running() || m_step >= static_cast<int>(m_steps.size()))
        return;
    const Step& step = m_steps[static_cast<std::size_t>(m_step)];
    if (step.deed != deed)
        return;
    const QString praise = step.praise;
    go(m_step + 1);
    if (m_step < static_cast<int>(m_steps.size()))
        m_panel->praise(praise + QStringLiteral("\n\n") + m_steps[static_cast<std::size_t>(m_step)].text);
}

void Tour::leave()
{
    for (QWidget* part : {static_cast<QWidget*>(m_panel), static_cast<QWidget*>(m_mark)})
        if (part) {
            part->hide();
            part->deleteLater(); // one of its buttons may have asked for this
        }
    m_panel = nullptr;
    m_mark = nullptr;
}

void Tour::pointAtMenu(const char* menu)
{
    QMenuBar* bar = m_parts.window.menuBar();
    m_mark->pointAt(bar, bar->actionGeometry(m_commands.menu(menu)->menuAction()));
}

void Tour::pointAtDock(QDockWidget* dock)
{
    Docks::reveal(dock);
    m_mark->pointAt(dock);
}

} // namespace bolster
