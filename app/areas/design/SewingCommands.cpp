#include "SewingCommands.h"

#include "Commands.h"
#include "Docks.h"
#include "Document.h"
#include "SeamEdits.h"
#include "SeamProposalsWindow.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "SewingOrder.h"

#include <QTreeView>

#include <algorithm>

namespace bolster {

SewingCommands::SewingCommands(Commands& commands, Document& document, Selection& selection, const Docks& docks)
    : m_document(document)
    , m_selection(selection)
{
    addSides(commands);
    addContinuities(commands);
    addMatches(commands);
    addOrder(commands);
    commands.add({.id = "seam.propose",
                  .text = tr("Propos&e seams \u2026"),
                  .icon = "sew",
                  .keys = {Qt::CTRL | Qt::ALT | Qt::Key_W},
                  .places = {"seam/5"},
                  .enabled =
                      [this] {
                          int patches = 0;
                          m_document.design().each<Patch>([&](ElementId, const Patch&) { ++patches; });
                          return patches > 0;
                      },
                  .does = [this, window = docks.seams->window()] { propose(window); }});
    commands.add({.id = "seam.list",
                  .formerly = "show-seam-list",
                  .text = tr("Show seam li&st"),
                  .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_W},
                  .places = {"seam/5"},
                  .does = [dock = docks.seams] { Docks::reveal(dock); }});
}

void SewingCommands::addSides(Commands& commands)
{
    const auto any = [this] { return !seams().empty(); };
    commands.add({{.id = "seam.flip",
                   .formerly = "flip",
                   .text = tr("&Flip"),
                   .icon = "flip-seam",
                   .keys = {Qt::SHIFT | Qt::Key_W},
                   .places = {"seam/2"},
                   .enabled = any,
                   .does = editing(
                       [](const Design& design, const Seams& chosen) { return edits::flipSeams(design, chosen); })},
                  {.id = "seam.swap-sides",
                   .formerly = "swap-sides",
                   .text = tr("Swap si&des"),
                   .icon = "swap",
                   .places = {"seam/2"},
                   .enabled = any,
                   .does = editing([](const Design& design, const Seams& chosen) {
                       return edits::swapSeamSides(design, chosen);
                   })}});
}

void SewingCommands::addContinuities(Commands& commands)
{
    const struct {
        Continuity continuity;
        const char* id;
        const char* formerly;
        QString text;
        Qt::Key key;
    } continuities[] = {
        {Continuity::C0, "seam.continuity-c0", "c0-an-edge", tr("C&0 \u2013 an edge"), Qt::Key_0},
        {Continuity::C1, "seam.continuity-c1", "c1-smooth-texture-too", tr("C&1 \u2013 smooth, texture too"),
         Qt::Key_1},
        {Continuity::G1, "seam.continuity-g1", "g1-rounded", tr("&G1 \u2013 rounded"), Qt::Key_2},
    };
    for (const auto& row : continuities)
        commands.add({.id = row.id,
                      .formerly = row.formerly,
                      .text = row.text,
                      .keys = {Qt::CTRL | row.key},
                      .places = {"seam/3"},
                      .enabled = [this] { return !seams().empty(); },
                      .checked =
                          [this, value = row.continuity] {
                              return all([value](const Seam& seam) { return seam.continuity == value; });
                          },
                      .does = editing([value = row.continuity](const Design& design, const Seams& chosen) {
                          return edits::setContinuity(design, chosen, value);
                      })});
}

void SewingCommands::addMatches(Commands& commands)
{
    const struct {
        Match match;
        const char* id;
        const char* formerly;
        QString text;
    } matches[] = {
        {Match::Length, "seam.match-length", "match-by-length", tr("Match by &length")},
        {Match::Parameter, "seam.match-parameter", "match-by-parameter", tr("Match by &parameter")},
    };
    for (const auto& row : matches)
        commands.add({.id = row.id,
                      .formerly = row.formerly,
                      .text = row.text,
                      .places = {"seam/4"},
                      .enabled = [this] { return !seams().empty(); },
                      .checked =
                          [this, value = row.match] {
                              return all([value](const Seam& seam) { return seam.match == value; });
                          },
                      .does = editing([value = row.match](const Design& design, const Seams& chosen) {
                          return edits::setMatch(design, chosen, value);
                      })});
}

void SewingCommands::addOrder(Commands& commands)
{
    const auto moving = [this](edits::SewingMove move) {
        return editing([move](const Design& design, const Seams& chosen) {
            return edits::moveInSewingOrder(design, chosen, move);
        });
    };
    const auto any = [this] { return !seams().empty(); };
    commands.add(
        {{.id = "seam.sew-earlier",
          .text = tr("Sew earl&ier"),
          .keys = {Qt::CTRL | Qt::ALT | Qt::Key_PageUp},
          .places = {"seam/6"},
          .enabled = any,
          .does = moving(edits::SewingMove::Earlier)},
         {.id = "seam.sew-later",
          .text = tr("Sew l&ater"),
          .keys = {Qt::CTRL | Qt::ALT | Qt::Key_PageDown},
          .places = {"seam/6"},
          .enabled = any,
          .does = moving(edits::SewingMove::Later)},
         {.id = "seam.order-proposed",
          .text = tr("Sewi&ng order as proposed"),
          .places = {"seam/6"},
          .enabled =
              [this] {
                  bool numbered = false;
                  m_document.design().each<Seam>(
                      [&](ElementId, const Seam& seam) { numbered = numbered || seam.step > 0; });
                  return numbered;
              },
          .does = editing([](const Design& design, const Seams&) { return edits::proposeSewingOrder(design); })}});
}

/// One window of it, beside the views.
void SewingCommands::propose(QWidget* window)
{
    if (!m_proposals) {
        m_proposals = new SeamProposalsWindow(m_document, m_selection, window);
        connect(m_proposals, &SeamProposalsWindow::edgesSelected, this, &SewingCommands::selectionToShow);
        m_proposals->show();
    }
    m_proposals->raise();
    m_proposals->activateWindow();
}

SewingCommands::Seams SewingCommands::seams() const
{
    return selectedOf<Seam>(m_document.design(), m_selection.elements());
}

bool SewingCommands::all(const std::function<bool(const Seam&)>& has) const
{
    const Seams chosen = seams();
    return !chosen.empty() &&
           std::ranges::all_of(chosen, [&](ElementId id) { return has(*m_document.design().find<Seam>(id)); });
}

std::function<void()> SewingCommands::editing(std::function<Edit(const Design&, const Seams&)> edit)
{
    return [this, edit = std::move(edit)] {
        m_document.cancelGesture();
        m_document.commit(edit(m_document.design(), seams()));
    };
}

void SewingCommands::fillTable(QTreeView& table, Commands& commands)
{
    const auto separator = [&table] {
        auto* line = new QAction(&table);
        line->setSeparator(true);
        return line;
    };
    table.addActions(commands.list({"seam.flip", "seam.swap-sides"}));
    table.addAction(separator());
    table.addActions(commands.startingWith("seam.continuity-"));
    table.addAction(separator());
    table.addActions(commands.startingWith("seam.match-"));
    table.addAction(separator());
    table.addActions(commands.list({"seam.sew-earlier", "seam.sew-later", "seam.order-proposed"}));
    table.addAction(separator());
    table.addActions(commands.list({"view.fit-selection", "edit.delete"}));
}

} // namespace bolster
