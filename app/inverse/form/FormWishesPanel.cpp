#include "FormWishesPanel.h"

#include "AssemblyImport.h"
#include "DesignSession.h"
#include "EarlierPieces.h"
#include "FileChoice.h"
#include "FileFormats.h"
#include "FramePieces.h"
#include "NumberBox.h"
#include "SeamLineList.h"
#include "SolverLink.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <set>
#include <utility>

namespace bolster {

namespace {

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

} // namespace

FormWishesPanel::FormWishesPanel(DesignSession& session, SolverLink& solver, QWidget* parent)
    : QWidget(parent)
    , m_session(session)
    , m_document(session.document())
    , m_solver(solver)
{
    build();
    fillForms();
    fillFabrics();
    refillLines();
}

void FormWishesPanel::build()
{
    m_form = new FileChoice(m_session, tr("The form to be covered"),
                            tr("Meshes and CAD files (%1);;All files (*)").arg(patternsOf(FileUse::Frame)), this);
    connect(m_form, &FileChoice::chosenAnew, this, [this] {
        tickLines();
        emit formChosen();
    });
    m_fabric = new QComboBox(this);
    connect(m_fabric, &QComboBox::activated, this, &FormWishesPanel::changed);
    m_grain = new QComboBox(this);
    m_grain->setToolTip(tr("Where the grain line runs on the form"));
    for (const QString& way : {tr("upwards"), tr("to the back"), tr("sideways")})
        m_grain->addItem(way);
    connect(m_grain, &QComboBox::activated, this, &FormWishesPanel::changed);
    auto* form = new QFormLayout;
    form->addRow(tr("&Form"), m_form);
    form->addRow(tr("Fa&bric"), m_fabric);
    form->addRow(tr("&Grain runs"), m_grain);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins({});
    rows->addLayout(form);
    rows->addWidget(new QLabel(tr("It is cut"), this));
    buildWaysToCut(*rows);
    m_lines = new SeamLineList(this);
    connect(m_lines, &SeamLineList::ticksChanged, this, &FormWishesPanel::changed);
    rows->addWidget(new QLabel(tr("and along the ticked lines:"), this));
    rows->addWidget(m_lines, 1);
    m_leadOn = new QPushButton(this);
    m_leadOn->setToolTip(tr("They end inside a piece (marked in the 3D view) and do not divide it: each goes on to "
                            "the border or line that is nearest, along the way shown there"));
    m_leadOn->setAutoDefault(false);
    m_leadOn->hide();
    connect(m_leadOn, &QPushButton::clicked, this, &FormWishesPanel::leadOnWanted);
    rows->addWidget(m_leadOn);
    buildOffers(*rows);
}

void FormWishesPanel::buildWaysToCut(QVBoxLayout& rows)
{
    m_groups = new QCheckBox(tr("where its &parts meet"), this);
    m_groups->setChecked(true);
    m_faces = new QCheckBox(tr("at the edges of its &CAD faces"), this);
    m_faces->setToolTip(tr("Each face as the CAD program has it, also where two go on smoothly in each other"));
    m_bends = new QCheckBox(tr("where it &bends by more than"), this);
    m_angle = new NumberBox({tr("\u00b0"), 1, 1, 179, 5}, this);
    m_angle->setAccessibleName(tr("Angle"));
    m_angle->display(35);
    connect(m_angle, &NumberBox::entered, this, [this] {
        if (m_bends->isChecked())
            emit changed();
    });
    m_divide = new QCheckBox(tr("where it would &not lie flat"), this);
    m_divide->setToolTip(
        tr("Pieces that would lie over themselves, or be strained by more than the fabric may be, are "
           "divided where they bend most or are narrow; an armchair takes some seconds"));
    for (const QCheckBox* way : {m_groups, m_faces, m_bends, m_divide})
        connect(way, &QCheckBox::toggled, this, &FormWishesPanel::changed);
    auto* bend = new QHBoxLayout;
    bend->addWidget(m_bends);
    bend->addWidget(m_angle);
    bend->addStretch(1);
    rows.addWidget(m_groups);
    rows.addWidget(m_faces);
    rows.addLayout(bend);
    rows.addWidget(m_divide);
}

void FormWishesPanel::buildOffers(QVBoxLayout& rows)
{
    m_outside = new QCheckBox(tr("Keep its cover &outside of the frame"), this);
    m_outside->setToolTip(tr("Making the pattern ticks \"Keeps the cover outside\" at the frame. A cover that is "
                             "held along its seams alone may sink into the frame or turn inside out."));
    m_outside->setChecked(true);
    connect(m_outside, &QCheckBox::toggled, this, &FormWishesPanel::outsideChanged);
    m_replace = new QCheckBox(this);
    m_replace->setToolTip(tr("Patches that this form became before go, with their seams and the curves that hold "
                             "nothing else. One Undo brings them back."));
    m_replace->setChecked(true); // two covers on one form nobody wants
    connect(m_replace, &QCheckBox::toggled, this, &FormWishesPanel::sayWhatIsFreed);
    m_replaceNote = new QLabel(this);
    m_replaceNote->setWordWrap(true);
    for (QWidget* offered : std::initializer_list<QWidget*>{m_outside, m_replace, m_replaceNote}) {
        offered->hide();
        rows.addWidget(offered);
    }
}

void FormWishesPanel::refillLines()
{
    m_lines->fill(m_document.design());
}

void FormWishesPanel::refillWaysToCut()
{
    m_faces->setVisible(!cadFile().isEmpty());
}

void FormWishesPanel::fillForms()
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

/// Its place among the forms: seldom is a cover made for legs.
int FormWishesPanel::largestOf(int frames) const
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

void FormWishesPanel::fillFabrics()
{
    m_document.design().each<Fabric>([&](ElementId id, const Fabric& fabric) {
        m_fabric->addItem(QString::fromStdString(fabric.name), number(id));
    });
    if (m_fabric->count() == 0)
        m_fabric->addItem(tr("New fabric"), number(noElement));
}

std::vector<QCheckBox*> FormWishesPanel::boxes() const
{
    return {m_groups, m_faces, m_bends, m_divide, m_outside};
}

void FormWishesPanel::fillIn(const FormPatternWishes& wishes)
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
    const std::vector<QCheckBox*> all = boxes();
    for (std::size_t k = 0; k < all.size() && k < wishes.ticks.size(); ++k) {
        const QSignalBlocker quiet(all[k]);
        all[k]->setChecked(wishes.ticks[k]);
    }
}

FormPatternWishes FormWishesPanel::wishes() const
{
    FormPatternWishes wishes{
        true, m_form->currentData(), m_fabric->currentData(), m_form->file(), m_grain->currentIndex(),
        {},   m_angle->value()};
    for (const QCheckBox* box : boxes())
        wishes.ticks.push_back(box->isChecked());
    wishes.lines = m_lines->states();
    return wishes;
}

/// Not for a form that they do not lie on, or along whose borders they lie.
void FormWishesPanel::tickLines()
{
    const bool elsewhere = isCover() || !m_form->file().isEmpty();
    if (elsewhere || m_linesElsewhere)
        m_lines->tick(m_document.design(), !elsewhere);
    m_linesElsewhere = elsewhere;
}

bool FormWishesPanel::isCover() const
{
    return m_form->currentData().toString() == "cover";
}

QString FormWishesPanel::file() const
{
    return m_form->file();
}

/// None when the form is something else.
ElementId FormWishesPanel::frameId() const
{
    return static_cast<ElementId>(m_form->currentData().toUInt());
}

ElementPtr FormWishesPanel::frameElement() const
{
    return m_document.design().element(frameId());
}

const Frame* FormWishesPanel::frame() const
{
    return m_document.design().find<Frame>(frameId());
}

ElementPtr FormWishesPanel::frameUnder() const
{
    Frame under = *frame();
    under.contact = true;
    return makeElement(std::move(under));
}

std::shared_ptr<const TriangleMesh> FormWishesPanel::mesh() const
{
    if (isCover())
        return meshOf(*m_solver.surface(), m_document.design());
    const auto file = m_session.files().meshes.find(frameId());
    return frame() && file != m_session.files().meshes.end() ? placedMesh(*frame(), file->second) : nullptr;
}

/// Of which the form is; "" when that is no CAD file, or not there any more.
QString FormWishesPanel::cadFile() const
{
    QString file = m_form->file();
    if (frame())
        file = m_session.findFile(QString::fromStdString(frame()->file));
    return isCadEnding(endingOf(file)) && QFileInfo::exists(file) ? file : QString();
}

Fabric FormWishesPanel::fabric() const
{
    const auto* found = m_document.design().find<Fabric>(static_cast<ElementId>(m_fabric->currentData().toUInt()));
    Fabric fabric = found ? *found : Fabric{};
    if (fabric.name.empty())
        fabric.name = tr("Fabric").toStdString();
    return fabric;
}

FormGrain FormWishesPanel::grain() const
{
    const std::array ways{FormGrain::up(), FormGrain::back(), FormGrain::side()};
    return ways.at(static_cast<std::size_t>(std::max(0, m_grain->currentIndex())));
}

bool FormWishesPanel::divides() const
{
    return m_divide->isChecked();
}

FormWanted FormWishesPanel::wanted() const
{
    FormWanted wanted;
    wanted.file = file();
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
    wanted.divide = divides();
    wanted.order.fabric = fabric();
    wanted.order.grain = grain();
    wanted.order.edgeLength = m_document.design().settings().edgeLength;
    return wanted;
}

bool FormWishesPanel::keepsOutside() const
{
    return frame() && (frame()->contact || (!m_outside->isHidden() && m_outside->isChecked()));
}

bool FormWishesPanel::replaces() const
{
    return !m_replace->isHidden() && m_replace->isChecked();
}

void FormWishesPanel::offer(const FormPattern* pattern)
{
    if (pattern) {
        offerOutside(*pattern);
        offerToReplace(*pattern);
        return;
    }
    for (QWidget* offered : std::initializer_list<QWidget*>{m_outside, m_replace, m_replaceNote})
        offered->hide();
}

/// Where its seams alone hold it.
void FormWishesPanel::offerOutside(const FormPattern& pattern)
{
    m_outside->setVisible(pattern.hasClosed && frame() && !frame()->contact);
}

void FormWishesPanel::offerToLeadOn(const Form* form)
{
    m_leadOn->setEnabled(form != nullptr);
    if (!form)
        return;
    const auto count = std::ranges::count_if(form->openEnds, [&](const OpenEnd& end) {
        return end.way.size() > 1 && lineEndingAt(end.way.front()) != noElement;
    });
    if (count == 0 && m_leadOn->hasFocus())
        m_lines->setFocus(); // else Close would get it
    m_leadOn->setVisible(count > 0);
    m_leadOn->setText(tr("Lead %n open ends &on", nullptr, static_cast<int>(count)));
}

ElementId FormWishesPanel::lineEndingAt(const Vec3& place) const
{
    constexpr double farthest = 30; // mm: lines may lie beside the form
    ElementId found = noElement;
    double nearest = farthest;
    for (const ElementId id : m_lines->tickedCurves()) {
        const auto* line = m_document.design().find<FixationCurve>(id);
        if (!line || line->curve.empty() || line->curve.closed())
            continue;
        for (const Vec3& end : {line->curve.points().front(), line->curve.points().back()})
            if (const double distance = (end - place).norm(); distance < nearest) {
                nearest = distance;
                found = id;
            }
    }
    return found;
}

void FormWishesPanel::offerToReplace(const FormPattern& pattern)
{
    const Design& design = m_document.design();
    const std::vector<ElementId> earlier = edits::earlierPieces(design, pattern.design);
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

void FormWishesPanel::sayWhatIsFreed()
{
    m_replaceNote->setText(tr("(%n curves that hold them will hold nothing)", nullptr, m_freed));
    m_replaceNote->setVisible(m_freed > 0 && !m_replace->isHidden() && m_replace->isChecked());
}

} // namespace bolster
