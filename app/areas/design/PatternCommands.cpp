#include "PatternCommands.h"

#include "Commands.h"
#include "CopyPaste.h"
#include "Document.h"
#include "ElementEdits.h"
#include "LayoutEdits.h"
#include "PatchEdits.h"
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

} // namespace

PatternCommands::PatternCommands(Document& document, Selection& selection, Commands& commands, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_selection(selection)
{
    addClipboard(commands);
    addTurns(commands);
    addAlignment(commands);
    addPoints(commands);
    addEdges(commands);
    connect(QGuiApplication::clipboard(), &QClipboard::dataChanged, this,
            [&commands] { commands.update({"edit.paste"}); });
}

void PatternCommands::addClipboard(Commands& commands)
{
    const auto copies = [this] { return edits::canCopy(m_document.design(), selected()); };
    // What a text says is looked at when it is pasted: fetching it from another program can take long.
    const auto pastes = [] {
        const QMimeData* data = QGuiApplication::clipboard()->mimeData();
        return data && (data->hasFormat(mimeType) || data->hasText());
    };
    commands.add({{.id = "edit.cut",
                   .formerly = "cut",
                   .text = tr("Cu&t"),
                   .keys = {QKeySequence::Cut},
                   .places = {"edit/2"},
                   .enabled = copies,
                   .does = [this] { cut(); }},
                  {.id = "edit.copy",
                   .formerly = "copy",
                   .text = tr("&Copy"),
                   .keys = {QKeySequence::Copy},
                   .places = {"edit/2"},
                   .enabled = copies,
                   .does = [this] { copy(); }},
                  {.id = "edit.paste",
                   .formerly = "paste",
                   .text = tr("&Paste"),
                   .keys = {QKeySequence::Paste},
                   .places = {"edit/2"},
                   .enabled = pastes,
                   .does = [this] { paste(); }},
                  {.id = "edit.duplicate",
                   .formerly = "duplicate",
                   .text = tr("Dupl&icate"),
                   .keys = {Qt::CTRL | Qt::Key_D},
                   .places = {"edit/2"},
                   .enabled = copies,
                   .does = [this] { duplicate(); }}});
}

void PatternCommands::addTurns(Commands& commands)
{
    commands.add(MenuPlace{"pattern.arrange", tr("Arran&ge"), "pattern/2"});
    const auto any = [this] { return !patches().empty(); };
    commands.add({{.id = "layout.turn-left",
                   .formerly = "turn-90-to-the-left",
                   .text = tr("Turn 90\u00b0 to the &left"),
                   .icon = "rotate-left",
                   .keys = {Qt::CTRL | Qt::Key_L},
                   .places = {"pattern.arrange/1"},
                   .enabled = any,
                   .does = [this] { turn(90); }},
                  {.id = "layout.turn-right",
                   .formerly = "turn-90-to-the-right",
                   .text = tr("Turn 90\u00b0 to the &right"),
                   .icon = "rotate-right",
                   .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_L},
                   .places = {"pattern.arrange/1"},
                   .enabled = any,
                   .does = [this] { turn(-90); }},
                  {.id = "layout.mirror-horizontally",
                   .formerly = "mirror-horizontally",
                   .text = tr("Mirror hori&zontally"),
                   .keys = {Qt::CTRL | Qt::Key_M},
                   .places = {"pattern.arrange/1"},
                   .enabled = any,
                   .does = [this] { mirror(true); }},
                  {.id = "layout.mirror-vertically",
                   .formerly = "mirror-vertically",
                   .text = tr("Mirror &vertically"),
                   .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_M},
                   .places = {"pattern.arrange/1"},
                   .enabled = any,
                   .does = [this] { mirror(false); }}});
}

void PatternCommands::addAlignment(Commands& commands)
{
    commands.add(MenuPlace{"pattern.align", tr("Al&ign"), "pattern.arrange/2"});
    const auto align = [&](edits::Alignment alignment, const char* id, const char* formerly, const QString& text) {
        commands.add({.id = id,
                      .formerly = formerly,
                      .text = text,
                      .places = {"pattern.align/1"},
                      .enabled = [this] { return patches().size() >= 2; },
                      .does =
                          [this, alignment] {
                              m_document.cancelGesture();
                              commit(edits::alignPatches(m_document.design(), patches(), alignment));
                          }});
    };
    using edits::Alignment;
    align(Alignment::Left, "layout.align-left", "left-edges", tr("&Left edges"));
    align(Alignment::CentreX, "layout.align-column", "centres-in-a-column", tr("Centres in a &column"));
    align(Alignment::Right, "layout.align-right", "right-edges", tr("&Right edges"));
    align(Alignment::Top, "layout.align-top", "top-edges", tr("&Top edges"));
    align(Alignment::CentreY, "layout.align-row", "centres-in-a-row", tr("Centres in a ro&w"));
    align(Alignment::Bottom, "layout.align-bottom", "bottom-edges", tr("&Bottom edges"));

    commands.add(MenuPlace{"pattern.distribute", tr("&Distribute"), "pattern.arrange/2"});
    const auto distribute = [&](edits::Direction direction, const char* id, const char* formerly,
                                const QString& text) {
        commands.add({.id = id,
                      .formerly = formerly,
                      .text = text,
                      .places = {"pattern.distribute/1"},
                      .enabled = [this] { return patches().size() >= 3; },
                      .does =
                          [this, direction] {
                              m_document.cancelGesture();
                              commit(edits::distributePatches(m_document.design(), patches(), direction));
                          }});
    };
    using edits::Direction;
    distribute(Direction::Horizontal, "layout.distribute-horizontally", "horizontally", tr("&Horizontally"));
    distribute(Direction::Vertical, "layout.distribute-vertically", "vertically", tr("&Vertically"));

    const auto any = [this] {
        bool found = false;
        m_document.design().each<Patch>([&](ElementId, const Patch&) { found = true; });
        return found;
    };
    commands.add({.id = "layout.arrange",
                  .formerly = "arrange-automatically",
                  .text = tr("Arrange &automatically"),
                  .keys = {Qt::CTRL | Qt::Key_R},
                  .places = {"pattern.arrange/2"},
                  .enabled = any,
                  .does = [this] {
                      m_document.cancelGesture();
                      const std::vector<ElementId> chosen = patches();
                      commit(edits::arrangePatches(m_document.design(),
                                                   chosen.size() > 1 ? chosen : std::vector<ElementId>()));
                  }});
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
    m_document.commit(outcome);
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

/// About the middle of the selected patches.
void PatternCommands::turn(double degrees)
{
    m_document.cancelGesture();
    const std::vector<ElementId> chosen = patches();
    Box2 box;
    for (const ElementId id : chosen) {
        const Patch& patch = *m_document.design().find<Patch>(id);
        for (const Vec2& point : patch.outline.points())
            box.extend(toLayout(patch, point));
    }
    if (!box.isEmpty())
        m_document.commit(edits::turnPatches(m_document.design(), chosen, box.center(), degrees));
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
