#include "PatternFitWindow.h"

#include "ColumnScroll.h"
#include "DesignSession.h"
#include "ElementText.h"
#include "FitChange.h"
#include "FitOrderPanel.h"
#include "HeadedList.h"
#include "NumberBox.h"
#include "PatternView.h"
#include "PullNote.h"
#include "Pulls.h"
#include "RunRow.h"
#include "Translated.h"
#include "Units.h"

#include <QDialogButtonBox>
#include <QFileInfo>
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
#include <utility>

namespace bolster {

namespace {

constexpr double arrowsApart = 14;  // pixels
constexpr double longestArrow = 45; // pixels
constexpr int titleBar = 40;        // pixels, at most
constexpr int leastWished = 10;     // lines of it that are seen however low the screen is
constexpr int usualLines = 2;       // that there is always room for
constexpr int restOfSlider = 250;   // ms, before a part of the changes is measured

/// How far points of a patch would move at most with all of the change, mm.
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

/// Room for a text, so many pixels wide; no less than there was before.
void keepRoom(QLabel& label, int width, const QString& text)
{
    const QRect wide(0, 0, width, QWIDGETSIZE_MAX);
    const int high = label.fontMetrics().boundingRect(wide, Qt::TextWordWrap, text).height();
    label.setMinimumHeight(std::max(label.minimumHeight(), high));
}

} // namespace

PatternFitWindow::PatternFitWindow(DesignSession& session, Selection& selection, const Views& views,
                                   std::shared_ptr<FitMemory> remembered, QWidget* parent)
    : QDialog(parent)
    , m_session(session)
    , m_document(session.document())
    , m_pattern(views.pattern)
    , m_order(new FitOrderPanel(session, selection, views.cover, this))
    , m_remembered(std::move(remembered))
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
    , m_measuring(measurePart, [this](const PartFound& found) { takePart(found); })
{
    setWindowTitle(tr("Fit to a goal"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_slider.setSingleShot(true);
    m_slider.setInterval(restOfSlider);
    connect(&m_slider, &QTimer::timeout, this, &PatternFitWindow::measure);
    build();
    keepEnterInNumbers(*this);
    m_order->fillIn(m_remembered->wishes);
    setRunning(false);
    recall();
    connect(&m_document, &Document::changed, this, &PatternFitWindow::documentChanged);
    connect(&m_document, &Document::gestureEnded, this, &PatternFitWindow::previewEnded);
    connect(&m_document, &Document::historyReplaced, this, &QDialog::close);
}

PatternFitWindow::~PatternFitWindow()
{
    m_job.cancel();
    m_measuring.cancel();
    m_gesture.reset();
    m_pattern.showArrows({});
    *m_remembered = {m_order->wishes(), std::move(m_start), std::move(m_wanted),
                     m_sought,          std::move(m_found), m_lead,
                     m_whole,           std::move(m_taken), m_takenFigures};
}

void PatternFitWindow::recall()
{
    if (!m_remembered->found)
        return;
    m_start = m_remembered->start;
    m_wanted = m_remembered->wanted;
    m_sought = m_remembered->sought;
    m_found = m_remembered->found;
    m_lead = m_remembered->lead;
    m_whole = m_remembered->whole;
    m_taken = m_remembered->taken;
    m_takenFigures = m_remembered->takenFigures;
    fillPatches();
    m_aside = true;
    documentChanged();
}

void PatternFitWindow::build()
{
    m_run = new RunRow(tr("&Find changes"), tr("Fitting the pattern \u2026"), this);
    connect(m_run, &RunRow::started, this, &PatternFitWindow::find);
    connect(m_run, &RunRow::stopped, this, &PatternFitWindow::stop);
    m_said = new QLabel(tr("Changes the pattern until the cover is as it is wished: tick one goal or several, and "
                           "what may change."),
                        this);
    m_said->setWordWrap(true);
    m_said->setMinimumHeight(usualLines * m_said->fontMetrics().lineSpacing());
    m_said->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_notes = new QLabel(this);
    m_notes->setWordWrap(true);
    m_notes->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_notes->setMinimumHeight(usualLines * m_notes->fontMetrics().lineSpacing());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_take = buttons->addButton(tr("&Take the changes"), QDialogButtonBox::AcceptRole);
    connect(m_take, &QPushButton::clicked, this, &PatternFitWindow::commit);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    m_scroll = new ColumnScroll(this);
    m_scroll->setWidget(m_order);
    m_scroll->setAccessibleName(tr("What is wished"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_scroll);
    layout->addWidget(new PullNote(m_document, this));
    layout->addWidget(m_run);
    layout->addWidget(m_said);
    layout->addWidget(buildOutcome(), 1);
    layout->addWidget(m_notes); // not among the outcome: what wraps lines lets nothing beside it shrink
    layout->addStretch();
    layout->addWidget(buttons);
    const QRect screenArea = screen()->availableGeometry();
    resize(460, std::min(800, screenArea.height() - titleBar));
    fitScreen();
    if (const QWidget* window = parentWidget()) // over the cover's margin: pattern and cover are what one looks at
        move(window->geometry().right() - width() - 24,
             std::min(window->geometry().top() + 80, screenArea.bottom() - height() - titleBar));
}

QWidget* PatternFitWindow::buildOutcome()
{
    m_outcome = new QWidget(this);
    m_patches = new HeadedList({tr("Changes of"), tr("Moves by")}, 0, m_outcome);
    m_patches->setAccessibleName(tr("Changes"));
    m_patches->setToolTip(tr("What is ticked is changed"));
    m_patches->setMinimumHeight(5 * m_patches->fontMetrics().lineSpacing());
    connect(m_patches, &QTreeWidget::itemChanged, this, &PatternFitWindow::preview);
    m_arrowsSaid = new QLabel(m_outcome);
    auto* rows = new QVBoxLayout(m_outcome);
    rows->setContentsMargins({});
    rows->addWidget(m_patches, 1);
    rows->addLayout(buildShare());
    rows->addWidget(m_arrowsSaid);
    return m_outcome;
}

QLayout* PatternFitWindow::buildShare()
{
    m_share = new QSlider(Qt::Horizontal, m_outcome);
    m_share->setRange(0, 100);
    m_share->setValue(100);
    auto* label = new QLabel(tr("&How much of it"), m_outcome);
    label->setBuddy(m_share);
    m_percent = new NumberBox({tr(" %"), 0, 0, 100, 5}, m_outcome);
    m_percent->setAccessibleName(label->text().remove(u'&'));
    m_percent->display(100);
    connect(m_share, &QSlider::valueChanged, this, [this](int percent) {
        m_percent->display(percent);
        preview();
    });
    connect(m_percent, &NumberBox::entered, this, [this](double percent) { m_share->setValue(qRound(percent)); });
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(m_share, 1);
    row->addWidget(m_percent);
    return row;
}

void PatternFitWindow::find()
{
    if (!takeTyped(*this))
        return;
    m_document.cancelGesture();
    FitOrder wanted = m_order->order();
    if (const QString missing = m_order->missing(wanted, [this] { find(); }); !missing.isEmpty()) {
        m_said->setText(missing);
        return;
    }
    forget({});
    m_sought = m_order->goals();
    m_start = m_document.committed();
    setRunning(true);
    m_said->setText(tr("Solving the cover \u2026"));
    m_reached = {m_run->newRun(), wanted.freedoms, !wanted.locks.ease, {}};
    m_wanted = {m_reached.number, {m_start, m_session.files()}, m_order->form(), std::move(wanted)};
    m_job.request(m_wanted, true);
}

void PatternFitWindow::stop()
{
    m_run->newRun();
    m_job.cancel();
    setRunning(false);
    if (m_reached.result.values.size() > 0 && !m_reached.result.values.isZero())
        show(std::move(m_reached),
             tr("Stopped. With all of the changes that were found until then, measured anew on all triangles:"),
             std::nullopt); // found on few triangles, perhaps, on which covers are others
    else
        m_said->setText(tr("Stopped; nothing has changed."));
}

void PatternFitWindow::setRunning(bool running)
{
    m_run->setRunning(running);
    m_outcome->setVisible(hasFound());
    m_notes->setVisible(hasFound());
    m_take->setEnabled(hasFound() && m_share->value() > 0);
}

void PatternFitWindow::showProgress(double share, const FitRound& round)
{
    m_run->setShare(share);
    m_reached.result.values = round.values;
    m_reached.result.before = round.before;
    m_reached.result.after = round.figures;
    if (m_sought.lies && round.few)
        m_said->setText(tr("%1 from %3 (rms; before: %2), on few triangles at first")
                            .arg(lengthText(round.figures.distanceRms, 2), lengthText(round.before.distanceRms, 2),
                                 formName()));
    else if (m_sought.lies)
        m_said->setText(tr("%1 from %3 (rms; before: %2)")
                            .arg(lengthText(round.figures.distanceRms, 2), lengthText(round.before.distanceRms, 2),
                                 formName()));
    else if (m_sought.strained)
        m_said->setText(
            overText(round.few).arg(percentText(round.figures.overLimit), percentText(round.before.overLimit)));
    else
        m_said->setText(tr("Changing the pattern \u2026"));
}

/// Of a strain that is over its limit: %1 now, %2 before.
QString PatternFitWindow::overText(bool few) const
{
    if (!m_wanted.order.goals.area.isAll())
        return few ? tr("%1 of the painted area is over the limit (before: %2), on few triangles at first")
                   : tr("%1 of the painted area is over the limit (before: %2)");
    return few ? tr("%1 of the cover is over the limit (before: %2), on few triangles at first")
               : tr("%1 of the cover is over the limit (before: %2)");
}

void PatternFitWindow::take(FitFound found)
{
    if (!m_run->isNow(found.number))
        return;
    const FitResult& result = found.result;
    if (result.status == FitResult::Status::Failed || result.status == FitResult::Status::NothingToDo) {
        setRunning(false);
        m_said->setText(result.status == FitResult::Status::Failed ? translated(result.reason)
                        : result.rounds.empty()
                            ? tr("Nothing is over the limits: there is nothing to do.")
                            : tr("No change makes it better on all triangles: let something else change, or "
                                 "points move farther."));
        return;
    }
    const FitFigures reached = result.after;
    show(std::move(found), tr("With all of the changes:"), reached);
}

/// `whole`: figures of all of it, if they are known on the triangles that count.
void PatternFitWindow::show(FitFound found, const QString& lead, const std::optional<FitFigures>& whole)
{
    m_found = std::move(found);
    m_lead = lead;
    m_whole = whole;
    setRunning(false);
    fillPatches();
    preview();
}

/// What the cover is like with what is shown; while that is being measured, its figures are not there.
void PatternFitWindow::say(const std::optional<FitFigures>& now)
{
    m_shown = now;
    const auto said = [&](const std::optional<FitFigures>& of) {
        return (QStringList(lead()) + figures(of)).join('\n');
    };
    m_said->setText(said(now));
    // Until it is measured nothing is said that was so of something else.
    m_notes->setText(now ? notes(*now).join('\n') : QStringLiteral("\u2026"));
    // What is below stays under the pointer, also when figures come and take more room.
    keepRoom(*m_said, m_said->width(), said(m_found->result.before));
    keepRoom(*m_notes, m_said->width(), m_notes->text());
    fitScreen();
}

/// What is below is not cut off; where the screen is too low what is wished scrolls.
void PatternFitWindow::fitScreen()
{
    const QRect area = screen()->availableGeometry();
    const int most = area.height() - titleBar;
    m_scroll->setFixedHeight(m_order->sizeHint().height());
    int needed = layout()->totalMinimumHeightForWidth(width());
    if (needed > most) {
        const int least = leastWished * fontMetrics().lineSpacing();
        m_scroll->setFixedHeight(std::max(least, m_scroll->height() - (needed - most)));
        needed = layout()->totalMinimumHeightForWidth(width());
    }
    if (needed > height())
        resize(width(), needed);
    if (isVisible() && frameGeometry().bottom() > area.bottom())
        move(x(), std::max(area.top(), area.bottom() - frameGeometry().height()));
}

/// As many lines whatever is shown.
QStringList PatternFitWindow::figures(const std::optional<FitFigures>& now) const
{
    const FitFigures& before = m_found->result.before;
    const auto length = [&](double FitFigures::*figure) {
        return now ? lengthText((*now).*figure, 2) : QStringLiteral("\u2026");
    };
    const auto share = [&](double FitFigures::*figure) {
        return now ? percentText((*now).*figure) : QStringLiteral("\u2026");
    };
    QStringList lines;
    if (m_sought.lies)
        lines << tr("From %5: %1 before, %2 now (rms); %3 before, %4 now (95 %)")
                     .arg(lengthText(before.distanceRms, 2), length(&FitFigures::distanceRms),
                          lengthText(before.distanceP95, 2), length(&FitFigures::distanceP95),
                          isolated(formName()));
    const bool inArea = !m_wanted.order.goals.area.isAll();
    lines << (!m_sought.strained ? tr("Over the fabrics' limits: %1 of the cover before, %2 now")
              : inArea           ? tr("Strained over the limit: %1 of the painted area before, %2 now")
                                 : tr("Strained over the limit: %1 of the cover before, %2 now"))
                 .arg(percentText(before.overLimit), share(&FitFigures::overLimit));
    if (m_sought.smooth)
        lines << tr("Pressed together: %1 before, %2 now")
                     .arg(percentText(before.pressed), share(&FitFigures::pressed));
    if (m_sought.along)
        lines << tr("From the curve: %1 before, %2 now (rms)")
                     .arg(lengthText(before.seamRms, 2), length(&FitFigures::seamRms));
    if (m_sought.sized)
        lines << tr("Off the area that is wanted: %1 before, %2 now")
                     .arg(percentText(before.sizeMost), share(&FitFigures::sizeMost));
    return lines << tr("The cover moves by %1 (rms).").arg(length(&FitFigures::shapeRms));
}

/// Of what the cover shall lie on.
QString PatternFitWindow::formName() const
{
    const FitForm& form = m_wanted.form;
    return form.scan ? QString::fromStdString(form.scan->name) : QFileInfo(form.file).fileName();
}

QString PatternFitWindow::missText(MissedGoal::Kind kind) const
{
    switch (kind) {
    case MissedGoal::Kind::Form:
        return tr("That is hardly nearer to %1: let something else change, or more of it.")
            .arg(isolated(formName()));
    case MissedGoal::Kind::Strain:
        return tr("That is hardly nearer to the limit: let something else change, or more of it.");
    case MissedGoal::Kind::Smooth:
        return tr("Hardly less is pressed together: let something else change, or more of it.");
    case MissedGoal::Kind::Seams:
        return tr("That is hardly nearer to the curve: let something else change, or more of it.");
    case MissedGoal::Kind::Sizes:
        break;
    }
    return tr("That is hardly nearer to the area that is wanted: let something else change, or more of it.");
}

/// What is to be thought of before it is taken.
QStringList PatternFitWindow::notes(const FitFigures& now) const
{
    const FitResult& result = m_found->result;
    const FitFigures& before = result.before;
    QStringList lines;
    if (m_sought.lies && strainsForLittle(before, now))
        lines << tr("That is hardly nearer, and strains the cloth more: let something else change, or less of it.");
    else
        for (const MissedGoal& miss : missedGoals(m_sought.strained, before, now))
            lines << missText(miss.kind);
    if (strainsMore(before, now) && !strainsForLittle(before, now))
        lines << tr(
            "More of the cloth is strained over its limits: make these a goal, too, or let points move less.");
    if (missesLengths(m_wanted.order.locks, before, now))
        lines
            << tr("Sides of seams differ by up to %1 more than is wanted: change their neighbours, too, or let the "
                  "ease change.")
                   .arg(lengthText(now.sewnMost));
    if (mendsLengths(m_wanted.order.locks, before, now))
        lines << tr("Sides of seams off their ease: up to %1 before, %2 now")
                     .arg(lengthText(before.sewnMost), lengthText(now.sewnMost));
    if (result.jumped)
        lines << tr("On the way a fold came or went: look at the cover before you take it.");
    if (!result.idle.empty())
        lines << tr("%n of the numbers that may change do nothing here.", nullptr,
                    static_cast<int>(result.idle.size()));
    return lines;
}

/// For the history, in which one fit is not to look like the next.
Message PatternFitWindow::verb() const
{
    const std::string name = formName().toStdString();
    if (m_sought.lies && m_shown)
        return {QT_TRANSLATE_NOOP("Message", "Fit the pattern to %1, %2 mm from it"),
                {name, numberText(m_shown->distanceRms, 3)}};
    if (m_sought.lies)
        return {QT_TRANSLATE_NOOP("Message", "Fit the pattern to %1"), {name}};
    if (m_sought.strained && m_shown)
        return {QT_TRANSLATE_NOOP("Message", "Fit the pattern to a limit of strain, %1 % of the cover over it"),
                {numberText(100 * m_shown->overLimit, 2)}};
    return {QT_TRANSLATE_NOOP("Message", "Fit the pattern to a goal"), {}};
}

void PatternFitWindow::measure()
{
    if (m_found && m_gesture && m_gesture->active())
        m_measuring.request({m_part, m_wanted, changedDesign()}, true);
}

/// What is being measured is not shown any more.
void PatternFitWindow::endMeasuring()
{
    ++m_part;
    m_slider.stop();
    m_measuring.cancel();
}

void PatternFitWindow::takePart(const PartFound& found)
{
    if (!m_found || found.number != m_part)
        return;
    if (m_aside) { // it was taken before this was known
        if (found.figures)
            m_takenFigures = found.figures->after;
        m_said->setText(takenText());
        return;
    }
    if (!found.figures) {
        m_said->setText(tr("With what is shown of the changes the cover cannot be solved."));
        return;
    }
    if (showsAll() && !m_whole && !found.figures->better) {
        forget(tr("Stopped. What was found until then makes it no better: nothing has changed."));
        return;
    }
    m_found->result.before = found.figures->before;
    if (showsAll())
        m_whole = found.figures->after;
    m_take->setEnabled(m_share->value() > 0);
    say(found.figures->after);
}

QString PatternFitWindow::lead() const
{
    return showsAll() ? m_lead : tr("With what is shown of the changes:");
}

bool PatternFitWindow::showsAll() const
{
    bool all = m_share->value() == m_share->maximum();
    for (int row = 0; row < m_patches->topLevelItemCount(); ++row)
        all = all && m_patches->topLevelItem(row)->checkState(0) == Qt::Checked;
    return all;
}

void PatternFitWindow::fillPatches()
{
    const QSignalBlocker quiet(m_patches);
    m_patches->clear();
    showShare(m_share->maximum());
    std::set<ElementId> elements;
    for (std::size_t k = 0; k < m_found->freedoms.size(); ++k)
        if (m_found->result.values[static_cast<Eigen::Index>(k)] != 0)
            elements.insert(m_found->freedoms[k].element);
    for (const ElementId id : elements) {
        auto* row = new QTreeWidgetItem(m_patches, {displayName(m_start, id)});
        row->setData(0, Qt::UserRole, number(id));
        row->setCheckState(0, Qt::Checked);
        row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    }
}

/// Without making a change of that size.
void PatternFitWindow::showShare(int percent)
{
    const QSignalBlocker quiet(m_share);
    m_share->setValue(percent);
    m_percent->display(percent);
}

/// By how much each of them moves with as much of the change as the slider says.
void PatternFitWindow::sayMoves()
{
    const QSignalBlocker quiet(m_patches);
    for (int row = 0; row < m_patches->topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = m_patches->topLevelItem(row);
        const double all = movedBy(*m_found, static_cast<ElementId>(item->data(0, Qt::UserRole).toUInt()));
        const bool moves = item->checkState(0) == Qt::Checked;
        item->setText(1, steadyLengthText(moves ? all * m_share->value() / m_share->maximum() : 0, 1));
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
    return designWith(values);
}

Design PatternFitWindow::designWith(const Eigen::VectorXd& values) const
{
    return withChange(m_start, m_found->freedoms, values, m_found->easeIsFree);
}

void PatternFitWindow::preview()
{
    if (!hasFound())
        return;
    sayMoves();
    endMeasuring();
    const std::optional<FitFigures> known = showsAll() ? m_whole : std::nullopt;
    m_take->setEnabled(m_share->value() > 0 && m_whole.has_value()); // what may be worse is not offered yet
    say(known);
    if (!known)
        m_slider.start();
    if (!m_gesture || !m_gesture->active())
        m_gesture.emplace(m_document, Gesture::Purpose::Preview);
    const Design changed = changedDesign();
    m_gesture->update(editBetween(m_start, changed, verb()));
    const double pixel = 1 / m_pattern.navigation().transform().scale(); // mm
    const auto arrowsTo = [&](const Design& design, std::optional<double> longer) {
        return arrowsBetween(m_start, design, arrowsApart * pixel, longestArrow * pixel, longer);
    };
    PatternArrows arrows = arrowsTo(changed, arrowsTo(designWith(m_found->result.values), {}).longer);
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
    m_gesture->update(editBetween(m_start, changedDesign(), verb())); // what is measured is known by now
    m_aside = true; // what the commit makes of the design is no surprise
    m_gesture->commit();
    if (m_document.committed() == m_start) { // it was refused, which is said elsewhere
        m_aside = false;
        showNothing({});
        return;
    }
    m_taken = m_document.committed();
    m_takenFigures = m_shown;
    putAside(takenText());
    if (!m_takenFigures)
        m_measuring.request({m_part, m_wanted, changedDesign()}, true);
}

/// What was taken is said as well as what was shown.
QString PatternFitWindow::takenText() const
{
    QStringList lines{tr("Taken. Undo takes it back.")};
    if (m_takenFigures)
        lines += figures(m_takenFigures);
    return lines.join(u'\n');
}

/// Undo, Escape or another gesture has taken back what is shown.
void PatternFitWindow::previewEnded()
{
    if (!hasFound() || !m_gesture || m_gesture->active())
        return;
    m_shareBefore = m_share->value();
    showNothing(tr("Nothing of the changes is shown now: move the slider to see them."));
}

/// What was found can be looked at again.
void PatternFitWindow::showNothing(const QString& why)
{
    m_gesture.reset();
    showShare(0);
    sayMoves();
    m_arrowsSaid->clear();
    m_notes->clear();
    m_pattern.showArrows({});
    m_take->setEnabled(false);
    endMeasuring();
    m_said->setText(why);
}

/// What was found is no longer of use.
void PatternFitWindow::forget(const QString& why)
{
    m_found.reset();
    m_taken.reset();
    for (QLabel* label : {m_said, m_notes})
        label->setMinimumHeight(usualLines * label->fontMetrics().lineSpacing());
    putAside(why);
}

/// What was found is of no use for the design as it is now.
void PatternFitWindow::putAside(const QString& why)
{
    m_aside = m_found.has_value();
    m_shareBefore = 0;
    m_gesture.reset();
    endMeasuring();
    m_pattern.showArrows({});
    setRunning(m_run->running());
    m_said->setText(why);
}

/// Who works on meanwhile has another design.
void PatternFitWindow::documentChanged()
{
    const Design& now = m_document.committed();
    if ((!m_found && !m_run->running()) || (!m_aside && now == m_start))
        return;
    if (hasSameCover(now, m_start)) {
        m_start = now;
        comeBack();
    } else if (m_run->running()) {
        m_reached = {};
        stop();
        m_said->setText(tr("The design has changed meanwhile: find the changes again."));
    } else {
        putAside(!m_taken ? tr("The design has changed meanwhile: find the changes again, or undo that.")
                 : hasSameCover(now, *m_taken) ? takenText()
                                               : QString());
    }
}

/// The design is the one again that the changes were found for, or nearly.
void PatternFitWindow::comeBack()
{
    if (!m_found)
        return;
    const bool wasAside = std::exchange(m_aside, false);
    setRunning(m_run->running());
    if (wasAside) {
        showNothing(m_taken ? tr("Taken back. Move the slider to see the changes again.")
                            : tr("Nothing of the changes is shown now: move the slider to see them."));
    } else if (m_shareBefore > 0) {
        showShare(m_shareBefore);
        preview();
    }
}

} // namespace bolster
