#include "PatternCommands.h"

#include "Actions.h"
#include "CopyPaste.h"
#include "Document.h"
#include "ElementEdits.h"
#include "ElementText.h"
#include "LayoutEdits.h"
#include "PatchShapeEdits.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "Translated.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>

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

} // namespace bolster
