#include "PatternCommands.h"

#include "Actions.h"
#include "CopyPaste.h"
#include "CornerEdits.h"
#include "Document.h"
#include "ElementEdits.h"
#include "ElementText.h"
#include "LayoutEdits.h"
#include "PatchMerge.h"
#include "PatchShapeEdits.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "Translated.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>

#include <map>

namespace bolster {

namespace {

const QString mimeType = QStringLiteral("application/x-bolster-design+json");
const Vec2 step(30, -30); // mm in the layout, of a copy from what was copied

std::string clipboardText()
{
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    if (!data)
        return {};
    return data->hasFormat(mimeType) ? data->data(mimeType).toStdString() : data->text().toStdString();
}

/// The selected control points in the pattern, by their element.
std::map<ElementId, std::vector<int>> planePoints(const Design& design, const Selection& selection)
{
    std::map<ElementId, std::vector<int>> points;
    for (const Selection::Point& point : selection.points())
        if (const int index = planePoint(design, point); index >= 0)
            points[point.first].push_back(index);
    return points;
}

QString droppedText(const Design& before, const std::vector<ElementId>& dropped)
{
    QStringList names;
    for (const ElementId id : dropped)
        names += displayName(before, id);
    return PatternCommands::tr("Removed, because they make no sense any more: %1")
        .arg(names.join(QStringLiteral(", ")));
}

} // namespace

PatternCommands::PatternCommands(Document& document, Selection& selection, Actions& actions, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_selection(selection)
    , m_actions(actions)
{
    connectClipboard();
    connectLayout();
    connectShapes();
    connect(&selection, &Selection::changed, this, &PatternCommands::update);
    connect(&document, &Document::historyChanged, this, &PatternCommands::update);
    connect(QGuiApplication::clipboard(), &QClipboard::dataChanged, this, &PatternCommands::updateClipboard);
    update();
    updateClipboard();
}

void PatternCommands::connectClipboard()
{
    connect(m_actions.cut, &QAction::triggered, this, &PatternCommands::cut);
    connect(m_actions.copy, &QAction::triggered, this, &PatternCommands::copy);
    connect(m_actions.paste, &QAction::triggered, this, &PatternCommands::paste);
    connect(m_actions.duplicate, &QAction::triggered, this, &PatternCommands::duplicate);
}

void PatternCommands::connectLayout()
{
    connect(m_actions.mirrorHorizontally, &QAction::triggered, this, [this] { mirror(true); });
    connect(m_actions.mirrorVertically, &QAction::triggered, this, [this] { mirror(false); });
    for (QAction* action : m_actions.align)
        connect(action, &QAction::triggered, this, [this, action] {
            m_document.cancelGesture();
            commit(edits::alignPatches(m_document.design(), patches(),
                                       static_cast<edits::Alignment>(action->data().toInt())));
        });
    for (QAction* action : m_actions.distribute)
        connect(action, &QAction::triggered, this, [this, action] {
            m_document.cancelGesture();
            commit(edits::distributePatches(m_document.design(), patches(),
                                            static_cast<edits::Direction>(action->data().toInt())));
        });
    connect(m_actions.arrange, &QAction::triggered, this, [this] {
        m_document.cancelGesture();
        const std::vector<ElementId> chosen = patches();
        commit(edits::arrangePatches(m_document.design(), chosen.size() > 1 ? chosen : std::vector<ElementId>()));
    });
}

void PatternCommands::connectShapes()
{
    connect(m_actions.makeCorner, &QAction::triggered, this, [this] { makeCorners(true); });
    connect(m_actions.makeSmooth, &QAction::triggered, this, [this] { makeCorners(false); });
    connect(m_actions.straighten, &QAction::triggered, this, &PatternCommands::straighten);
    connect(m_actions.mergePatches, &QAction::triggered, this, &PatternCommands::merge);
}

void PatternCommands::update()
{
    const Design& design = m_document.design();
    const std::vector<ElementId> chosen = patches();
    const bool copies = edits::canCopy(design, selected());
    for (QAction* action : {m_actions.cut, m_actions.copy, m_actions.duplicate})
        action->setEnabled(copies);
    for (QAction* action : {m_actions.mirrorHorizontally, m_actions.mirrorVertically})
        action->setEnabled(!chosen.empty());
    for (QAction* action : m_actions.align)
        action->setEnabled(chosen.size() >= 2);
    for (QAction* action : m_actions.distribute)
        action->setEnabled(chosen.size() >= 3);
    bool any = false;
    design.each<Patch>([&](ElementId, const Patch&) { any = true; });
    m_actions.arrange->setEnabled(any);
    m_actions.mergePatches->setEnabled(seamToMerge().has_value());
    updatePoints();
}

void PatternCommands::updatePoints()
{
    const Design& design = m_document.design();
    const auto points = planePoints(design, m_selection);
    bool corners = false, smooth = false;
    for (const auto& [id, indices] : points)
        for (const int index : indices) {
            const BSpline2& curve = *planeCurve(*design.element(id));
            const bool end = !curve.closed() && (index == 0 || index == curve.pointCount() - 1);
            const bool corner = edits::isCornerPoint(design, id, index);
            corners |= corner && !end;
            smooth |= !corner;
        }
    m_actions.makeCorner->setEnabled(smooth);
    m_actions.makeSmooth->setEnabled(corners);
    m_actions.straighten->setEnabled(points.size() == 1 && points.begin()->second.size() == 2);
}

void PatternCommands::updateClipboard()
{
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    // What a text says is looked at when it is pasted: fetching it from another program can take long.
    m_actions.paste->setEnabled(data && (data->hasFormat(mimeType) || data->hasText()));
}

std::vector<ElementId> PatternCommands::selected() const
{
    return {m_selection.elements().begin(), m_selection.elements().end()};
}

std::vector<ElementId> PatternCommands::patches() const
{
    return selectedOf<Patch>(m_document.design(), m_selection.elements());
}

bool PatternCommands::commit(const edits::Outcome& outcome)
{
    if (outcome.edit.empty()) {
        if (!outcome.problem.empty())
            emit said(translated(outcome.problem));
        return false;
    }
    const Design before = m_document.design();
    m_document.commit(outcome.edit);
    if (!outcome.dropped.empty())
        emit said(droppedText(before, outcome.dropped));
    return true;
}

void PatternCommands::copy()
{
    const std::string text = edits::copyText(m_document.design(), selected());
    if (text.empty())
        return;
    auto* data = new QMimeData;
    data->setData(mimeType, QByteArray::fromStdString(text));
    data->setText(QString::fromStdString(text));
    QGuiApplication::clipboard()->setMimeData(data);
    m_clip = text;
    m_pastes = 1; // the first one would lie on what was copied
}

void PatternCommands::cut()
{
    m_document.cancelGesture();
    copy();
    m_pastes = 0;
    std::vector<ElementId> pieces = patches();
    for (const ElementId id : selectedOf<FixationCurve>(m_document.design(), m_selection.elements()))
        pieces.push_back(id);
    const Edit removal = edits::removeElements(m_document.design(), pieces);
    if (removal.empty())
        return;
    removeAndForget(m_document, m_selection, removal);
    if (removal.changes.size() > pieces.size())
        emit said(translated(removal.verb));
}

void PatternCommands::paste()
{
    m_document.cancelGesture();
    const std::string text = clipboardText();
    if (text != m_clip) {
        m_clip = text;
        m_pastes = 1;
    }
    const edits::Outcome outcome = edits::paste(m_document.design(), text, m_pastes * step);
    if (!commit(outcome))
        return;
    ++m_pastes;
    const std::vector<ElementId> added = edits::addedPieces(outcome.edit);
    m_selection.set({added.begin(), added.end()});
}

void PatternCommands::duplicate()
{
    m_document.cancelGesture();
    const Edit edit = edits::duplicatePatches(m_document.design(), selected(), step);
    if (!commit(edit))
        return;
    const std::vector<ElementId> added = edits::addedPieces(edit);
    m_selection.set({added.begin(), added.end()});
}

/// Horizontally: what was left comes to the right, about the middle of the selected patches.
void PatternCommands::mirror(bool horizontally)
{
    m_document.cancelGesture();
    const std::vector<ElementId> chosen = patches();
    const Box2 box = edits::layoutBox(m_document.design(), chosen);
    if (box.isEmpty())
        return;
    commit(edits::mirrorPatches(m_document.design(), chosen,
                                horizontally ? edits::MirrorAxis::Vertical : edits::MirrorAxis::Horizontal,
                                horizontally ? box.center().x() : box.center().y()));
}

void PatternCommands::makeCorners(bool corner)
{
    m_document.cancelGesture();
    EditChain chain(m_document.design());
    const auto points = planePoints(chain.design(), m_selection);
    for (const auto& [id, indices] : points)
        chain.add(corner ? edits::makeCorners(chain.design(), id, indices)
                         : edits::makeSmooth(chain.design(), id, indices));
    // Points come and go: what was selected is found again at its parameter.
    Selection::Points found;
    for (const auto& [id, indices] : points)
        for (const int index : indices) {
            const BSpline2& before = *planeCurve(*m_document.design().element(id));
            found.insert({id, planeCurve(*chain.design().element(id))->pointAt(before.parameterOfPoint(index))});
        }
    const Edit edit = chain.result(corner ? Message{QT_TRANSLATE_NOOP("Message", "Make corners"), {}}
                                          : Message{QT_TRANSLATE_NOOP("Message", "Make curves smooth"), {}});
    m_selection.set(m_selection.elements());
    if (commit(edit))
        m_selection.set(m_selection.elements(), std::move(found));
}

void PatternCommands::straighten()
{
    m_document.cancelGesture();
    const auto points = planePoints(m_document.design(), m_selection);
    if (points.size() != 1 || points.begin()->second.size() != 2)
        return;
    const auto& [id, ends] = *points.begin();
    const Edit edit = edits::straighten(m_document.design(), id, ends[0], ends[1]);
    if (edit.empty()) {
        emit said(tr("This stretch is straight already."));
        return;
    }
    m_selection.set(m_selection.elements()); // the points have other numbers now
    commit(edit);
}

/// The selected seam, the first one of several between the same patches, or the one between two selected patches.
std::optional<ElementId> PatternCommands::seamToMerge() const
{
    const Design& design = m_document.design();
    const std::vector<ElementId> seams = selectedOf<Seam>(design, m_selection.elements());
    const auto joined = [&](ElementId id) {
        const Seam& seam = *design.find<Seam>(id);
        return std::minmax(seam.a.patch, seam.b.patch);
    };
    if (!seams.empty() && m_selection.elements().size() == seams.size()) {
        const std::pair<ElementId, ElementId> both = joined(seams.front());
        const bool same = std::ranges::all_of(
            seams, [&](ElementId id) { return std::pair<ElementId, ElementId>(joined(id)) == both; });
        return same ? std::optional(seams.front()) : std::nullopt;
    }
    const std::vector<ElementId> chosen = patches();
    if (chosen.size() != 2 || m_selection.elements().size() != 2)
        return std::nullopt;
    std::optional<ElementId> found;
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        const bool joins = (seam.a.patch == chosen[0] && seam.b.patch == chosen[1]) ||
                           (seam.a.patch == chosen[1] && seam.b.patch == chosen[0]);
        if (joins && !found)
            found = id;
    });
    return found;
}

void PatternCommands::merge()
{
    m_document.cancelGesture();
    const std::optional<ElementId> seam = seamToMerge();
    if (!seam)
        return;
    const ElementId stays = m_document.design().find<Seam>(*seam)->a.patch;
    if (commit(edits::mergePatches(m_document.design(), *seam)))
        m_selection.set({stays});
}

} // namespace bolster
