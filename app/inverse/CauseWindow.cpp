#include "CauseWindow.h"

#include "DesignSession.h"
#include "ElementText.h"
#include "FitGoals.h"
#include "HeadedList.h"
#include "PullNote.h"
#include "Pulls.h"
#include "RunRow.h"
#include "ScanMeasure.h"
#include "SolveFailure.h"
#include "Translated.h"
#include "Units.h"
#include "WorkerPool.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace bolster {

namespace {

constexpr std::size_t shownCauses = 12;
constexpr std::size_t namedAlike = 3;
constexpr double hardlyAny = 0.005;        // of the deviation, or of all that is likely
constexpr double shareOfDerivatives = 0.6; // of the time that it takes

QString kindText(Cause::Kind kind)
{
    switch (kind) {
    case Cause::Kind::Foam:
        return bolster::CauseWindow::tr("Foam is thicker or thinner");
    case Cause::Kind::Strength:
        return bolster::CauseWindow::tr("Foam is harder or softer");
    case Cause::Kind::Seam:
        return bolster::CauseWindow::tr("Allowance of a seam");
    case Cause::Kind::Stretch:
        return bolster::CauseWindow::tr("Piece is larger or smaller");
    case Cause::Kind::Fixation:
        return bolster::CauseWindow::tr("Fixation lies elsewhere");
    case Cause::Kind::Notch:
        return bolster::CauseWindow::tr("Seam is sewn shifted");
    }
    return {};
}

QString causeText(const Design& design, const Cause& cause)
{
    return bolster::CauseWindow::tr("%1: %2").arg(kindText(cause.kind), displayName(design, cause.element));
}

/// Which way a cause goes that has one number: words for more and for less.
std::pair<QString, QString> wordsOf(Cause::Kind kind)
{
    switch (kind) {
    case Cause::Kind::Foam:
        return {bolster::CauseWindow::tr("%1 thicker"), bolster::CauseWindow::tr("%1 thinner")};
    case Cause::Kind::Strength:
        return {bolster::CauseWindow::tr("%1 harder"), bolster::CauseWindow::tr("%1 softer")};
    case Cause::Kind::Seam:
        return {bolster::CauseWindow::tr("%1 farther out"), bolster::CauseWindow::tr("%1 farther in")};
    case Cause::Kind::Stretch:
        return {bolster::CauseWindow::tr("%1 larger"), bolster::CauseWindow::tr("%1 smaller")};
    case Cause::Kind::Notch:
        return {bolster::CauseWindow::tr("%1 counter-clockwise"), bolster::CauseWindow::tr("%1 clockwise")};
    case Cause::Kind::Fixation:
        break;
    }
    return {QStringLiteral("%1"), QStringLiteral("%1")};
}

/// "3.1 \u00b1 0.4 mm thicker"; of places along each axis.
QString amountText(const Explanation& one, Cause::Kind kind)
{
    const QString unit = u' ' + QString::fromLatin1(unitOf(kind));
    const bool lengths = unit == millimetreSuffix;
    const auto figure = [&](double value) {
        return lengths ? steadyLengthFigure(value) : decimalText(value, 1, true);
    };
    const auto within = [&](double value, Eigen::Index k) {
        const QString spread = figure(one.spreads[k]);
        return spread == figure(0) ? figure(value) : figure(value) + QStringLiteral(" \u00b1 ") + spread;
    };
    const QString suffix = lengths ? lengthSuffix() : unit;
    if (kind != Cause::Kind::Fixation) {
        const auto& [more, less] = wordsOf(kind);
        return (one.values[0] < 0 ? less : more).arg(within(std::abs(one.values[0]), 0) + suffix);
    }
    QStringList numbers;
    for (Eigen::Index k = 0; k < one.values.size(); ++k)
        numbers << QStringLiteral("xyz").mid(k, 1) + u' ' + (one.values[k] > 0 ? QStringLiteral("+") : QString()) +
                       within(one.values[k], k);
    return numbers.join(QStringLiteral(", ")) + suffix;
}

/// What the words of an amount mean, where that is not plain.
QString amountTip(const Design& design, const Cause& cause)
{
    const auto* patch = design.find<Patch>(cause.numbers.front().freedoms.front().element);
    if (cause.kind == Cause::Kind::Seam)
        return bolster::CauseWindow::tr("Farther out: the allowance was taken narrower, on both sides");
    if (cause.kind == Cause::Kind::Notch && patch)
        return bolster::CauseWindow::tr("Along the edge of %1, as it lies in the pattern")
            .arg(isolated(QString::fromStdString(patch->name)));
    return {};
}

/// How many times as large as such a cause usually is at most.
double timesUsual(const Explanation& one, const Cause& cause)
{
    double most = 0;
    for (Eigen::Index k = 0; k < one.values.size(); ++k) {
        const Tolerance& tolerance = cause.numbers[static_cast<std::size_t>(k)];
        most = std::max(most, std::abs(one.values[k]) / (2 * tolerance.spread * unitOf(tolerance)));
    }
    return most;
}

/// Whole per cents; what is less than one is not nothing.
QString wholePercent(double ratio)
{
    const double percent = std::round(100 * ratio);
    return percent < 1 ? bolster::CauseWindow::tr("below %1").arg(percentText(0.01)) : percentText(percent / 100);
}

/// The likely ones first; of those that are hardly likely the ones that explain more. Nothing is said of what
/// explains nothing.
std::vector<std::size_t> rowsOf(const Explanations& explained)
{
    std::vector<std::size_t> rows;
    const auto& ranked = explained.ranked;
    for (std::size_t k = 0; k < ranked.size(); ++k) {
        if (ranked[k].share >= hardlyAny)
            rows.push_back(k);
    }
    const auto likely = [&](std::size_t k) {
        return ranked[k].probability >= hardlyAny ? ranked[k].probability : 0;
    };
    std::ranges::stable_sort(rows, [&](std::size_t a, std::size_t b) {
        return likely(a) != likely(b) ? likely(a) > likely(b) : ranked[a].share > ranked[b].share;
    });
    return rows;
}

} // namespace

CauseWindow::CauseWindow(DesignSession& session, Selection& selection, std::shared_ptr<CauseMemory> remembered,
                         QWidget* parent)
    : QDialog(parent)
    , m_session(session)
    , m_document(session.document())
    , m_selection(selection)
    , m_remembered(std::move(remembered))
    , m_job([this](const Wanted& wanted,
                   const std::stop_token& stop) { return explain(wanted, m_run->sharesOf(wanted.number), stop); },
            [this](Found found) { take(std::move(found)); })
{
    setWindowTitle(tr("Why is it so?"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    m_scan->choose(m_remembered->scan);
    m_sound->choose(m_remembered->sound);
    if (m_remembered->found)
        show(*m_remembered->found);
    connect(&m_document, &Document::changed, this, &CauseWindow::documentChanged);
    connect(&m_document, &Document::historyReplaced, this, &QDialog::close);
}

CauseWindow::~CauseWindow()
{
    m_job.cancel();
    *m_remembered = {m_scan->chosen(), m_sound->chosen(), std::move(m_found)};
}

void CauseWindow::build()
{
    m_scan = new FormChoice(m_session, tr("The scan of the piece"), {}, this);
    m_sound = new FormChoice(m_session, tr("The scan of a sound piece"), tr("None"), this);
    m_sound->setToolTip(
        tr("Of a piece that is as it should be: where that lies elsewhere than the cover no cause is "
           "looked for"));
    auto* form = new QFormLayout;
    form->addRow(tr("Scan of the &piece"), m_scan);
    form->addRow(tr("Scan of a so&und piece"), m_sound);
    m_run = new RunRow(tr("Look for the &cause"), tr("Looking for a cause \u2026"), this);
    connect(m_run, &RunRow::started, this, &CauseWindow::find);
    connect(m_run, &RunRow::stopped, this, &CauseWindow::stop);
    m_said = new QLabel(tr("Says which one cause explains best how far a built piece lies from the cover: foam, a "
                           "seam's allowance, a stretched piece, a fixation off its place, a slipped notch."),
                        this);
    m_said->setWordWrap(true);
    m_list = new HeadedList({tr("Cause"), tr("Amount"), tr("Explains"), tr("Probability")}, 0, this);
    m_list->setAccessibleName(tr("Causes"));
    m_list->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents); // names differ anywhere
    connect(m_list, &QTreeWidget::currentItemChanged, this, &CauseWindow::rowChosen);
    m_alike = new QLabel(this);
    m_alike->setWordWrap(true);
    m_alike->setMinimumHeight(2 * m_alike->fontMetrics().lineSpacing());
    m_alike->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(new PullNote(m_document, this));
    layout->addWidget(m_run);
    layout->addWidget(m_said);
    layout->addWidget(m_list, 1);
    layout->addWidget(m_alike);
    layout->addWidget(buttons);
    resize(900, 560);
    if (const QWidget* window = parentWidget()) // over the pattern: the cover is what it is about
        move(window->geometry().left() + 24, window->geometry().top() + 80);
}

CauseWindow::Found CauseWindow::explain(const Wanted& wanted, const std::function<void(double)>& progress,
                                        const std::stop_token& stop)
{
    Found found;
    found.number = wanted.number;
    found.design = wanted.input.design;
    found.sound = !wanted.sound.empty();
    try {
        FitTarget scan, sound;
        if (!readTarget(wanted.scan, scan, found.problem, stop) ||
            !readTarget(wanted.sound, sound, found.problem, stop))
            return found;
        CauseFinder finder(
            wanted.input, {}, [&](double share) { progress(shareOfDerivatives * share); }, stop);
        found.problem = finder.problem();
        if (!finder.nominal() || stop.stop_requested())
            return found;
        found.causes = finder.causes();
        const auto solving = [&](double share) { progress(shareOfDerivatives + (1 - shareOfDerivatives) * share); };
        found.explained = finder.explain(scan, sound, solving, stop);
        WorkerPool pool(0);
        found.toNearest = measureScan(*finder.nominal(), scan.place, scan.index, pool).figures.rms;
    } catch (const std::exception& error) {
        found.problem = failureMessage(error);
    }
    return found;
}

void CauseWindow::find()
{
    const auto again = [this] { find(); };
    if (m_scan->asksForFile(again) || m_sound->asksForFile(again))
        return;
    const FitForm scan = m_scan->form();
    if (scan.empty()) {
        m_said->setText(tr("Choose the scan of the piece that was built."));
        return;
    }
    m_document.cancelGesture();
    m_start = m_document.committed();
    m_run->setRunning(true);
    m_said->setText(tr("Covers with each cause are solved \u2026"));
    m_job.request({m_run->newRun(), {m_start, m_session.files()}, scan, m_sound->form()}, true);
}

void CauseWindow::stop()
{
    m_run->newRun();
    m_job.cancel();
    m_run->setRunning(false);
    m_said->setText(m_found ? tr("Stopped. The list is that of the search before.") : tr("Stopped."));
}

void CauseWindow::take(Found found)
{
    if (!m_run->isNow(found.number))
        return;
    m_run->setRunning(false);
    m_found.reset();
    m_list->clear();
    m_alike->clear();
    if (!found.problem.empty()) {
        m_said->setText(translated(found.problem));
        return;
    }
    show(std::move(found));
}

void CauseWindow::show(Found found)
{
    m_found = std::move(found);
    m_rows = rowsOf(m_found->explained);
    say();
    fill();
}

void CauseWindow::say()
{
    const Explanations& all = m_found->explained;
    if (all.covered == 0) {
        m_said->setText(tr("The scan shows nothing of the cover: does it lie where the design is?"));
        return;
    }
    if (all.nothing()) {
        m_said->setText(tr("The scan lies on the cover: there is nothing to explain."));
        return;
    }
    QStringList lines{
        m_found->sound
            ? tr("The scan shows %1 of the cover and lies %2 (rms) from it. All causes together leave %3.")
                  .arg(percentText(all.covered), lengthText(all.rms, 2), lengthText(all.noise, 2))
            : tr("The scan shows %1 of the cover. Its points lie %2 (rms) from the cover, of which all causes "
                 "together "
                 "leave %3. From the cover to the nearest point, as a fit measures, it is %4.")
                  .arg(percentText(all.covered), lengthText(all.rms, 2), lengthText(all.noise, 2),
                       lengthText(m_found->toNearest, 2))};
    if (all.none > 0.5)
        lines << tr("No single cause explains that better than noise does.");
    if (all.weak())
        lines << tr("Even the likeliest cause explains only %1 of it: there may be several, or others than these.")
                     .arg(percentText(std::round(100 * all.ranked.front().share) / 100));
    if (all.leavesMore())
        lines << tr(
            "What the likeliest cause leaves is more than noise: something else may be wrong, too, and its amount "
            "may be off by more than is said.");
    if (!m_found->sound && all.mostlyUnexplained())
        lines << tr("Most of the deviation has no cause of these kinds, so the first need not be the right one: "
                    "give the scan of a sound piece, too.");
    if (m_rows.size() > shownCauses)
        lines << tr("%n more causes explain some of it, less likely than these.", nullptr,
                    static_cast<int>(m_rows.size() - shownCauses));
    m_said->setText(lines.join('\n'));
}

void CauseWindow::fill()
{
    for (const std::size_t k : std::span(m_rows).first(std::min(m_rows.size(), shownCauses))) {
        const Explanation& one = m_found->explained.ranked[k];
        const Cause& cause = m_found->causes[one.cause];
        auto* row = new QTreeWidgetItem(m_list, {causeText(m_found->design, cause), amountText(one, cause.kind),
                                                 wholePercent(one.share), wholePercent(one.probability)});
        row->setToolTip(0, row->text(0));
        row->setToolTip(1, amountTip(m_found->design, cause));
        for (const int column : {1, 2, 3})
            row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    if (m_list->topLevelItemCount() > 0)
        m_list->setCurrentItem(m_list->topLevelItem(0));
}

void CauseWindow::rowChosen()
{
    const int row = m_list->indexOfTopLevelItem(m_list->currentItem());
    if (!m_found || row < 0)
        return;
    const Explanation& one = m_found->explained.ranked[m_rows[static_cast<std::size_t>(row)]];
    if (const ElementId id = m_found->causes[one.cause].element; m_document.design().element(id))
        m_selection.set({id});
    QStringList names;
    for (std::size_t k = 0; k < std::min(namedAlike, one.alike.size()); ++k)
        names << causeText(m_found->design, m_found->causes[one.alike[k]]);
    if (one.alike.size() > namedAlike)
        names << tr("and %n others", nullptr, static_cast<int>(one.alike.size() - namedAlike));
    QStringList lines;
    if (timesUsual(one, m_found->causes[one.cause]) > 2)
        lines << tr("That is far more than such a cause usually is: there may be several, or others than these.");
    if (!names.empty())
        lines << tr("The scan does not tell it apart from: %1").arg(names.join(QStringLiteral("; ")));
    m_alike->setText(lines.join(u'\n'));
}

/// What is said stays: it is of the piece, which was built from the design as it was.
void CauseWindow::documentChanged()
{
    if (m_run->running() && !hasSameCover(m_document.committed(), m_start)) {
        stop();
        m_said->setText(tr("The design has changed meanwhile: look again."));
    }
}

} // namespace bolster
