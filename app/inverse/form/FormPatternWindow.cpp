#include "FormPatternWindow.h"

#include "CopyPaste.h"
#include "CurveEdits.h"
#include "DesignJson.h"
#include "DesignSession.h"
#include "Division.h"
#include "EarlierPieces.h"
#include "ElementEdits.h"
#include "FlatPiecesView.h"
#include "FormPatternReport.h"
#include "FormWishesPanel.h"
#include "Jobs.h"
#include "LayoutEdits.h"
#include "NumberBox.h"
#include "PatternSize.h"
#include "ShownScene.h"
#include "SolverLink.h"
#include "Translated.h"
#include "Units.h"
#include "ViewColors.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bolster {

namespace {

constexpr double besidePattern = 100;                   // mm
constexpr int mostLinesSaid = 9;                        // that are seen at once
constexpr float hiddenLines = 0.25F;                    // share of their opacity behind the form
constexpr std::size_t mostShown = 1500;                 // edges of what is left out
constexpr double seenBend = 12;                         // degrees, of such edges
constexpr float openEndRadius = 5, openWayWidth = 2.5F; // pixels

Box2 layoutBox(const Design& design)
{
    Box2 box;
    design.each<Patch>([&](ElementId, const Patch& patch) { box.extend(edits::layoutBox(patch)); });
    return box;
}

/// By how much `made` is moved so that it lies below all that is there.
Vec2 besideAll(const Design& design, const Design& made)
{
    const Box2 there = layoutBox(design), own = layoutBox(made);
    return there.isEmpty() ? Vec2::Zero()
                           : Vec2(there.min().x() - own.min().x(), there.min().y() - besidePattern - own.max().y());
}

/// Or begins where that began which goes, if it meets none of the rest there.
std::optional<Vec2> whereTheyWere(const Design& design, const Design& rest, const Design& made)
{
    Box2 gone;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        if (!rest.find<Patch>(id))
            gone.extend(edits::layoutBox(patch));
    });
    Box2 own = layoutBox(made);
    const Vec2 offset(gone.min().x() - own.min().x(), gone.max().y() - own.max().y());
    own.translate(offset);
    bool free = !gone.isEmpty();
    rest.each<Patch>(
        [&](ElementId, const Patch& patch) { free = free && !edits::layoutBox(patch).intersects(own); });
    return free ? std::optional(offset) : std::nullopt;
}

/// Whether two frames have one shape in one place: nothing else of them makes other pieces.
bool sameShape(const Frame* a, const Frame* b)
{
    return a && b && a->file == b->file && a->hiddenParts == b->hiddenParts &&
           static_cast<const Placement&>(*a) == static_cast<const Placement&>(*b);
}

std::vector<int> allAround(const FormPiece& piece)
{
    std::vector<int> around = piece.border;
    if (!around.empty())
        around.push_back(around.front());
    return around;
}

} // namespace

FormPatternWindow::FormPatternWindow(DesignSession& session, SolverLink& solver, ShownScene& scene,
                                     std::shared_ptr<FormPatternWishes> remembered, QWidget* parent)
    : QDialog(parent)
    , m_session(session)
    , m_document(session.document())
    , m_solver(solver)
    , m_scene(scene)
    , m_remembered(std::move(remembered))
    , m_job([job = std::make_shared<FormPatternJob>()](
                const FormWanted& wanted, const std::stop_token& stop) { return job->make(wanted, stop); },
            [this](FormMade made) { take(std::move(made)); })
    , m_coverJob(coverOfForm, [this](FormCover cover) {
        if (cover.number != m_asked || !made())
            return;
        m_solving = false;
        m_cover = std::move(cover);
        say();
    })
{
    setWindowTitle(tr("From a form"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    keepEnterInNumbers(*this);
    m_wishes->fillIn(*m_remembered);
    connect(&m_document, &Document::changed, this, &FormPatternWindow::documentChanged);
    connect(&m_document, &Document::gestureEnded, this, [this] {
        if (takeMesh() || m_drafted)
            ask(false);
    });
    connect(&m_document, &Document::historyReplaced, this, &QDialog::close);
    formChosen();
}

FormPatternWindow::~FormPatternWindow()
{
    *m_remembered = m_wishes->wishes();
    m_scene.setGuests({});
    m_job.cancel();
    m_coverJob.cancel();
}

void FormPatternWindow::build()
{
    m_view = new FlatPiecesView(this);
    connect(m_view, &FlatPiecesView::hoveredChanged, this, &FormPatternWindow::showOnForm);
    m_said = new QLabel(this);
    m_said->setWordWrap(true);
    m_said->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_said->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* said = new QScrollArea(this); // a form with many faults has many words
    said->setWidget(m_said);
    said->setWidgetResizable(true);
    said->setFrameShape(QFrame::NoFrame);
    said->setAccessibleName(tr("What came of it"));
    said->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    said->setFixedHeight(mostLinesSaid * m_said->fontMetrics().lineSpacing());
    auto* right = new QWidget(this);
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins({});
    column->addWidget(m_view, 1);
    column->addWidget(said);
    auto* splitter = new QSplitter(this);
    m_wishes = new FormWishesPanel(m_session, m_solver, this);
    connect(m_wishes, &FormWishesPanel::formChosen, this, &FormPatternWindow::formChosen);
    connect(m_wishes, &FormWishesPanel::changed, this, [this] { ask(false); });
    connect(m_wishes, &FormWishesPanel::leadOnWanted, this, &FormPatternWindow::leadLinesOn);
    connect(m_wishes, &FormWishesPanel::outsideChanged, this, [this] {
        if (!made() || !made()->problem.empty())
            return;
        solveCover();
        say();
    });
    splitter->addWidget(m_wishes);
    splitter->addWidget(right);
    splitter->setStretchFactor(1, 1);
    splitter->setChildrenCollapsible(false);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_make = buttons->addButton(tr("&Make the pattern"), QDialogButtonBox::AcceptRole);
    m_make->setDefault(true);
    connect(m_make, &QPushButton::clicked, this, &FormPatternWindow::make);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(splitter, 1);
    layout->addLayout(buildProgress());
    layout->addWidget(buttons);
    resize(760, 560);
    if (const QWidget* window = parentWidget()) // over the pattern: lines are drawn in the 3D view
        move(window->geometry().left() + 24, window->geometry().bottom() - height() - 40);
}

/// What begins anew is not where Stop was: a second click does nothing.
QLayout* FormPatternWindow::buildProgress()
{
    m_stop = new QPushButton(tr("&Stop"), this); // not among the others, which would move under the pointer
    m_stop->setAutoDefault(false);
    connect(m_stop, &QPushButton::clicked, this, &FormPatternWindow::stop);
    QSizePolicy keeps = m_stop->sizePolicy();
    keeps.setRetainSizeWhenHidden(true);
    m_stop->setSizePolicy(keeps);
    m_stop->hide();
    auto* bar = new QProgressBar(this);
    bar->setRange(0, 0);
    bar->setAccessibleName(tr("Laying a form flat \u2026"));
    m_busy = bar;
    m_idle = new QWidget(this);
    m_stopped = new QWidget(this);
    auto* again = new QPushButton(tr("&Lay it flat"), m_stopped);
    again->setAutoDefault(false);
    connect(again, &QPushButton::clicked, this, [this] { ask(false); });
    auto* row = new QHBoxLayout(m_stopped);
    row->setContentsMargins({});
    row->addWidget(again);
    row->addStretch(1);
    m_progress = new QStackedWidget(this);
    m_progress->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    for (QWidget* page : {m_idle, m_busy, m_stopped})
        m_progress->addWidget(page);
    auto* progress = new QHBoxLayout;
    progress->addWidget(m_progress, 1);
    progress->addWidget(m_stop);
    return progress;
}

void FormPatternWindow::formChosen()
{
    clear(); // pieces of another form would look like those of this one
    m_meshOf = m_wishes->frameElement();
    m_mesh = m_wishes->mesh();
    m_wishes->refillWaysToCut();
    ask(false);
}

/// Of a frame that was moved, or is another one now; whether it was.
bool FormPatternWindow::takeMesh()
{
    const ElementPtr before = std::exchange(m_meshOf, m_wishes->frameElement());
    if (before == m_meshOf || sameShape(std::get_if<Frame>(before.get()), m_wishes->frame()))
        return false;
    m_mesh = m_wishes->mesh();
    return true;
}

void FormPatternWindow::ask(bool draft)
{
    m_upToDate = false;
    m_drafted = draft;
    m_coverJob.cancel();
    m_cover.reset();
    m_solving = false;
    m_make->setEnabled(false);
    m_wishes->offerToLeadOn(nullptr);
    if (draft && m_wishes->divides()) { // that takes longer than a drag waits
        m_said->setText(tr("It is laid flat again when you let go."));
        return;
    }
    m_make->setText(tr("&Make the pattern"));
    m_drawn = m_document.design();
    if (!m_mesh && m_wishes->file().isEmpty()) {
        m_job.cancel();
        setRunning(false);
        clear(); // the frame may be gone
        m_said->setText(tr("Choose a file with a form above, or import a frame first."));
        return;
    }
    FormWanted wanted = m_wishes->wanted();
    wanted.number = ++m_asked;
    wanted.mesh = m_mesh;
    wanted.draft = draft;
    wanted.progress = [this, number = wanted.number](int pieces) {
        QMetaObject::invokeMethod(this, [this, number, pieces] {
            if (m_running && number == m_asked)
                m_said->setText(tr("Dividing it, %n pieces so far \u2026", nullptr, pieces));
        });
    };
    if (!draft)
        m_said->setText(tr("Laying it flat \u2026"));
    if (!draft)
        setRunning(true);
    m_job.request(std::move(wanted), !draft);
}

void FormPatternWindow::setRunning(bool running)
{
    m_stop->setVisible(running);
    m_progress->setCurrentWidget(running ? m_busy : m_idle);
    if (running == static_cast<bool>(m_running))
        return;
    m_running =
        running ? std::make_unique<RunningJob>(tr("Laying a form flat \u2026"), [this] { stop(); }) : nullptr;
}

void FormPatternWindow::stop()
{
    m_job.cancel();
    ++m_asked; // what is on its way comes too late
    setRunning(false);
    m_progress->setCurrentWidget(m_stopped);
    const bool hasPieces = m_made && m_made->problem.empty() && !m_made->pattern.isEmpty();
    m_said->setText(hasPieces ? tr("It was stopped. These are the pieces from before.") : tr("It was stopped."));
}

void FormPatternWindow::clear()
{
    m_made.reset();
    m_wishes->offer(nullptr);
    const Form none;
    m_wishes->offerToLeadOn(&none);
    m_view->show(nullptr, bearableStrain(m_wishes->fabric()));
    showOnForm();
}

void FormPatternWindow::take(FormMade made)
{
    const bool newest = made.number == m_asked;
    if (!newest && !made.draft)
        return;
    m_upToDate = newest;
    if (newest && !made.draft)
        setRunning(false);
    m_made = std::make_shared<FormMade>(std::move(made));
    m_view->show(m_made->problem.empty() ? m_made : nullptr, bearableStrain(m_wishes->fabric()));
    showOnForm();
    tellOfFile();
    m_wishes->offer(&m_made->pattern);
    m_wishes->offerToLeadOn(this->made() ? &m_made->form : nullptr);
    solveCover();
    const FormPattern& pattern = m_made->pattern;
    const bool whole = pattern.isEmpty() || std::ranges::count(pattern.patches, noElement) == 0;
    m_make->setText(whole ? tr("&Make the pattern") : tr("&Make it without what is left out"));
    m_make->setEnabled(this->made() && m_made->problem.empty() && !pattern.isEmpty());
    say();
}

/// Where nobody has looked yet.
void FormPatternWindow::tellOfFile()
{
    const QString file = m_wishes->file();
    if (!file.isEmpty() && m_made->problem.empty() && std::exchange(m_shownFile, file) != file)
        emit fileLaidFlat(m_made->form.boundingBox());
}

/// Borders of the pieces; another colour around what is left out, and around the one under the pointer.
void FormPatternWindow::showOnForm()
{
    GuestMarks marks;
    const std::size_t count = m_made && m_made->problem.empty() ? m_made->pattern.patches.size() : 0;
    const ViewColors colors = ViewColors::of(palette());
    const auto add = [&](const FormPiece& piece, const auto& vertices, const QColor& color, float width) {
        SceneLine line{{}, color, width, hiddenLines};
        for (const int vertex : vertices)
            line.points.push_back(m_made->form.points[piece.points[vertex]].template cast<float>());
        if (line.points.size() > 1)
            marks.lines.push_back(std::move(line));
    };
    const auto addBorder = [&](std::size_t p, const QColor& color, float width) {
        add(m_made->form.pieces[p], allAround(m_made->form.pieces[p]), color, width);
    };
    for (std::size_t p = 0; p < count; ++p)
        addBorder(p, colors.snap, 1.5F);
    for (std::size_t p = 0; p < count; ++p) { // over those of their neighbours
        if (m_made->pattern.patches[p] != noElement)
            continue;
        addBorder(p, colors.error, 3);
        const FormPiece& piece = m_made->form.pieces[p]; // what is closed has no border to speak of
        const std::vector<std::array<int, 2>> edges = bentEdges(m_made->form, piece, seenBend);
        for (std::size_t k = 0; k < edges.size(); k += edges.size() / mostShown + 1)
            add(piece, edges[k], colors.error, 1.5F);
        for (std::size_t t = 0; edges.empty() && t < piece.triangles.size();
             t += piece.triangles.size() / mostShown + 1)
            add(piece, piece.triangles[t], colors.error, 1.5F);
    }
    if (m_view->hovered() && *m_view->hovered() < count)
        addBorder(*m_view->hovered(), colors.hover, 4);
    if (count > 0)
        addOpenEnds(marks);
    for (std::size_t p = 0; p < count; ++p) {
        const FormPiece& piece = m_made->form.pieces[p];
        std::vector<Vec3>& places = marks.catching.emplace_back();
        for (const int vertex : allAround(piece))
            places.push_back(m_made->form.points[piece.points[vertex]]);
    }
    m_scene.setGuests(std::move(marks));
}

/// Where lines end that divide nothing, and the nearest way on from there.
void FormPatternWindow::addOpenEnds(GuestMarks& marks) const
{
    const ViewColors colors = ViewColors::of(palette());
    for (const OpenEnd& end : m_made->form.openEnds) {
        marks.dots.push_back({end.way.front().cast<float>(), colors.warning, Qt::white, openEndRadius});
        SceneLine way{{}, colors.warning, openWayWidth, hiddenLines};
        for (const Vec3& place : end.way)
            way.points.push_back(place.cast<float>());
        if (way.points.size() > 1)
            marks.lines.push_back(std::move(way));
    }
}

/// Lines that end inside pieces go on to what is nearest, as it is shown.
void FormPatternWindow::leadLinesOn()
{
    if (!made())
        return;
    m_document.cancelGesture();
    const Design& before = m_document.design();
    Design design = before;
    for (const OpenEnd& end : made()->form.openEnds)
        if (const ElementId line = m_wishes->lineEndingAt(end.way.front()); line != noElement)
            design = design.with(edits::leadCurveOn(design, line, end.way));
    m_document.commit(editBetween(before, design, {QT_TRANSLATE_NOOP("Message", "Lead open seam lines on"), {}}));
}

/// What its cover will be like: laid flat, nothing holds it where it is strained most.
void FormPatternWindow::solveCover()
{
    const FormMade* now = made();
    if (!now || !now->problem.empty() || now->pattern.isEmpty() ||
        vertexCount(patternArea(now->pattern.design), now->pattern.design.settings().edgeLength) >
            FormPattern::manyVertices)
        return;
    FormCoverWanted wanted{m_asked, {now->pattern.design}, m_made};
    const auto mesh = m_session.files().meshes.find(m_wishes->frameId());
    if (m_wishes->keepsOutside() && mesh != m_session.files().meshes.end()) {
        const Edit added = edits::addElement(wanted.input.design, m_wishes->frameUnder());
        wanted.input.design = wanted.input.design.with(added);
        wanted.input.files.meshes[added.changes.front().id] = mesh->second;
    }
    m_cover.reset();
    m_solving = true;
    m_solvedOutside = m_wishes->keepsOutside();
    m_coverJob.request(std::move(wanted), true);
}

void FormPatternWindow::say()
{
    m_said->setText(FormPatternReport{.made = *m_made,
                                      .cover = m_cover ? &*m_cover : nullptr,
                                      .isSolved = m_solving,
                                      .divides = m_wishes->divides(),
                                      .limit = bearableStrain(m_wishes->fabric()),
                                      .edgeLength = m_document.design().settings().edgeLength,
                                      .isFrame = m_wishes->frame() != nullptr,
                                      .keepsOutside = m_wishes->keepsOutside()}
                        .text());
}

/// For the history: which form, and whether it was made before.
Message FormPatternWindow::verb(bool again) const
{
    std::string name;
    if (const Frame* frame = m_wishes->frame())
        name = frame->name;
    else if (!m_wishes->file().isEmpty())
        name = QFileInfo(m_wishes->file()).fileName().toStdString();
    if (name.empty())
        return {again ? QT_TRANSLATE_NOOP("Message", "Make the pattern of a form again")
                      : QT_TRANSLATE_NOOP("Message", "Make the pattern of a form"),
                {}};
    return {again ? QT_TRANSLATE_NOOP("Message", "Make the pattern of %1 again")
                  : QT_TRANSLATE_NOOP("Message", "Make the pattern of %1"),
            {name}};
}

void FormPatternWindow::make()
{
    if (!made())
        return;
    m_document.cancelGesture();
    Design rest = m_document.design();
    const bool again = m_wishes->replaces();
    if (again)
        rest = rest.with(edits::removeElements(rest, edits::earlierPieces(rest, m_made->pattern.design)));
    if (m_wishes->keepsOutside() && !m_wishes->frame()->contact)
        rest = rest.with({{}, {{m_wishes->frameId(), m_wishes->frameElement(), m_wishes->frameUnder()}}});
    Design pattern = m_made->pattern.design;
    Vec2 offset = besideAll(m_document.design(), pattern);
    if (again) {
        pattern = edits::withEarlierNames(m_document.design(), pattern);
        if (std::optional<Design> placed = edits::withEarlierPlaces(m_document.design(), pattern)) {
            pattern = std::move(*placed);
            offset = Vec2::Zero();
        } else if (const std::optional<Vec2> there = whereTheyWere(m_document.design(), rest, pattern)) {
            offset = *there;
        }
    }
    const edits::Outcome outcome = edits::paste(rest, writeDesign(pattern), offset);
    if (outcome.edit.empty()) {
        m_said->setText(translated(outcome.problem));
        return;
    }
    const std::vector<ElementId> added = edits::addedPieces(outcome.edit);
    m_document.commit(editBetween(m_document.design(), rest.with(outcome.edit), verb(again)));
    emit patternMade(added, m_made->form.boundingBox());
    close();
}

void FormPatternWindow::documentChanged()
{
    const auto curvesOf = [](const Design& design) {
        std::map<ElementId, ElementPtr> curves;
        design.each<FixationCurve>([&](ElementId id, const FixationCurve&) { curves[id] = design.element(id); });
        return curves;
    };
    const bool sameLines = curvesOf(m_drawn) == curvesOf(m_document.design());
    if (!sameLines)
        m_wishes->refillLines();
    const bool moved = !m_document.gestureRunning() && takeMesh(); // else when the frame is let go
    const bool sameEdges = m_drawn.settings().edgeLength == m_document.design().settings().edgeLength;
    if (!sameLines || moved || !sameEdges)
        ask(m_document.gestureRunning());
    else if (made() && made()->problem.empty()) {
        m_wishes->offerOutside(made()->pattern);
        if (m_wishes->keepsOutside() != m_solvedOutside)
            solveCover();
        say(); // of the frame, too
    }
}

} // namespace bolster
