// What the window does with mirror twins.
#include "MainWindow.h"

#include "Actions.h"
#include "Docks.h"
#include "ElementEdits.h"
#include "SelectionEdits.h"
#include "StatusLine.h"
#include "Translated.h"
#include "TwinEdits.h"
#include "Twins.h"

namespace bolster {

namespace {

using PointsByElement = std::map<ElementId, std::vector<int>>;

/// The selected points of twins; without any, those on the selected seams and fixations.
PointsByElement chosenPoints(const Design& design, const Selection& selection)
{
    PointsByElement points;
    for (const auto& [id, point] : selection.points())
        if (twinOf(design, id) != settingsId)
            points[id].push_back(point);
    const auto add = [&](const Stretch& stretch) {
        const Patch* patch = design.find<Patch>(stretch.patch);
        if (!patch || patch->outline.empty() || twinOf(design, stretch.patch) == settingsId)
            return;
        const std::vector<int> found = edits::pointsOnStretch(patch->outline, stretch.from, stretch.to);
        points[stretch.patch].insert(points[stretch.patch].end(), found.begin(), found.end());
    };
    if (!selection.points().empty())
        return points;
    for (const ElementId id : selection.elements()) {
        if (const Seam* seam = design.find<Seam>(id)) {
            add(seam->a);
            add(seam->b);
        } else if (const FixationSeam* fixation = design.find<FixationSeam>(id)) {
            add(fixation->stretch);
        } else if (const OutlineTrim* trimmed = design.find<OutlineTrim>(id)) {
            add(trimmed->stretch);
        }
    }
    return points;
}

/// With whole elements, all their exceptions.
PointsByElement releasedOfChosen(const Design& design, const Selection& selection)
{
    PointsByElement points = chosenPoints(design, selection);
    if (selection.points().empty())
        for (const ElementId id : selection.elements())
            if (const std::vector<int> released = releasedPoints(design, id); !released.empty())
                points[id] = released;
    std::erase_if(points, [&](const auto& entry) { return releasedPoints(design, entry.first).empty(); });
    return points;
}

std::vector<ElementId> selectedTwins(const Design& design, const Selection& selection)
{
    std::vector<ElementId> twins;
    for (const ElementId id : selection.elements())
        if (twinOf(design, id) != settingsId)
            twins.push_back(id);
    return twins;
}

/// What could get a twin.
std::vector<ElementId> selectedSingles(const Design& design, const Selection& selection)
{
    std::vector<ElementId> singles;
    for (const ElementId id : selection.elements())
        if (const ElementPtr element = design.element(id);
            element && canBeTwin(*element) && twinOf(design, id) == settingsId)
            singles.push_back(id);
    return singles;
}

/// Left becomes right; other names say that they are mirrored.
QString mirroredName(const QString& name, const QString& otherwise)
{
    static const std::pair<const char*, const char*> sides[] = {
        {"left", "right"},     {"Left", "Right"},     {"LEFT", "RIGHT"},     {"links", "rechts"},
        {"Links", "Rechts"},   {"linke", "rechte"},   {"Linke", "Rechte"},   {"linker", "rechter"},
        {"Linker", "Rechter"}, {"linkes", "rechtes"}, {"Linkes", "Rechtes"}, {"L", "R"}};
    QStringList words = name.split(u' ');
    for (QString& word : words)
        for (const auto& [a, b] : sides)
            if (word == QLatin1String(a) || word == QLatin1String(b)) {
                word = QLatin1String(word == QLatin1String(a) ? b : a);
                return words.join(u' ');
            }
    return otherwise.arg(name);
}

template <class Change>
Edit changedPoints(const Design& design, const PointsByElement& points, const Change& change, const Message& verb)
{
    EditChain chain(design);
    for (const auto& [id, indices] : points)
        chain.add(change(chain.design(), id, indices));
    return chain.result(verb);
}

/// The chosen points and seams become what the mirror shows of the others.
Edit relinkedChosen(const Design& design, const Selection& selection)
{
    const Message verb{QT_TRANSLATE_NOOP("Message", "Re-link points of twins")};
    EditChain chain(design);
    chain.add(changedPoints(design, releasedOfChosen(design, selection), edits::relinkPoints, verb));
    for (const ElementId id : selection.elements())
        chain.add(edits::relinkSewing(chain.design(), id));
    return chain.result(verb);
}

} // namespace

void MainWindow::connectTwins()
{
    const auto on = [this](QAction* action, auto function) {
        connect(action, &QAction::triggered, this, [this, function] {
            document().cancelGesture();
            function();
        });
    };
    on(m_actions->makeTwin, [this] {
        const Design before = document().design();
        const Edit edit =
            edits::makeTwins(before, selectedSingles(before, m_selection), [](const std::string& name) {
                return mirroredName(QString::fromStdString(name), tr("%1, mirrored")).toStdString();
            });
        const Selection::Elements selected = m_selection.elements();
        commitOrTell(edit, tr("Select patches or curves that have no twin yet."));
        Selection::Elements twins;
        for (const ElementId id : selected)
            if (const ElementId twin = twinOf(document().design(), id); twin != settingsId && !before.element(twin))
                twins.insert(twin);
        if (!twins.empty())
            m_selection.set(std::move(twins));
    });
    on(m_actions->linkTwins, [this] { linkSelectedTwins(); });
    on(m_actions->unlinkTwins, [this] {
        const Design& design = document().design();
        commitOrTell(edits::unlinkTwins(design, selectedTwins(design, m_selection)),
                     tr("Nothing that is selected has a twin."));
    });
    on(m_actions->releasePoints, [this] {
        const Design& design = document().design();
        commitOrTell(changedPoints(design, chosenPoints(design, m_selection), edits::releasePoints,
                                   {QT_TRANSLATE_NOOP("Message", "Release points of twins")}),
                     tr("Select points of a twin, or a seam on it, that still follow."));
    });
    on(m_actions->relinkPoints, [this] {
        commitOrTell(relinkedChosen(document().design(), m_selection),
                     tr("No point that is selected has been released."));
    });
    on(m_actions->symmetry, [this] {
        const Design& design = document().design();
        Settings settings = design.settings();
        if (!settings.symmetry) {
            settings.symmetry = Symmetry();
            document().commit(edits::replaceElement(design, settingsId, makeElement(settings),
                                                    {QT_TRANSLATE_NOOP("Message", "Make the design symmetric")}));
        }
        m_selection.clear();
        Docks::reveal(m_docks->inspector);
    });
    connect(&m_selection, &Selection::changed, this, &MainWindow::updateTwinActions);
    connect(&document(), &Document::historyChanged, this, &MainWindow::updateTwinActions);
    updateTwinActions();
}

void MainWindow::updateTwinActions()
{
    const Design& design = document().design();
    const std::vector<ElementId> singles = selectedSingles(design, m_selection);
    m_actions->makeTwin->setEnabled(!singles.empty());
    m_actions->linkTwins->setEnabled(singles.size() == 2 && m_selection.elements().size() == 2 &&
                                     design.element(singles[0])->index() == design.element(singles[1])->index());
    m_actions->unlinkTwins->setEnabled(!selectedTwins(design, m_selection).empty());
    m_actions->releasePoints->setEnabled(!chosenPoints(design, m_selection).empty());
    m_actions->relinkPoints->setEnabled(!relinkedChosen(design, m_selection).empty());
}

void MainWindow::linkSelectedTwins()
{
    const Design& design = document().design();
    const std::vector<ElementId> pair = selectedSingles(design, m_selection);
    if (pair.size() != 2)
        return;
    Message problem{QT_TRANSLATE_NOOP("Message", "These two cannot be twins.")};
    const Edit edit = edits::linkTwins(design, pair[0], pair[1], &problem);
    commitOrTell(edit, translated(problem));
}

void MainWindow::commitOrTell(const Edit& edit, const QString& problem)
{
    if (edit.empty())
        m_status->flash(problem);
    else
        document().commit(edit);
}

} // namespace bolster
