#include "TwinCommands.h"

#include "Commands.h"
#include "CommitEdit.h"
#include "Docks.h"
#include "Document.h"
#include "ElementEdits.h"
#include "Selection.h"
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
        if (twinOf(design, id) != noElement)
            points[id].push_back(point);
    const auto add = [&](const Stretch& stretch) {
        const Patch* patch = design.find<Patch>(stretch.patch);
        if (!patch || patch->outline.empty() || twinOf(design, stretch.patch) == noElement)
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
        if (twinOf(design, id) != noElement)
            twins.push_back(id);
    return twins;
}

/// What could get a twin.
std::vector<ElementId> selectedSingles(const Design& design, const Selection& selection)
{
    std::vector<ElementId> singles;
    for (const ElementId id : selection.elements())
        if (const ElementPtr element = design.element(id);
            element && canBeTwin(*element) && twinOf(design, id) == noElement)
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

TwinCommands::TwinCommands(Commands& commands, Document& document, Selection& selection, const Docks& docks,
                           StatusLine& status)
    : m_document(document)
    , m_selection(selection)
    , m_docks(docks)
    , m_status(status)
{
    addLinks(commands);
    addPoints(commands);
}

void TwinCommands::addLinks(Commands& commands)
{
    commands.add({{.id = "twin.make",
                   .formerly = "make-mirror-twin",
                   .text = tr("Make &mirror twin"),
                   .icon = "twin",
                   .keys = {Qt::CTRL | Qt::Key_T},
                   .places = {"pattern.twins/1"},
                   .enabled = [this] { return !selectedSingles(m_document.design(), m_selection).empty(); },
                   .does = [this] { make(); }},
                  {.id = "twin.link",
                   .formerly = "link-as-twins",
                   .text = tr("Link as t&wins"),
                   .places = {"pattern.twins/1"},
                   .enabled = [this] { return canLink(); },
                   .does = [this] { link(); }},
                  {.id = "twin.unlink",
                   .formerly = "unlink-twins",
                   .text = tr("&Unlink twins"),
                   .places = {"pattern.twins/1"},
                   .enabled = [this] { return !selectedTwins(m_document.design(), m_selection).empty(); },
                   .does = [this] { unlink(); }}});
}

void TwinCommands::addPoints(Commands& commands)
{
    commands.add({{.id = "twin.release-points",
                   .formerly = "release-points-from-the-twin",
                   .text = tr("R&elease points from the twin"),
                   .keys = {Qt::CTRL | Qt::ALT | Qt::Key_T},
                   .places = {"pattern.twins/1"},
                   .enabled = [this] { return !chosenPoints(m_document.design(), m_selection).empty(); },
                   .does = [this] { release(); }},
                  {.id = "twin.relink-points",
                   .formerly = "re-link-points-to-the-twin",
                   .text = tr("Re-l&ink points to the twin"),
                   .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_T},
                   .places = {"pattern.twins/1"},
                   .enabled = [this] { return !relinkedChosen(m_document.design(), m_selection).empty(); },
                   .does = [this] { relink(); }},
                  {.id = "twin.symmetry",
                   .formerly = "symmetry",
                   .text = tr("S&ymmetry \u2026"),
                   .places = {"pattern.twins/1"},
                   .does = [this] { editSymmetry(); }}});
}

bool TwinCommands::canLink() const
{
    const Design& design = m_document.design();
    const std::vector<ElementId> singles = selectedSingles(design, m_selection);
    return singles.size() == 2 && m_selection.elements().size() == 2 &&
           design.element(singles[0])->index() == design.element(singles[1])->index();
}

void TwinCommands::make()
{
    m_document.cancelGesture();
    const Design before = m_document.design();
    const Edit edit = edits::makeTwins(before, selectedSingles(before, m_selection), [](const std::string& name) {
        return mirroredName(QString::fromStdString(name), tr("%1, mirrored")).toStdString();
    });
    const Selection::Elements selected = m_selection.elements();
    commit(edit, tr("Select patches or curves that have no twin yet."));
    Selection::Elements twins;
    for (const ElementId id : selected)
        if (const ElementId twin = twinOf(m_document.design(), id); twin != noElement && !before.element(twin))
            twins.insert(twin);
    if (!twins.empty())
        m_selection.set(std::move(twins));
}

void TwinCommands::link()
{
    m_document.cancelGesture();
    const Design& design = m_document.design();
    const std::vector<ElementId> pair = selectedSingles(design, m_selection);
    if (pair.size() != 2)
        return;
    Message problem{QT_TRANSLATE_NOOP("Message", "These two cannot be twins.")};
    const Edit edit = edits::linkTwins(design, pair[0], pair[1], &problem);
    commit(edit, translated(problem));
}

void TwinCommands::unlink()
{
    m_document.cancelGesture();
    const Design& design = m_document.design();
    commit(edits::unlinkTwins(design, selectedTwins(design, m_selection)),
           tr("Nothing that is selected has a twin."));
}

void TwinCommands::release()
{
    m_document.cancelGesture();
    const Design& design = m_document.design();
    commit(changedPoints(design, chosenPoints(design, m_selection), edits::releasePoints,
                         {QT_TRANSLATE_NOOP("Message", "Release points of twins")}),
           tr("Select points of a twin, or a seam on it, that still follow."));
}

void TwinCommands::relink()
{
    m_document.cancelGesture();
    commit(relinkedChosen(m_document.design(), m_selection), tr("No point that is selected has been released."));
}

void TwinCommands::editSymmetry()
{
    m_document.cancelGesture();
    const Design& design = m_document.design();
    Settings settings = design.settings();
    if (!settings.symmetry) {
        settings.symmetry = Symmetry();
        m_document.commit(edits::replaceElement(design, settingsId, makeElement(settings),
                                                {QT_TRANSLATE_NOOP("Message", "Make the design symmetric")}));
    }
    m_selection.clear();
    Docks::reveal(m_docks.inspector);
}

void TwinCommands::commit(const Edit& edit, const QString& problem)
{
    commitOrTell(m_document, m_status, edit, problem);
}

} // namespace bolster
