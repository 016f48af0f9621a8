#include "FormPatternWindow.h"

#include "AssemblyImport.h"
#include "CopyPaste.h"
#include "DesignJson.h"
#include "DesignSession.h"
#include "Division.h"
#include "EarlierPieces.h"
#include "ElementEdits.h"
#include "ElementText.h"
#include "FileChoice.h"
#include "FileFormats.h"
#include "FlatPiecesView.h"
#include "FormPatternReport.h"
#include "FramePieces.h"
#include "Jobs.h"
#include "NumberBox.h"
#include "PatternSize.h"
#include "SeamLineList.h"
#include "ShownScene.h"
#include "SolverLink.h"
#include "Translated.h"
#include "Units.h"
#include "ViewColors.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace bolster {

namespace {

constexpr double besidePattern = 100;   // mm
constexpr int mostLinesSaid = 9;        // that are seen at once
constexpr float hiddenLines = 0.25F;    // share of their opacity behind the form
constexpr std::size_t mostShown = 1500; // edges of what is left out
constexpr double seenBend = 12;         // degrees, of such edges

/// Mesh of a frame as it stands in the design, mm.
std::shared_ptr<const TriangleMesh> placedMesh(const Frame& frame, const std::shared_ptr<const TriangleMesh>& file)
{
    auto mesh = std::make_shared<TriangleMesh>(*shownMesh(file, frame.hiddenParts));
    for (Vec3& point : mesh->points)
        point = frame.placed(point);
    return mesh;
}

/// The cover, a part for each patch.
std::shared_ptr<const TriangleMesh> meshOf(const SurfaceMesh& surface, const Design& design)
{
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->points = surface.positions;
    mesh->triangles = surface.topology->triangles;
    for (const SurfaceTopology::PatchRange& range : surface.topology->patches) {
        const auto* patch = design.find<Patch>(range.patch);
        mesh->parts.push_back({patch ? patch->name : std::string(), range.firstTriangle, range.triangleCount});
    }
    return mesh;
}

/// Whether two frames have one shape in one place: nothing else of them makes other pieces.
bool sameShape(const Frame* a, const Frame* b)
{
    return a && b && a->file == b->file && a->hiddenParts == b->hiddenParts &&
           static_cast<const Placement&>(*a) == static_cast<const Placement&>(*b);
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
    fillForms();
    fillFabrics();
    m_lines->fill(m_document.design());
    fillIn(*m_remembered);
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
    *m_remembered = wishes();
    m_scene.setGuestLines({});
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
    splitter->addWidget(buildWishes());
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

QWidget* FormPatternWindow::buildWishes()
{
    auto* wishes = new QWidget(this);
    m_form = new FileChoice(m_session, tr("The form to be covered"),
                            tr("Meshes and CAD files (%1);;All files (*)").arg(patternsOf(FileUse::Frame)), wishes);
    connect(m_form, &FileChoice::chosenAnew, this, [this] {
        tickLines();
        formChosen();
    });
    m_fabric = new QComboBox(wishes);
    connect(m_fabric, &QComboBox::activated, this, [this] { ask(false); });
    m_grain = new QComboBox(wishes);
    m_grain->setToolTip(tr("Where the grain line runs on the form"));
    for (const QString& way : {tr("upwards"), tr("to the back"), tr("sideways")})
        m_grain->addItem(way);
    connect(m_grain, &QComboBox::activated, this, [this] { ask(false); });
    m_groups = new QCheckBox(tr("where its &parts meet"), wishes);
    m_groups->setChecked(true);
    m_faces = new QCheckBox(tr("at the edges of its &CAD faces"), wishes);
    m_faces->setToolTip(tr("Each face as the CAD program has it, also where two go on smoothly in each other"));
    m_bends = new QCheckBox(tr("where it &bends by more than"), wishes);
    m_angle = new NumberBox({tr("\u00b0"), 1, 1, 179, 5}, wishes);
    m_angle->setAccessibleName(tr("Angle"));
    m_angle->display(35);
    connect(m_groups, &QCheckBox::toggled, this, [this] { ask(false); });
    connect(m_faces, &QCheckBox::toggled, this, [this] { ask(false); });
    connect(m_bends, &QCheckBox::toggled, this, [this] { ask(false); });
    m_divide = new QCheckBox(tr("where it would &not lie flat"), wishes);
    m_divide->setToolTip(
        tr("Pieces that would lie over themselves, or be strained by more than the fabric may be, are "
           "divided where they bend most or are narrow; an armchair takes some seconds"));
    connect(m_divide, &QCheckBox::toggled, this, [this] { ask(false); });
    connect(m_angle, &NumberBox::entered, this, [this] {
        if (m_bends->isChecked())
            ask(false);
    });
    m_lines = new SeamLineList(wishes);
    connect(m_lines, &SeamLineList::ticksChanged, this, [this] { ask(false); });
    auto* bend = new QHBoxLayout;
    bend->addWidget(m_bends);
    bend->addWidget(m_angle);
    bend->addStretch(1);
    auto* form = new QFormLayout;
    form->addRow(tr("&Form"), m_form);
    form->addRow(tr("Fa&bric"), m_fabric);
    form->addRow(tr("&Grain runs"), m_grain);
    auto* rows = new QVBoxLayout(wishes);
    rows->setContentsMargins({});
    rows->addLayout(form);
    rows->addWidget(new QLabel(tr("It is cut"), wishes));
    rows->addWidget(m_groups);
    rows->addWidget(m_faces);
    rows->addLayout(bend);
    rows->addWidget(m_divide);
    rows->addWidget(new QLabel(tr("and along the ticked lines:"), wishes));
    rows->addWidget(m_lines, 1);
    m_outside = new QCheckBox(tr("Keep its cover &outside of the frame"), wishes);
    m_outside->setToolTip(tr("Making the pattern ticks \"Keeps the cover outside\" at the frame. A cover that is "
                             "held along its seams alone may sink into the frame or turn inside out."));
    m_outside->setChecked(true);
    m_outside->hide();
    rows->addWidget(m_outside);
    connect(m_outside, &QCheckBox::toggled, this, [this] {
        if (!made() || !made()->problem.empty())
            return;
        solveCover();
        say();
    });
    m_replace = new QCheckBox(wishes);
    m_replace->setToolTip(tr("Patches that this form became before go, with their seams and the curves that hold "
                             "nothing else. One Undo brings them back."));
    m_replace->hide();
    rows->addWidget(m_replace);
    connect(m_replace, &QCheckBox::toggled, this, &FormPatternWindow::sayWhatIsFreed);
    m_replaceNote = new QLabel(wishes);
    m_replaceNote->setWordWrap(true);
    m_replaceNote->hide();
    rows->addWidget(m_replaceNote);
    return wishes;
}

void FormPatternWindow::fillForms()
{
    m_document.design().each<Frame>([&](ElementId id, const Frame& frame) {
        if (m_session.files().meshes.contains(id))
            m_form->addItem(QString::fromStdString(frame.name), number(id));
    });
    const int frames = m_form->count();
    if (m_solver.surface() && !m_solver.surface()->positions.empty())
        m_form->addItem(tr("The cover as it is"), "cover");
    const bool isAlone = m_form->count() == 0; // the entry for files would look as if it were chosen
    m_form->addFiles();
    m_form->setPlaceholderText(tr("Choose a form"));
    m_form->chooseRow(isAlone ? -1 : std::max(0, largestOf(frames)));
}

std::vector<QCheckBox*> FormPatternWindow::waysToCut() const
{
    return {m_groups, m_faces, m_bends, m_divide, m_outside};
}

/// As it was when the window was closed, as far as that is still there.
void FormPatternWindow::fillIn(const FormPatternWishes& wishes)
{
    if (!wishes.known)
        return;
    if (QFileInfo::exists(wishes.file))
        m_form->chooseFile(wishes.file);
    else if (const int form = m_form->findData(wishes.form); form >= 0 && wishes.file.isEmpty())
        m_form->chooseRow(form);
    tickLines();
    m_lines->setStates(wishes.lines);
    m_fabric->setCurrentIndex(std::max(0, m_fabric->findData(wishes.fabric)));
    m_grain->setCurrentIndex(wishes.grain);
    m_angle->display(wishes.angle);
    const std::vector<QCheckBox*> boxes = waysToCut();
    for (std::size_t k = 0; k < boxes.size() && k < wishes.ticks.size(); ++k) {
        const QSignalBlocker quiet(boxes[k]);
        boxes[k]->setChecked(wishes.ticks[k]);
    }
}

FormPatternWishes FormPatternWindow::wishes() const
{
    FormPatternWishes wishes{
        true, m_form->currentData(), m_fabric->currentData(), m_form->file(), m_grain->currentIndex(),
        {},   m_angle->value()};
    for (const QCheckBox* box : waysToCut())
        wishes.ticks.push_back(box->isChecked());
    wishes.lines = m_lines->states();
    return wishes;
}

/// Its place among the forms: seldom is a cover made for legs.
int FormPatternWindow::largestOf(int frames) const
{
    int largest = -1;
    double most = -1;
    for (int row = 0; row < frames; ++row) {
        const auto id = static_cast<ElementId>(m_form->itemData(row).toUInt());
        const auto* frame = m_document.design().find<Frame>(id);
        const double size = placedMesh(*frame, m_session.files().meshes.at(id))->boundingBox().diagonal().norm();
        if (size > most) {
            most = size;
            largest = row;
        }
    }
    return largest;
}

void FormPatternWindow::fillFabrics()
{
    m_document.design().each<Fabric>([&](ElementId id, const Fabric& fabric) {
        m_fabric->addItem(QString::fromStdString(fabric.name), number(id));
    });
    if (m_fabric->count() == 0)
        m_fabric->addItem(tr("New fabric"), number(noElement));
}

void FormPatternWindow::formChosen()
{
    clear(); // pieces of another form would look like those of this one
    m_meshOf = frameElement();
    m_mesh = mesh();
    m_faces->setVisible(!cadFile().isEmpty());
    ask(false);
}

/// Not for a form that they do not lie on, or along whose borders they lie.
void FormPatternWindow::tickLines()
{
    const bool elsewhere = isCover() || !m_form->file().isEmpty();
    if (elsewhere || m_linesElsewhere)
        m_lines->tick(m_document.design(), !elsewhere);
    m_linesElsewhere = elsewhere;
}

bool FormPatternWindow::isCover() const
{
    return m_form->currentData().toString() == "cover";
}

/// None when the form is something else.
ElementId FormPatternWindow::frameId() const
{
    return static_cast<ElementId>(m_form->currentData().toUInt());
}

ElementPtr FormPatternWindow::frameElement() const
{
    return m_document.design().element(frameId());
}

/// As it keeps the cover outside.
ElementPtr FormPatternWindow::frameUnder() const
{
    Frame under = *frame();
    under.contact = true;
    return makeElement(std::move(under));
}

/// Of a frame that was moved, or is another one now; whether it was.
bool FormPatternWindow::takeMesh()
{
    const ElementPtr before = std::exchange(m_meshOf, frameElement());
    if (before == m_meshOf || sameShape(std::get_if<Frame>(before.get()), frame()))
        return false;
    m_mesh = mesh();
    return true;
}

std::shared_ptr<const TriangleMesh> FormPatternWindow::mesh() const
{
    if (isCover())
        return meshOf(*m_solver.surface(), m_document.design());
    const auto file = m_session.files().meshes.find(frameId());
    return frame() && file != m_session.files().meshes.end() ? placedMesh(*frame(), file->second) : nullptr;
}

/// That is chosen as the form; else null.
const Frame* FormPatternWindow::frame() const
{
    return m_document.design().find<Frame>(frameId());
}

/// Of which the form is; "" when that is no CAD file, or not there any more.
QString FormPatternWindow::cadFile() const
{
    QString file = m_form->file();
    if (frame())
        file = m_session.findFile(QString::fromStdString(frame()->file));
    return isCadEnding(endingOf(file)) && QFileInfo::exists(file) ? file : QString();
}

/// The frame does, or will when the pattern is made.
bool FormPatternWindow::keepsOutside() const
{
    return frame() && (frame()->contact || (!m_outside->isHidden() && m_outside->isChecked()));
}

Fabric FormPatternWindow::fabric() const
{
    const auto* found = m_document.design().find<Fabric>(static_cast<ElementId>(m_fabric->currentData().toUInt()));
    Fabric fabric = found ? *found : Fabric{};
    if (fabric.name.empty())
        fabric.name = tr("Fabric").toStdString();
    return fabric;
}

FormGrain FormPatternWindow::grain() const
{
    const std::array ways{FormGrain::up(), FormGrain::back(), FormGrain::side()};
    return ways.at(static_cast<std::size_t>(std::max(0, m_grain->currentIndex())));
}

void FormPatternWindow::ask(bool draft)
{
    m_upToDate = false;
    m_drafted = draft;
    m_coverJob.cancel();
    m_cover.reset();
    m_solving = false;
    m_make->setEnabled(false);
    if (draft && m_divide->isChecked()) { // that takes longer than a drag waits
        m_said->setText(tr("It is laid flat again when you let go."));
        return;
    }
    m_make->setText(tr("&Make the pattern"));
    m_drawn = m_document.design();
    if (!m_mesh && m_form->file().isEmpty()) {
        m_job.cancel();
        setRunning(false);
        m_said->setText(tr("Choose a file with a form above, or import a frame first."));
        return;
    }
    FormWanted wanted;
    wanted.number = ++m_asked;
    wanted.mesh = m_mesh;
    wanted.file = m_form->file();
    wanted.draft = draft;
    if (!wanted.file.isEmpty() && m_solver.surface())
        for (const Vec3& place : m_solver.surface()->positions)
            wanted.there.extend(place);
    if (frame())
        wanted.frame = *frame();
    if (m_faces->isChecked())
        wanted.cadFile = cadFile();
    wanted.cuts.groups = m_groups->isChecked();
    if (m_bends->isChecked())
        wanted.cuts.angle = m_angle->value();
    wanted.cuts.lines = m_lines->ticked(m_document.design());
    wanted.divide = m_divide->isChecked();
    wanted.progress = [this, number = wanted.number](int pieces) {
        QMetaObject::invokeMethod(this, [this, number, pieces] {
            if (m_running && number == m_asked)
                m_said->setText(tr("Dividing it, %n pieces so far \u2026", nullptr, pieces));
        });
    };
    wanted.order.fabric = fabric();
    wanted.order.grain = grain();
    wanted.order.edgeLength = m_document.design().settings().edgeLength;
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
    m_said->setText(m_made && m_made->problem.empty() ? tr("It was stopped. These are the pieces from before.")
                                                      : tr("It was stopped."));
}

void FormPatternWindow::clear()
{
    m_made.reset();
    m_replace->hide();
    m_replaceNote->hide();
    m_outside->hide();
    m_view->show(nullptr, bearableStrain(fabric()));
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
    m_view->show(m_made->problem.empty() ? m_made : nullptr, bearableStrain(fabric()));
    showOnForm();
    tellOfFile();
    offerOutside();
    offerToReplace();
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
    if (m_form->file().isEmpty() || !m_made->problem.empty() ||
        std::exchange(m_shownFile, m_form->file()) == m_form->file())
        return;
    emit fileLaidFlat(m_made->form.boundingBox());
}

/// Borders of the pieces; another colour around what is left out, and around the one under the pointer.
void FormPatternWindow::showOnForm()
{
    std::vector<SceneLine> lines;
    const std::size_t count = m_made && m_made->problem.empty() ? m_made->pattern.patches.size() : 0;
    const ViewColors colors = ViewColors::of(palette());
    const auto add = [&](const FormPiece& piece, const auto& vertices, const QColor& color, float width) {
        SceneLine line{{}, color, width, hiddenLines};
        for (const int vertex : vertices)
            line.points.push_back(m_made->form.points[piece.points[vertex]].template cast<float>());
        if (line.points.size() > 1)
            lines.push_back(std::move(line));
    };
    const auto addBorder = [&](std::size_t p, const QColor& color, float width) {
        const FormPiece& piece = m_made->form.pieces[p];
        std::vector<int> around = piece.border;
        if (!around.empty())
            around.push_back(around.front());
        add(piece, around, color, width);
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
    m_scene.setGuestLines(std::move(lines));
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
    const auto mesh = m_session.files().meshes.find(frameId());
    if (keepsOutside() && mesh != m_session.files().meshes.end()) {
        const Edit added = edits::addElement(wanted.input.design, frameUnder());
        wanted.input.design = wanted.input.design.with(added);
        wanted.input.files.meshes[added.changes.front().id] = mesh->second;
    }
    m_cover.reset();
    m_solving = true;
    m_solvedOutside = keepsOutside();
    m_coverJob.request(std::move(wanted), true);
}

/// Where its seams alone hold it.
void FormPatternWindow::offerOutside()
{
    m_outside->setVisible(m_made->pattern.hasClosed && frame() && !frame()->contact);
}

void FormPatternWindow::offerToReplace()
{
    const Design& design = m_document.design();
    const std::vector<ElementId> earlier = edits::earlierPieces(design, m_made->pattern.design);
    const auto goes = [&](ElementId id) { return std::ranges::find(earlier, id) != earlier.end(); };
    const auto count =
        std::ranges::count_if(earlier, [&](ElementId id) { return design.find<Patch>(id) != nullptr; });
    std::set<ElementId> free, held; // curves that stay
    design.each<FixationSeam>([&](ElementId, const FixationSeam& seam) {
        if (seam.hasCurve() && !goes(seam.curve))
            (goes(seam.stretch.patch) ? free : held).insert(seam.curve);
    });
    const auto left = std::ranges::count_if(free, [&](ElementId curve) { return !held.contains(curve); });
    m_replace->setVisible(count > 0);
    m_replace->setText(tr("&Replace the %n patches of these names", nullptr, static_cast<int>(count)));
    m_freed = static_cast<int>(left);
    sayWhatIsFreed();
}

void FormPatternWindow::sayWhatIsFreed()
{
    m_replaceNote->setText(tr("(%n curves that hold them will hold nothing)", nullptr, m_freed));
    m_replaceNote->setVisible(m_freed > 0 && !m_replace->isHidden() && m_replace->isChecked());
}

void FormPatternWindow::say()
{
    m_said->setText(FormPatternReport{.made = *m_made,
                                      .cover = m_cover ? &*m_cover : nullptr,
                                      .isSolved = m_solving,
                                      .divides = m_divide->isChecked(),
                                      .limit = bearableStrain(fabric()),
                                      .edgeLength = m_document.design().settings().edgeLength,
                                      .isFrame = frame() != nullptr,
                                      .keepsOutside = keepsOutside()}
                        .text());
}

/// For the history: which form, and whether it was made before.
Message FormPatternWindow::verb(bool again) const
{
    std::string name;
    if (frame())
        name = frame()->name;
    else if (!m_form->file().isEmpty())
        name = QFileInfo(m_form->file()).fileName().toStdString();
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
    const bool again = m_replace->isVisible() && m_replace->isChecked();
    if (again)
        rest = rest.with(edits::removeElements(rest, edits::earlierPieces(rest, m_made->pattern.design)));
    if (keepsOutside() && !frame()->contact)
        rest = rest.with({{}, {{frameId(), frameElement(), frameUnder()}}});
    Box2 there, own;
    m_document.design().each<Patch>([&](ElementId, const Patch& patch) {
        for (const Vec2& point : patch.outline.points())
            there.extend(toLayout(patch, point));
    });
    m_made->pattern.design.each<Patch>([&](ElementId, const Patch& patch) {
        for (const Vec2& point : patch.outline.points())
            own.extend(toLayout(patch, point));
    });
    const Vec2 offset =
        there.isEmpty() ? Vec2::Zero()
                        : Vec2(there.min().x() - own.min().x(), there.min().y() - besidePattern - own.max().y());
    Design pattern = m_made->pattern.design;
    if (again)
        pattern = edits::withEarlierPlaces(m_document.design(),
                                           edits::withEarlierNames(m_document.design(), pattern), offset);
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
        m_lines->fill(m_document.design());
    const bool moved = !m_document.gestureRunning() && takeMesh(); // else when the frame is let go
    const bool sameEdges = m_drawn.settings().edgeLength == m_document.design().settings().edgeLength;
    if (!sameLines || moved || !sameEdges)
        ask(m_document.gestureRunning());
    else if (made() && made()->problem.empty()) {
        offerOutside();
        if (keepsOutside() != m_solvedOutside)
            solveCover();
        say(); // of the frame, too
    }
}

} // namespace bolster
