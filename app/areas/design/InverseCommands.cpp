#include "InverseCommands.h"

#include "CauseWindow.h"
#include "Commands.h"
#include "CoverView.h"
#include "DesignSession.h"
#include "FormPatternWindow.h"
#include "FormWishesPanel.h"
#include "PatternFitWindow.h"
#include "PatternView.h"
#include "ReliefWindow.h"
#include "Selection.h"
#include "SolverLink.h"
#include "SweepWindow.h"

#include <set>

namespace bolster {

namespace {

/// Shows the pattern as it was seen before the last step when that is undone, and as it is seen now when it is made
/// again, unless somebody has looked elsewhere meanwhile.
class ViewOfStep : public QObject {
public:
    ViewOfStep(const Document& document, PatternNavigation& pattern, const PatternTransform& before)
        : m_pattern(pattern)
        , m_step(document.history().current())
        , m_stepBefore(document.history().node(m_step).parent)
        , m_before(before)
        , m_after(pattern.transform())
    {
        connect(&document, &Document::historyChanged, this, [this, &document] {
            const NodeId now = document.history().current();
            if (now == m_stepBefore && m_pattern.transform().matrix() == m_after.matrix())
                m_pattern.setTransform(m_before);
            else if (now == m_step && m_pattern.transform().matrix() == m_before.matrix())
                m_pattern.setTransform(m_after);
        });
    }

private:
    PatternNavigation& m_pattern;
    NodeId m_step, m_stepBefore;
    PatternTransform m_before, m_after;
};

} // namespace

InverseCommands::InverseCommands(Commands& commands, const Parts& parts)
    : m_parts(parts)
    , m_alsoThere(commands.list({"edit.undo", "edit.redo", "file.save", "file.quit", "pattern.from-form",
                                 "pattern.fit", "pattern.relieve", "pattern.explain", "pattern.tolerances"}))
    , m_formWishes(std::make_shared<FormPatternWishes>())
    , m_fits(std::make_shared<FitMemory>())
    , m_sweepWishes(std::make_shared<SweepWishes>())
    , m_reliefs(std::make_shared<ReliefMemory>())
    , m_causes(std::make_shared<CauseMemory>())
{
    addCommands(commands);
    // What was wished for another design, by a window that is about to close, too, is of no use for this one.
    connect(&parts.session.document(), &Document::historyReplaced, this, [this] {
        m_viewOfStep.reset();
        m_formWishes = std::make_shared<FormPatternWishes>();
        m_fits = std::make_shared<FitMemory>();
        m_sweepWishes = std::make_shared<SweepWishes>();
        m_reliefs = std::make_shared<ReliefMemory>();
        m_causes = std::make_shared<CauseMemory>();
    });
}

void InverseCommands::addCommands(Commands& commands)
{
    const auto anyPatch = [this] {
        bool found = false;
        m_parts.session.document().design().each<Patch>([&](ElementId, const Patch&) { found = true; });
        return found;
    };
    commands.add(
        {.id = "pattern.from-form",
         .text = tr("From a form \u2026"),
         .keys = {Qt::CTRL | Qt::ALT | Qt::Key_O},
         .tip = tr("Cuts a frame, a mesh or the cover into pieces, lays them flat and makes the pattern of "
                   "them"),
         .places = {"pattern/6"},
         .does = [this] { show(m_form, [this] { return formWindow(); }); }});
    commands.add({.id = "pattern.fit",
                  .text = tr("F&it to a goal \u2026"),
                  .keys = {Qt::CTRL | Qt::ALT | Qt::Key_G},
                  .tip = tr("Changes the pattern until the cover lies on a scan, or is strained less"),
                  .places = {"pattern/6"},
                  .enabled = anyPatch,
                  .does = [this] {
                      show(m_fit, [this] {
                          return new PatternFitWindow(
                              m_parts.session, m_parts.selection,
                              {m_parts.pattern, {m_parts.solver, m_parts.maps, m_parts.cover}}, m_fits,
                              &m_parts.window);
                      });
                  }});
    commands.add(
        {.id = "pattern.relieve",
         .text = tr("Relieve strain \u2026"),
         .keys = {Qt::CTRL | Qt::ALT | Qt::Key_S},
         .tip = tr("Proposes changes of the pattern where cloth is strained too much, with what each gains"),
         .places = {"pattern/6"},
         .enabled = anyPatch,
         .does = [this] {
             show(m_relief, [this] {
                 return new ReliefWindow(m_parts.session, m_parts.selection, m_parts.cover, m_parts.mark, m_reliefs,
                                         &m_parts.window);
             });
         }});
    commands.add({.id = "pattern.explain",
                  .text = tr("Why is it so? \u2026"),
                  .keys = {Qt::CTRL | Qt::ALT | Qt::Key_C},
                  .tip = tr("Which cause explains best how far the scan of a built piece lies from the cover"),
                  .places = {"pattern/6"},
                  .enabled = anyPatch,
                  .does = [this] {
                      show(m_cause, [this] {
                          return new CauseWindow(m_parts.session, m_parts.selection, m_causes, &m_parts.window);
                      });
                  }});
    commands.add({.id = "pattern.tolerances",
                  .text = tr("Tolerances \u2026"),
                  .keys = {Qt::CTRL | Qt::ALT | Qt::Key_V},
                  .tip = tr("Where the cover varies from piece to piece, and which tolerance of making matters"),
                  .places = {"pattern/6"},
                  .enabled = anyPatch,
                  .does = [this] {
                      show(m_sweep, [this] {
                          return new SweepWindow(m_parts.session, m_parts.selection, m_parts.maps, m_sweepWishes,
                                                 &m_parts.window);
                      });
                  }});
}

/// They go before what they use: as children of the window they would go after it.
InverseCommands::~InverseCommands()
{
    for (QDialog* dialog : {m_sweep.data(), m_cause.data(), m_relief.data(), m_fit.data(), m_form.data()})
        delete dialog;
}

template <class Make>
void InverseCommands::show(QPointer<QDialog>& dialog, const Make& make)
{
    if (!dialog) {
        dialog = make();
        dialog->addActions(m_alsoThere);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

QDialog* InverseCommands::formWindow()
{
    auto* window = new FormPatternWindow(m_parts.session, m_parts.solver, m_parts.cover.shown(), m_formWishes,
                                         &m_parts.window);
    const auto bringIn = [this](const Box3& where) {
        CoverNavigation& cover = m_parts.cover.navigation();
        if (!cover.inPicture(where))
            cover.fit(where);
    };
    connect(window, &FormPatternWindow::fileLaidFlat, this, bringIn);
    connect(window, &FormPatternWindow::patternMade, this,
            [this, bringIn](const std::vector<ElementId>& added, const Box3& where) {
                const Design& design = m_parts.session.document().design();
                std::set<ElementId> patches; // the points of all curves would hide the cover
                for (const ElementId id : added)
                    if (design.find<Patch>(id))
                        patches.insert(id);
                m_parts.selection.set(patches);
                PatternNavigation& pattern = m_parts.pattern.navigation();
                const PatternTransform before = pattern.transform();
                pattern.fitAll();
                m_viewOfStep = std::make_unique<ViewOfStep>(m_parts.session.document(), pattern, before);
                bringIn(where);
                m_parts.solver.whenAtRest(this,
                                          [this](const SurfaceMeshPtr&) { // held by nothing it may go elsewhere
                                              const Box3 box = m_parts.cover.shown().selectedBox();
                                              if (!box.isEmpty() && !m_parts.cover.navigation().inPicture(box))
                                                  m_parts.cover.navigation().fitSelection();
                                          });
            });
    return window;
}

} // namespace bolster
