#include "FitOrderPanel.h"

#include "DesignSession.h"
#include "Document.h"
#include "ElementText.h"
#include "FabricFields.h"
#include "FormChoice.h"
#include "NumberBox.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "Units.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace bolster {

namespace {

constexpr int freedomColumns = 4;

} // namespace

FitOrderPanel::FitOrderPanel(DesignSession& session, Selection& selection, const AreaRow::Parts& cover,
                             QWidget* parent)
    : QWidget(parent)
    , m_session(session)
    , m_document(session.document())
    , m_selection(selection)
    , m_area(new AreaRow(cover, this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    for (QWidget* group : {buildGoals(), buildFreedoms(), buildLocks()}) {
        group->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
        layout->addWidget(group);
    }
    m_lies->setChecked(m_form->hasScans());
    m_strained->setChecked(!m_form->hasScans());
}

FitForm FitOrderPanel::form() const
{
    return m_lies->isChecked() ? m_form->form() : FitForm{};
}

FitOrderPanel::Goals FitOrderPanel::goals() const
{
    return {m_lies->isChecked(), m_strained->isChecked(), m_smooth->isChecked(), m_along->isChecked(),
            m_sized->isChecked()};
}

QWidget* FitOrderPanel::buildGoals()
{
    auto* box = new QGroupBox(tr("Goal"), this);
    m_lies = new QCheckBox(tr("The cover &lies on"), box);
    m_form = new FormChoice(m_session, tr("The form that the cover shall lie on"), {}, box);
    m_form->setAccessibleName(tr("Form"));
    connect(m_form, &FormChoice::fileChosen, this, [this] { m_lies->setChecked(true); });
    connect(m_lies, &QCheckBox::clicked, this, [this](bool wanted) {
        if (wanted)
            m_form->asksForFile({});
    });
    m_strained = new QCheckBox(tr("&Strain is at most"), box);
    m_strained->setToolTip(tr("Along the grain, across it, and in shear; the cover stays where it is"));
    m_limit = new NumberBox({tr(" %"), 2, strainLimit.least, strainLimit.most, 0.5}, box);
    m_limit->setAccessibleName(tr("Limit of strain"));
    m_limit->display(StretchLimits{}.along);
    auto* rows = new QVBoxLayout(box);
    auto* first = new QHBoxLayout;
    first->addWidget(m_lies);
    first->addWidget(m_form, 1);
    auto* second = new QHBoxLayout;
    second->addWidget(m_strained);
    second->addWidget(m_limit);
    second->addStretch(1);
    rows->addLayout(first);
    rows->addLayout(second);
    rows->addWidget(m_area);
    addSelectedGoals(*rows, *box);
    return box;
}

/// Goals of what is selected when the search begins.
void FitOrderPanel::addSelectedGoals(QVBoxLayout& rows, QWidget& box)
{
    const auto add = [&](const QString& text, const QString& tip, QWidget* more) {
        auto* check = new QCheckBox(text, &box);
        check->setToolTip(tip);
        auto* row = new QHBoxLayout;
        row->addWidget(check);
        if (more) {
            row->addWidget(more, 1);
            more->setEnabled(false);
            connect(check, &QCheckBox::toggled, more, &QWidget::setEnabled);
        }
        rows.addLayout(row);
        return check;
    };
    m_smooth = add(tr("&No folds in selected patches"),
                   tr("No cloth of them is pressed together; none selected: all"), nullptr);
    m_curve = new QComboBox(&box);
    m_curve->setAccessibleName(tr("Curve"));
    m_curve->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_document.design().each<FixationCurve>([&](ElementId id, const FixationCurve& curve) {
        m_curve->addItem(QString::fromStdString(curve.name), number(id));
    });
    m_along = add(tr("The selected seam r&uns along"),
                  tr("A curve drawn on the frame or the form; it need hold nothing"), m_curve);
    m_along->setEnabled(m_curve->count() > 0);
    m_size = new NumberBox({tr(" %"), 1, 10, 1000, 1}, &box);
    m_size->setAccessibleName(tr("Share of the area"));
    m_size->display(95);
    m_sized = add(tr("Area of selected patches &becomes"), tr("Less than 100 %: they become smaller"), m_size);
}

QWidget* FitOrderPanel::buildFreedoms()
{
    auto* box = new QGroupBox(tr("What may change"), this);
    auto* grid = new QGridLayout;
    int count = 0;
    const auto add = [&](const QString& text, const QString& tip) {
        auto* check = new QCheckBox(text, box);
        check->setToolTip(tip);
        grid->addWidget(check, count / freedomColumns, count % freedomColumns);
        ++count;
        return check;
    };
    m_outlines = add(tr("&Outlines"), tr("Control points of the patches"));
    m_seams = add(tr("Ends of seams"), tr("Where seams and fixations end on smooth edges"));
    m_ease = add(tr("Ease"), tr("Sides of seams may come to differ in length; that is then the ease wanted"));
    m_foam = add(tr("Fo&am"), tr("How thick cushions and foam are, by whole voxels"));
    m_fixations =
        add(tr("F&ixations"), tr("Where fixation curves lie: on their frames, or in space where there is none"));
    m_pressure = add(tr("&Pressure"), tr("The pressure under each patch"));
    m_stretch = add(tr("Stretch"), tr("Stiffness of the fabrics, and how much they contract across a pull"));
    m_outlines->setChecked(true);
    grid->setColumnStretch(freedomColumns, 1);
    m_selectedOnly = new QCheckBox(tr("Of sele&cted patches only"), box);
    auto* rows = new QVBoxLayout(box);
    rows->addLayout(grid);
    rows->addWidget(m_selectedOnly);
    return box;
}

QWidget* FitOrderPanel::buildLocks()
{
    auto* box = new QGroupBox(tr("What stays"), this);
    m_lengths = new QCheckBox(tr("L&engths of seams"), box);
    m_lengths->setToolTip(
        tr("The sides of a seam keep their difference; if it is far from the seam's ease, it comes nearer to it"));
    m_straight = new QCheckBox(tr("St&raight edges"), box);
    m_straight->setToolTip(tr("Edges that look straight stay so: those that bow by less than %1 in %2")
                               .arg(lengthText(1000 * FitLocks::straightShare, 1), lengthText(1000, 0)));
    m_corners = new QCheckBox(tr("An&gles of corners"), box);
    m_lengths->setChecked(true);
    m_straight->setChecked(true);
    auto* checks = new QHBoxLayout;
    for (QCheckBox* check : {m_lengths, m_straight, m_corners})
        checks->addWidget(check);
    checks->addStretch(1);
    m_most = new NumberBox({millimetreSuffix, 2, FitOrder::leastChange, FitOrder::farthestChange, 1, true}, box);
    m_most->display(20);
    auto* label = new QLabel(tr("No point &moves farther than"), box);
    label->setBuddy(m_most);
    auto* most = new QHBoxLayout;
    most->addWidget(label);
    most->addWidget(m_most);
    most->addStretch(1);
    auto* rows = new QVBoxLayout(box);
    rows->addLayout(checks);
    rows->addLayout(most);
    return box;
}

FitOrder FitOrderPanel::order() const
{
    const Design& design = m_document.committed();
    FitOrder order;
    const std::vector<ElementId> chosen = selectedOf<Patch>(design, m_selection.elements());
    const bool onlyChosen = m_selectedOnly->isChecked() && !chosen.empty();
    const auto add = [&](const QCheckBox* check, std::vector<Freedom> freedoms) {
        if (check->isChecked())
            for (Freedom& freedom : freedoms)
                if (!onlyChosen || !design.find<Patch>(freedom.element) ||
                    std::ranges::find(chosen, freedom.element) != chosen.end())
                    order.freedoms.push_back(std::move(freedom));
    };
    add(m_outlines, outlineFreedoms(design));
    add(m_foam, foamFreedoms(design));
    if (m_fixations->isChecked()) // frames are large
        add(m_fixations, fixationFreedoms(design, m_session.files()));
    add(m_pressure, pressureFreedoms(design));
    add(m_stretch, stretchFreedoms(design));
    add(m_seams, seamEndFreedoms(design));
    order.locks.ease = !m_ease->isChecked();
    order.locks.lengths = m_lengths->isChecked();
    order.locks.straight = m_straight->isChecked();
    order.locks.corners = m_corners->isChecked();
    order.mostChange = m_most->value();
    order.goals.strain = m_strained->isChecked();
    if (m_strained->isChecked()) // else those of the fabrics
        order.goals.limit = m_limit->value();
    order.goals.keepShape = m_lies->isChecked() ? 0 : FitGoals::lightly;
    if (m_area->wanted())
        order.goals.area.spots = m_area->spots();
    addSelectedGoals(order.goals);
    return order;
}

void FitOrderPanel::addSelectedGoals(FitGoals& goals) const
{
    const Design& design = m_document.committed();
    const std::vector<ElementId> patches = selectedOf<Patch>(design, m_selection.elements());
    if (m_smooth->isChecked()) {
        goals.smooth.insert(patches.begin(), patches.end());
        if (patches.empty())
            design.each<Patch>([&](ElementId id, const Patch&) { goals.smooth.insert(id); });
    }
    if (const auto* curve = design.find<FixationCurve>(static_cast<ElementId>(m_curve->currentData().toUInt()));
        m_along->isChecked() && curve)
        for (const ElementId seam : selectedOf<Seam>(design, m_selection.elements()))
            goals.seams.push_back({seam, curve->curve});
    if (m_sized->isChecked())
        for (const ElementId patch : patches)
            goals.sizes.push_back({patch, m_size->value() / 100});
}

FitWishes FitOrderPanel::wishes() const
{
    FitWishes wishes;
    for (const QCheckBox* box : findChildren<QCheckBox*>())
        wishes.ticks.push_back(box->isChecked());
    for (const NumberBox* number : findChildren<NumberBox*>())
        wishes.numbers.push_back(number->value());
    wishes.form = m_form->chosen();
    wishes.spots = m_area->spots();
    return wishes;
}

void FitOrderPanel::fillIn(const FitWishes& wishes)
{
    const QList<QCheckBox*> boxes = findChildren<QCheckBox*>();
    const QList<NumberBox*> numbers = findChildren<NumberBox*>();
    if (std::ssize(wishes.ticks) != boxes.size() || std::ssize(wishes.numbers) != numbers.size())
        return;
    m_form->choose(wishes.form);
    m_area->setSpots(wishes.spots);
    for (qsizetype k = 0; k < numbers.size(); ++k)
        numbers[k]->display(wishes.numbers[static_cast<std::size_t>(k)]);
    for (qsizetype k = 0; k < boxes.size(); ++k)
        if (boxes[k]->isEnabled()) // there may be no curves any more
            boxes[k]->setChecked(wishes.ticks[static_cast<std::size_t>(k)]);
}

QString FitOrderPanel::missing(const FitOrder& order, const std::function<void()>& then) const
{
    const FitGoals& goals = order.goals;
    if (m_lies->isChecked() && (m_form->asksForFile(then) || m_form->form().empty()))
        return tr("Choose the scan or the file that the cover shall lie on.");
    if (m_along->isChecked() && goals.seams.empty())
        return tr("Select the seam that shall run along the curve.");
    if (m_area->wanted() && goals.area.spots.empty())
        return tr("Paint the area in the 3D view, or untick it.");
    if (m_sized->isChecked() && goals.sizes.empty())
        return tr("Select the patches that shall become larger or smaller.");
    return !goals.any() && !m_lies->isChecked() ? tr("Choose a goal.") : QString();
}

} // namespace bolster
