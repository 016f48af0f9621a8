#include "SweepWindow.h"

#include "DesignSession.h"
#include "ElementText.h"
#include "HeadedList.h"
#include "MapLink.h"
#include "NumberBox.h"
#include "PullNote.h"
#include "Pulls.h"
#include "RunRow.h"
#include "Translated.h"
#include "Units.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bolster {

namespace {

/// Tolerances of one kind.
struct ToleranceKind {
    const char* label;
    const char* tip;
    const char* row; ///< %1: the element
    bool percent;
    double usual; ///< 0: not unless it is wanted
    std::vector<Tolerance> (*make)(const Design&, double);
};

const ToleranceKind kinds[] = {
    {QT_TRANSLATE_NOOP("SweepWindow", "&Cut"),
     QT_TRANSLATE_NOOP("SweepWindow", "Each piece is cut so much larger or smaller all around"),
     QT_TRANSLATE_NOOP("SweepWindow", "Cut of %1"), false, 1, &cutTolerances},
    {QT_TRANSLATE_NOOP("SweepWindow", "S&eams"),
     QT_TRANSLATE_NOOP("SweepWindow", "Each seam is sewn so much farther inside or outside, on both sides"),
     QT_TRANSLATE_NOOP("SweepWindow", "Seam %1"), false, 1, &seamTolerances},
    {QT_TRANSLATE_NOOP("SweepWindow", "&Foam"),
     QT_TRANSLATE_NOOP("SweepWindow", "Each cushion and foam is so much thicker or thinner"),
     QT_TRANSLATE_NOOP("SweepWindow", "Thickness of %1"), false, 0, &foamTolerances},
    {QT_TRANSLATE_NOOP("SweepWindow", "Fi&xations"),
     QT_TRANSLATE_NOOP("SweepWindow", "Each fixation curve lies so much elsewhere, along each axis"),
     QT_TRANSLATE_NOOP("SweepWindow", "Place of %1"), false, 1, &fixationTolerances},
    {QT_TRANSLATE_NOOP("SweepWindow", "S&tiffness"),
     QT_TRANSLATE_NOOP("SweepWindow", "Each fabric is so much stiffer or softer"),
     QT_TRANSLATE_NOOP("SweepWindow", "Stiffness of %1"), true, 0, &stiffnessTolerances},
    {QT_TRANSLATE_NOOP("SweepWindow", "Sh&rinkage"),
     QT_TRANSLATE_NOOP("SweepWindow", "Each piece shrinks or stretches by so much"),
     QT_TRANSLATE_NOOP("SweepWindow", "Shrinkage of %1"), true, 0, &sizeTolerances},
};

/// What the table says, in the user's language: its words are in a context without a namespace, which tr() would
/// not find.
QString tableWords(const char* text)
{
    return QCoreApplication::translate("SweepWindow", text);
}

constexpr int usualSamples = 100;
constexpr double usualLimit = 3; // mm

/// What varies: the names of the patches of a seam, or of the only element.
QString namesOf(const Design& design, const Tolerance& tolerance)
{
    QStringList names;
    for (const Freedom& freedom : tolerance.freedoms)
        if (const QString name = displayName(design, freedom.element); !names.contains(name))
            names << name;
    return names.join(QStringLiteral(" \u2013 "));
}

/// Along which axis a fixation goes, or nothing.
QString axisText(const Tolerance& tolerance)
{
    const Freedom& first = tolerance.freedoms.front();
    return first.kind == Freedom::Kind::CurvePlace ? QStringLiteral(", ") + QChar(u'x' + first.axis) : QString();
}

} // namespace

SweepWindow::SweepWindow(DesignSession& session, Selection& selection, MapLink& maps,
                         std::shared_ptr<SweepWishes> remembered, QWidget* parent)
    : QDialog(parent)
    , m_session(session)
    , m_document(session.document())
    , m_selection(selection)
    , m_maps(maps)
    , m_remembered(std::move(remembered))
    , m_job(
          [this](const SweepWanted& wanted, const std::stop_token& stop) {
              return findSweep(
                  wanted,
                  [this, number = wanted.number](double share, const SweepFound* found) {
                      std::optional<SweepFound> known;
                      if (found)
                          known = *found;
                      m_run->later(number, [this, share, known = std::move(known)] {
                          m_run->setShare(share);
                          if (known)
                              take(*known);
                      });
                  },
                  stop);
          },
          [this](SweepFound found) { take(std::move(found)); })
{
    setWindowTitle(tr("Tolerances"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    keepEnterInNumbers(*this);
    fillIn(*m_remembered);
    connect(&m_document, &Document::changed, this, &SweepWindow::documentChanged);
    connect(&m_document, &Document::historyReplaced, this, &QDialog::close);
    connect(&m_maps, &MapLink::measured, this, &SweepWindow::mapsChanged);
}

SweepWindow::~SweepWindow()
{
    *m_remembered = {asked(), m_samples->value(), m_limit->value(), std::move(m_pieces)};
    m_job.cancel();
    m_maps.disconnect(this);
    m_maps.setGuest(nullptr);
}

void SweepWindow::build()
{
    m_run = new RunRow(tr("&Draw pieces"), tr("Solving pieces within tolerances \u2026"), this);
    connect(m_run, &RunRow::started, this, &SweepWindow::find);
    connect(m_run, &RunRow::stopped, this, &SweepWindow::stop);
    m_said = new QLabel(tr("Pieces are drawn at random within their tolerances: where does the cover vary, which "
                           "tolerance matters, how many pieces are out of the limit?"),
                        this);
    m_said->setWordWrap(true);
    m_said->setMinimumHeight(3 * m_said->fontMetrics().lineSpacing());
    m_said->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_shown = new QCheckBox(tr("&Show on the cover what 95 % of the pieces do not exceed"), this);
    m_shown->setChecked(true);
    m_shown->setEnabled(false);
    connect(m_shown, &QCheckBox::toggled, this, &SweepWindow::showMap);
    m_list = new HeadedList({tr("Tolerance"), tr("Share"), tr("Moves by at most")}, 0, this);
    m_list->setAccessibleName(tr("Tolerances by their influence"));
    m_list->headerItem()->setToolTip(1, tr("How much of the variance of the whole cover comes of it"));
    connect(m_list, &QTreeWidget::currentItemChanged, this, &SweepWindow::rowChosen);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(buildTolerances());
    layout->addWidget(buildPieces());
    layout->addWidget(new PullNote(m_document, this));
    layout->addWidget(m_run);
    layout->addWidget(m_said);
    layout->addWidget(m_shown);
    layout->addWidget(m_list, 1);
    layout->addWidget(buttons);
    resize(540, 700);
    if (const QWidget* window = parentWidget()) // over the pattern: the cover is what it is about
        move(window->geometry().left() + 24, window->geometry().top() + 80);
}

QWidget* SweepWindow::buildTolerances()
{
    auto* box = new QGroupBox(tr("Tolerances (\u00b1); 0: none"), this);
    auto* grid = new QGridLayout(box);
    int place = 0;
    for (const ToleranceKind& kind : kinds) {
        auto* spread =
            new NumberBox({kind.percent ? tr(" %") : millimetreSuffix, 2, 0, 50, 0.5, !kind.percent}, box);
        spread->display(kind.usual);
        spread->setToolTip(tableWords(kind.tip));
        auto* label = new QLabel(tableWords(kind.label), box);
        label->setBuddy(spread);
        label->setToolTip(tableWords(kind.tip));
        const int row = place / 3, column = 2 * (place % 3);
        grid->addWidget(label, row, column);
        grid->addWidget(spread, row, column + 1);
        connect(spread, &NumberBox::entered, this, &SweepWindow::wishesChanged);
        m_spreads.push_back(spread);
        ++place;
    }
    for (const int column : {1, 3, 5})
        grid->setColumnStretch(column, 1);
    return box;
}

QWidget* SweepWindow::buildPieces()
{
    auto* box = new QGroupBox(tr("Pieces"), this);
    m_drawn = new QComboBox(box);
    m_drawn->addItem(tr("Every size within is as likely"));
    m_drawn->addItem(tr("Normal: the tolerance is three standard deviations"));
    m_drawn->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    connect(m_drawn, &QComboBox::activated, this, &SweepWindow::wishesChanged);
    m_samples = new NumberBox({QString(), 0, 0, 10'000, 50}, box);
    m_samples->display(usualSamples);
    m_samples->setToolTip(tr("Before them ten thousand are drawn as if covers were linear, which takes seconds"));
    m_limit = new NumberBox({millimetreSuffix, 2, 0.01, 1000, 0.5, true}, box);
    m_limit->display(usualLimit);
    connect(m_limit, &NumberBox::entered, this, &SweepWindow::wishesChanged);
    m_limit->setToolTip(
        tr("A piece is out of it when more than 5 % of its cover lie farther from where they should be"));
    auto* form = new QFormLayout(box);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    form->addRow(tr("Dr&awn"), m_drawn);
    form->addRow(tr("S&olved"), m_samples);
    form->addRow(tr("&Limit for 95 % of a cover"), m_limit);
    return box;
}

void SweepWindow::fillIn(const SweepWishes& wishes)
{
    if (wishes.asked.empty())
        return;
    m_drawn->setCurrentIndex(static_cast<int>(wishes.asked.front()));
    for (std::size_t k = 0; k < m_spreads.size(); ++k)
        m_spreads[k]->display(wishes.asked[k + 1]);
    m_samples->display(wishes.samples);
    m_limit->display(wishes.limit);
    if (wishes.drawn.found && hasSameCover(m_document.committed(), wishes.drawn.start))
        showAgain(wishes.drawn);
}

/// What was being drawn when the window was closed has ended there.
void SweepWindow::showAgain(const DrawnPieces& drawn)
{
    m_pieces = drawn;
    m_pieces.found->whole = true;
    fill();
    say();
    m_shown->setEnabled(true);
    showMap();
}

/// What the tolerances follow from.
std::vector<double> SweepWindow::asked() const
{
    std::vector<double> numbers{static_cast<double>(m_drawn->currentIndex())};
    for (const NumberBox* spread : m_spreads)
        numbers.push_back(spread->value());
    return numbers;
}

/// Figures of other wishes do not look as if they were of these.
void SweepWindow::wishesChanged()
{
    if (m_pieces.found)
        say();
}

void SweepWindow::addTolerances()
{
    m_pieces.tolerances = {};
    m_pieces.tolerances.normal = m_drawn->currentIndex() == 1;
    m_pieces.titles.clear();
    for (std::size_t k = 0; k < std::size(kinds); ++k) {
        if (!(m_spreads[k]->value() > 0))
            continue;
        for (Tolerance& one : kinds[k].make(m_pieces.start, m_spreads[k]->value())) {
            m_pieces.titles.push_back(tableWords(kinds[k].row).arg(namesOf(m_pieces.start, one)) + axisText(one));
            m_pieces.tolerances.all.push_back(std::move(one));
        }
    }
}

void SweepWindow::find()
{
    if (!takeTyped(*this))
        return;
    m_document.cancelGesture();
    m_lead.clear();
    // What was found is of the design as it is: more pieces, or another limit, go on from there.
    const bool more = m_pieces.found && asked() == m_pieces.asked;
    if (!more) {
        m_pieces.asked = asked();
        m_pieces.start = m_document.committed();
        addTolerances();
        forget(m_pieces.tolerances.all.empty()
                   ? tr("Nothing varies: give a tolerance above 0 of something that the design has.")
                   : tr("Covers with each tolerance are solved \u2026"));
        if (m_pieces.tolerances.all.empty())
            return;
    }
    m_pieces.limit = m_limit->value();
    m_run->setRunning(true);
    m_job.request({m_run->newRun(),
                   {m_pieces.start, m_session.files()},
                   m_pieces.tolerances,
                   static_cast<int>(m_samples->value()),
                   m_pieces.limit,
                   more ? m_pieces.found->known : SweepKnown{}},
                  true);
}

void SweepWindow::stop()
{
    m_run->newRun();
    m_job.cancel();
    m_run->setRunning(false);
    if (!m_pieces.found) {
        m_said->setText(tr("Stopped."));
        return;
    }
    m_pieces.found->whole = true;
    m_lead = tr("Stopped.");
    say();
}

void SweepWindow::take(SweepFound found)
{
    if (!m_run->isNow(found.number))
        return;
    if (!found.problem.empty() || found.p95.empty()) {
        m_run->setRunning(false);
        m_said->setText(translated(found.problem));
        return;
    }
    const bool first = !m_pieces.found,
               asBefore = m_pieces.found && !found.whole && m_pieces.found->solved == found.solved;
    m_pieces.found = std::move(found);
    if (asBefore)
        return; // its figures wait for more pieces
    if (m_pieces.found->whole)
        m_run->setRunning(false);
    say();
    if (first)
        fill();
    m_shown->setEnabled(true);
    showMap();
}

void SweepWindow::say()
{
    QStringList lines(m_lead.isEmpty() ? 0 : 1, m_lead);
    if (asked() != m_pieces.asked || m_limit->value() != m_pieces.limit)
        lines << tr("This is of what was set before: draw pieces for what is set now.");
    lines << figuresText() << outText();
    if (m_pieces.found->resting == 0)
        lines << (m_pieces.found->whole ? tr("That is as if covers were linear.")
                                        : tr("That is as if covers were linear; pieces are being solved \u2026"));
    else if (!m_pieces.found->whole)
        lines << tr("By %n solved pieces so far; more are being solved \u2026", nullptr, m_pieces.found->resting);
    else
        lines << tr("By %n solved pieces.", nullptr, m_pieces.found->resting);
    if (m_pieces.found->resting > 0 && !m_pieces.found->error)
        lines.back() += " " + tr("These are too few to say how sure that is.");
    if (m_pieces.found->error)
        lines.back() += " " + tr("\u00b1 is what many more of them may change.");
    const std::vector<std::size_t>& unknown = m_pieces.found->known.linear->unknown;
    if (!unknown.empty())
        lines << tr("With %n tolerances no cover is found, as with: %1. They are left out of this: make them "
                    "smaller.",
                    nullptr, static_cast<int>(unknown.size()))
                     .arg(m_pieces.titles[unknown.front()]);
    if (m_pieces.found->resting < m_pieces.found->solved)
        lines << tr("%n pieces have no cover at rest.", nullptr, m_pieces.found->solved - m_pieces.found->resting);
    m_said->setText(lines.join('\n'));
}

QString SweepWindow::figuresText() const
{
    const float most = *std::ranges::max_element(m_pieces.found->p95);
    const double rms = rmsOf(m_pieces.found->p95);
    return tr("95 % of the pieces do not exceed, place by place, %1 (rms over the cover), %2 where it is most.")
        .arg(m_pieces.found->error
                 ? QStringLiteral("%1 \u00b1 %2").arg(lengthFigure(rms, 2), lengthText(*m_pieces.found->error, 2))
                 : lengthText(rms, 2),
             lengthText(static_cast<double>(most), 2));
}

QString SweepWindow::outText() const
{
    const auto whole = [](double share) { return percentText(std::round(100 * share) / 100); };
    if (m_pieces.found->resting == 0)
        return tr("Out of the limit: about %1 of the pieces.")
            .arg(whole(static_cast<double>(m_pieces.found->out) / SweepFound::linearPieces));
    const auto [least, most] = shareOfMany(m_pieces.found->out, m_pieces.found->resting);
    return tr("Out of the limit: %1 of %2 pieces (of many: %3 to %4).")
        .arg(QString::number(m_pieces.found->out), QString::number(m_pieces.found->resting), whole(least),
             whole(most));
}

void SweepWindow::fill()
{
    m_list->clear();
    std::vector<std::size_t> order(m_pieces.found->influence.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::ranges::greater(),
                             [&](std::size_t k) { return m_pieces.found->influence[k]; });
    const QSignalBlocker quiet(m_list); // the first row is not yet chosen
    for (const std::size_t k : order) {
        auto* row = new QTreeWidgetItem(
            m_list, {m_pieces.titles[k], tr("%1 %").arg(decimalText(100 * m_pieces.found->influence[k], 1, true)),
                     steadyLengthText(m_pieces.found->mostMoved[k], 2)});
        const Tolerance& tolerance = m_pieces.tolerances.all[k];
        row->setData(0, Qt::UserRole,
                     number(tolerance.seam != noElement ? tolerance.seam : tolerance.freedoms.front().element));
        row->setToolTip(0, m_pieces.titles[k]);
        row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        row->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
    }
}

void SweepWindow::showMap()
{
    if (!m_pieces.found || !m_shown->isChecked()) {
        m_maps.setGuest(nullptr);
        return;
    }
    auto map = std::make_shared<ShownMap>();
    map->topology = m_pieces.found->known.linear->nominal->topology;
    map->values = m_pieces.found->p95;
    map->kind = MapScale::Kind::Sequential;
    map->limit = ShownMap::usualLimit(static_cast<double>(*std::ranges::max_element(m_pieces.found->p95)));
    map->title = tr("What 95 % of the pieces do not exceed");
    map->unit = millimetreSuffix;
    map->mark = static_cast<float>(m_pieces.limit);
    m_maps.setGuest(std::move(map));
}

/// Who chooses another map does not see this one any more.
void SweepWindow::mapsChanged()
{
    if (m_pieces.found && m_shown->isChecked() && !m_maps.hasGuest()) {
        const QSignalBlocker quiet(m_shown);
        m_shown->setChecked(false);
    }
}

void SweepWindow::rowChosen()
{
    if (const QTreeWidgetItem* row = m_list->currentItem())
        if (const auto id = static_cast<ElementId>(row->data(0, Qt::UserRole).toUInt());
            m_document.design().element(id))
            m_selection.set({id});
}

/// What was found is no longer of use.
void SweepWindow::forget(const QString& why)
{
    m_pieces.found.reset();
    m_list->clear();
    m_shown->setEnabled(false);
    m_maps.setGuest(nullptr);
    m_said->setText(why);
}

void SweepWindow::documentChanged()
{
    if ((!m_pieces.found && !m_run->running()) || hasSameCover(m_document.committed(), m_pieces.start))
        return;
    if (m_run->running())
        stop();
    forget(tr("The design has changed meanwhile: draw the pieces again."));
}

} // namespace bolster
