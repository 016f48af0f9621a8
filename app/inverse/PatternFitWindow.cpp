#include "PatternFitWindow.h"

#include "DesignSession.h"
#include "ElementText.h"
#include "FabricFields.h"
#include "FormChoice.h"
#include "HeadedList.h"
#include "NumberBox.h"
#include "PatternView.h"
#include "RunRow.h"
#include "SelectionEdits.h"
#include "Translated.h"
#include "Units.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScreen>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double arrowsApart = 14;  // pixels
constexpr double longestArrow = 45; // pixels
constexpr int freedomColumns = 4;
constexpr double keptShape = 0.5; // weight against strain

/// How far points of a patch would move at most, mm.
double movedBy(const FitFound& found, ElementId patch)
{
    std::vector<Freedom> own;
    std::vector<double> values;
    for (std::size_t k = 0; k < found.freedoms.size(); ++k)
        if (found.freedoms[k].element == patch) {
            own.push_back(found.freedoms[k]);
            values.push_back(found.result.values[static_cast<Eigen::Index>(k)]);
        }
    return largestChange(own, Eigen::Map<Eigen::VectorXd>(values.data(), std::ssize(values)));
}

} // namespace

PatternFitWindow::PatternFitWindow(DesignSession& session, Selection& selection, const Views& views,
                                   QWidget* parent)
    : QDialog(parent)
    , m_session(session)
    , m_document(session.document())
    , m_selection(selection)
    , m_pattern(views.pattern)
    , m_area(new AreaRow(views.cover, this))
    , m_job(
          [this](const FitWanted& wanted, const std::stop_token& stop) {
              return fitTo(
                  wanted,
                  [this, number = wanted.number](double share, const FitRound& round) {
                      m_run->later(number, [this, share, round] {
                          if (m_run->running())
                              showProgress(share, round);
                      });
                  },
                  stop);
          },
          [this](FitFound found) { take(std::move(found)); })
{
    setWindowTitle(tr("Fit the pattern to a goal"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    m_lies->setChecked(m_form->hasScans());
    m_strained->setChecked(!m_form->hasScans());
    setRunning(false);
    connect(&m_document, &Document::changed, this, &PatternFitWindow::documentChanged);
    connect(&m_document, &Document::gestureEnded, this, &PatternFitWindow::previewEnded);
    connect(&m_document, &Document::historyReplaced, this, &QDialog::close);
}

PatternFitWindow::~PatternFitWindow()
{
    m_job.cancel();
    m_gesture.reset();
    m_pattern.showArrows({});
}

void PatternFitWindow::build()
{
    m_run = new RunRow(tr("&Find changes"), tr("Fitting the pattern \u2026"), this);
    connect(m_run, &RunRow::started, this, &PatternFitWindow::find);
    connect(m_run, &RunRow::stopped, this, &PatternFitWindow::stop);
    m_said = new QLabel(this);
    m_said->setWordWrap(true);
    m_said->setMinimumHeight(2 * m_said->fontMetrics().lineSpacing());
    m_said->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_take = buttons->addButton(tr("&Take the changes"), QDialogButtonBox::AcceptRole);
    connect(m_take, &QPushButton::clicked, this, &PatternFitWindow::commit);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* layout = new QVBoxLayout(this);
    for (QWidget* group : {buildGoals(), buildFreedoms(), buildLocks()}) {
        group->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
        layout->addWidget(group);
    }
    layout->addWidget(m_run);
    layout->addWidget(m_said);
    layout->addWidget(buildOutcome(), 1);
    layout->addStretch();
    layout->addWidget(buttons);
    const QRect screenArea = screen()->availableGeometry();
    constexpr int titleBar = 40; // pixels, at most
    resize(460, std::min(800, screenArea.height() - titleBar));
    if (const QWidget* window = parentWidget()) // over the cover's margin: pattern and cover are what one looks at
        move(window->geometry().right() - width() - 24,
             std::min(window->geometry().top() + 80, screenArea.bottom() - height() - titleBar));
}

QWidget* PatternFitWindow::buildGoals()
{
    auto* box = new QGroupBox(tr("Goal"), this);
    m_lies = new QCheckBox(tr("The cover &lies on"), box);
    m_form = new FormChoice(m_session, tr("The form that the cover shall lie on"), {}, box);
    m_form->setAccessibleName(tr("Form"));
    connect(m_form, &FormChoice::fileChosen, this, [this] { m_lies->setChecked(true); });
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
void PatternFitWindow::addSelectedGoals(QVBoxLayout& rows, QWidget& box)
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

QWidget* PatternFitWindow::buildFreedoms()
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

QWidget* PatternFitWindow::buildLocks()
{
    auto* box = new QGroupBox(tr("What stays"), this);
    m_lengths = new QCheckBox(tr("L&engths of seams"), box);
    m_lengths->setToolTip(
        tr("The sides of a seam keep their difference; if it is far from the seam's ease, it comes nearer to it"));
    m_straight = new QCheckBox(tr("St&raight edges"), box);
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

QWidget* PatternFitWindow::buildOutcome()
{
    m_outcome = new QWidget(this);
    m_patches = new HeadedList({tr("Changes of"), tr("Moves by")}, 0, m_outcome);
    m_patches->setAccessibleName(tr("Changes"));
    m_patches->setToolTip(tr("What is ticked is changed"));
    m_patches->setMinimumHeight(5 * m_patches->fontMetrics().lineSpacing());
    connect(m_patches, &QTreeWidget::itemChanged, this, &PatternFitWindow::preview);
    m_share = new QSlider(Qt::Horizontal, m_outcome);
    m_share->setRange(0, 100);
    m_share->setValue(100);
    connect(m_share, &QSlider::valueChanged, this, &PatternFitWindow::preview);
    auto* label = new QLabel(tr("&How much of it"), m_outcome);
    label->setBuddy(m_share);
    m_shareSaid = new QLabel(m_outcome);
    m_shareSaid->setMinimumWidth(m_shareSaid->fontMetrics().horizontalAdvance(percentText(1)));
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(m_share, 1);
    row->addWidget(m_shareSaid);
    auto* rows = new QVBoxLayout(m_outcome);
    rows->setContentsMargins({});
    m_arrowsSaid = new QLabel(m_outcome);
    rows->addWidget(m_patches, 1);
    rows->addLayout(row);
    rows->addWidget(m_arrowsSaid);
    return m_outcome;
}

FitOrder PatternFitWindow::order() const
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
    order.goals.limit = m_limit->value();
    order.goals.keepShape = m_lies->isChecked() ? 0 : keptShape;
    if (m_area->wanted())
        order.goals.area.spots = m_area->spots();
    addSelectedGoals(order.goals);
    return order;
}

void PatternFitWindow::addSelectedGoals(FitGoals& goals) const
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

QString PatternFitWindow::missingGoal(const FitGoals& goals) const
{
    if (m_along->isChecked() && goals.seams.empty())
        return tr("Select the seam that shall run along the curve.");
    if (m_area->wanted() && goals.area.spots.empty())
        return tr("Paint the area in the 3D view, or untick it.");
    if (m_sized->isChecked() && goals.sizes.empty())
        return tr("Select the patches that shall become larger or smaller.");
    return !goals.any() && !m_lies->isChecked() ? tr("Choose a goal.") : QString();
}

void PatternFitWindow::find()
{
    if (!takeTyped(*this))
        return;
    m_document.cancelGesture();
    forget({});
    const FitForm on = m_lies->isChecked() ? m_form->form() : FitForm{};
    if (m_lies->isChecked() && (m_form->asksForFile() || on.empty())) {
        m_said->setText(tr("Choose the scan or the file that the cover shall lie on."));
        return;
    }
    FitOrder wanted = order();
    if (const QString missing = missingGoal(wanted.goals); !missing.isEmpty()) {
        m_said->setText(missing);
        return;
    }
    m_start = m_document.committed();
    setRunning(true);
    m_said->setText(tr("Solving the cover \u2026"));
    m_reached = {m_run->newRun(), wanted.freedoms, !wanted.locks.ease, {}};
    m_job.request({m_reached.number, {m_start, m_session.files()}, on, std::move(wanted)}, true);
}

void PatternFitWindow::stop()
{
    m_run->newRun();
    m_job.cancel();
    setRunning(false);
    if (m_reached.result.values.size() > 0 && !m_reached.result.values.isZero())
        show(std::move(m_reached), tr("Stopped. With all of the changes that were found until then:"));
    else
        m_said->setText(tr("Stopped; nothing has changed."));
}

void PatternFitWindow::setRunning(bool running)
{
    m_run->setRunning(running);
    m_outcome->setVisible(m_found.has_value());
    m_take->setEnabled(m_found.has_value());
}

void PatternFitWindow::showProgress(double share, const FitRound& round)
{
    m_run->setShare(share);
    m_reached.result.values = round.values;
    m_reached.result.before = round.before;
    m_reached.result.after = round.figures;
    if (m_lies->isChecked() && round.few)
        m_said->setText(
            tr("%1 from the form (rms), on few triangles at first").arg(lengthText(round.figures.distanceRms, 2)));
    else if (m_lies->isChecked())
        m_said->setText(tr("%1 from the form (rms)").arg(lengthText(round.figures.distanceRms, 2)));
    else if (m_strained->isChecked() && round.few)
        m_said->setText(tr("%1 of the cover is over the limit (before: %2), on few triangles at first")
                            .arg(percentText(round.figures.overLimit), percentText(round.before.overLimit)));
    else if (m_strained->isChecked())
        m_said->setText(tr("%1 of the cover is over the limit (before: %2)")
                            .arg(percentText(round.figures.overLimit), percentText(round.before.overLimit)));
    else
        m_said->setText(tr("Changing the pattern \u2026"));
}

void PatternFitWindow::take(FitFound found)
{
    if (!m_run->isNow(found.number))
        return;
    const FitResult& result = found.result;
    if (result.status == FitResult::Status::Failed || result.status == FitResult::Status::NothingToDo) {
        setRunning(false);
        m_said->setText(result.status == FitResult::Status::Failed ? translated(result.reason)
                        : result.rounds.empty() ? tr("Nothing is over the limits: there is nothing to do.")
                                                : tr("No change makes it better."));
        return;
    }
    show(std::move(found), tr("With all of the changes:"));
}

void PatternFitWindow::show(FitFound found, const QString& lead)
{
    const FitResult& result = found.result;
    QStringList lines{lead};
    if (m_lies->isChecked())
        lines << tr("From the form: %1 before, %2 now (rms); %3 before, %4 now (95 %)")
                     .arg(lengthText(result.before.distanceRms, 2), lengthText(result.after.distanceRms, 2),
                          lengthText(result.before.distanceP95, 2), lengthText(result.after.distanceP95, 2));
    constexpr double notable = 0.005; // of the cover
    if (m_strained->isChecked() || result.after.overLimit > result.before.overLimit + notable)
        lines << tr("Over the limit: %1 of the cover before, %2 now")
                     .arg(percentText(result.before.overLimit), percentText(result.after.overLimit));
    if (m_smooth->isChecked())
        lines << tr("Pressed together: %1 before, %2 now")
                     .arg(percentText(result.before.pressed), percentText(result.after.pressed));
    if (m_along->isChecked())
        lines << tr("From the curve: %1 before, %2 now (rms)")
                     .arg(lengthText(result.before.seamRms, 2), lengthText(result.after.seamRms, 2));
    if (m_sized->isChecked())
        lines << tr("Off the area that is wanted: %1 before, %2 now")
                     .arg(percentText(result.before.sizeMost), percentText(result.after.sizeMost));
    lines << tr("The cover moves by %1 (rms).").arg(lengthText(result.after.shapeRms, 2));
    if (result.jumped)
        lines << tr("On the way a fold came or went: look at the cover before you take it.");
    if (!result.idle.empty())
        lines << tr("%n of the numbers that may change do nothing here.", nullptr,
                    static_cast<int>(result.idle.size()));
    m_found = std::move(found);
    setRunning(false);
    m_said->setText(lines.join('\n'));
    fillPatches();
    preview();
}

void PatternFitWindow::fillPatches()
{
    const QSignalBlocker quiet(m_patches);
    m_patches->clear();
    std::set<ElementId> elements;
    for (std::size_t k = 0; k < m_found->freedoms.size(); ++k)
        if (m_found->result.values[static_cast<Eigen::Index>(k)] != 0)
            elements.insert(m_found->freedoms[k].element);
    for (const ElementId id : elements) {
        auto* row =
            new QTreeWidgetItem(m_patches, {displayName(m_start, id), lengthText(movedBy(*m_found, id), 1)});
        row->setData(0, Qt::UserRole, number(id));
        row->setCheckState(0, Qt::Checked);
    }
}

/// Of the elements that are ticked, as much as the slider says.
Design PatternFitWindow::changedDesign() const
{
    std::set<ElementId> ticked;
    for (int row = 0; row < m_patches->topLevelItemCount(); ++row)
        if (const QTreeWidgetItem* item = m_patches->topLevelItem(row); item->checkState(0) == Qt::Checked)
            ticked.insert(static_cast<ElementId>(item->data(0, Qt::UserRole).toUInt()));
    Eigen::VectorXd values = m_found->result.values * (m_share->value() / 100.0);
    for (std::size_t k = 0; k < m_found->freedoms.size(); ++k)
        if (!ticked.contains(m_found->freedoms[k].element))
            values[static_cast<Eigen::Index>(k)] = 0;
    const Design changed = withFreedoms(m_start, m_found->freedoms, values);
    return m_found->easeIsFree ? withEases(m_start, changed) : changed;
}

void PatternFitWindow::preview()
{
    if (!m_found)
        return;
    m_shareSaid->setText(percentText(m_share->value() / 100.0));
    m_take->setEnabled(m_share->value() > 0);
    if (!m_gesture || !m_gesture->active())
        m_gesture.emplace(m_document);
    const Design changed = changedDesign();
    m_gesture->update(
        editBetween(m_start, changed, {QT_TRANSLATE_NOOP("Message", "Fit the pattern to a goal"), {}}));
    const double pixel = 1 / m_pattern.navigation().transform().scale(); // mm
    PatternArrows arrows = arrowsBetween(m_start, changed, arrowsApart * pixel, longestArrow * pixel);
    m_arrowsSaid->setText(
        arrows.arrows.empty() ? QString()
        : arrows.longer > 1
            ? tr("Arrows in the pattern: %1 times as long as the way").arg(QLocale().toString(arrows.longer))
            : tr("Arrows in the pattern: where its outlines go"));
    m_pattern.showArrows(std::move(arrows));
}

void PatternFitWindow::commit()
{
    if (!m_gesture || !m_gesture->active())
        preview();
    m_found.reset(); // what the commit makes of the design is no surprise
    m_gesture->commit();
    forget(tr("Taken. Undo takes it back."));
}

/// Undo, Escape or another gesture has taken back what is shown.
void PatternFitWindow::previewEnded()
{
    if (!m_found || !m_gesture || m_gesture->active())
        return;
    m_gesture.reset();
    const QSignalBlocker quiet(m_share);
    m_share->setValue(0);
    m_shareSaid->setText(percentText(0));
    m_arrowsSaid->clear();
    m_pattern.showArrows({});
    m_take->setEnabled(false);
}

/// What was found is no longer of use.
void PatternFitWindow::forget(const QString& why)
{
    m_found.reset();
    m_gesture.reset();
    m_pattern.showArrows({});
    setRunning(m_run->running());
    m_said->setText(why);
}

/// Who works on meanwhile has another design.
void PatternFitWindow::documentChanged()
{
    if (!m_found && !m_run->running())
        return;
    if (m_run->running() && !(m_document.committed() == m_start)) {
        m_reached = {};
        stop();
        m_said->setText(tr("The design has changed meanwhile: find the changes again."));
    } else if (m_found && !(m_document.committed() == m_start)) {
        forget(tr("The design has changed meanwhile: find the changes again."));
    }
}

} // namespace bolster
