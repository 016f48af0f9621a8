#include "ReliefWindow.h"

#include "ColumnScroll.h"
#include "CoverView.h"
#include "DesignSession.h"
#include "FabricFields.h"
#include "NumberBox.h"
#include "PullNote.h"
#include "Pulls.h"
#include "RunRow.h"
#include "Translated.h"
#include "Units.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bolster {

namespace {

constexpr QSize pictureSize{240, 180}; // without the screen's scale
constexpr double hardlyAny = 0.005;    // of the cover, over the limit

/// "1.03 %", not to be broken: rms over the whole cover.
QString rmsText(double energy)
{
    const QString figure = decimalText(100 * std::sqrt(std::max(0.0, energy)), 2, true);
    return QCoreApplication::translate("Units", "%1 %").arg(figure).replace(u' ', QChar::Nbsp);
}

} // namespace

ReliefWindow::ReliefWindow(DesignSession& session, Selection& selection, CoverView& view, Mark mark,
                           std::shared_ptr<ReliefMemory> remembered, QWidget* parent)
    : QDialog(parent)
    , m_session(session)
    , m_document(session.document())
    , m_selection(selection)
    , m_view(view)
    , m_mark(std::move(mark))
    , m_remembered(std::move(remembered))
    , m_job(
          [this](const ReliefWanted& wanted, const std::stop_token& stop) {
              return findReliefs(
                  wanted,
                  [this, number = wanted.number](double share, const ReliefFound* known) {
                      std::optional<ReliefFound> seen;
                      if (known)
                          seen = *known;
                      m_run->later(number, [this, share, seen = std::move(seen)] {
                          m_run->setShare(share);
                          if (seen)
                              take(*seen);
                      });
                  },
                  stop);
          },
          [this](ReliefFound found) { take(std::move(found)); })
{
    setWindowTitle(tr("Relieve strain"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    keepEnterInNumbers(*this);
    recall();
    connect(&m_document, &Document::changed, this, &ReliefWindow::documentChanged);
    connect(&m_document, &Document::historyReplaced, this, &QDialog::close);
}

ReliefWindow::~ReliefWindow()
{
    m_job.cancel();
    unmark();
    *m_remembered = {m_ownLimit->isChecked(), m_limit->value(),   m_most->value(),
                     std::move(m_start),      std::move(m_found), std::move(m_made)};
}

void ReliefWindow::recall()
{
    if (!(m_remembered->most > 0))
        return;
    m_ownLimit->setChecked(m_remembered->ownLimit);
    m_limit->display(m_remembered->limit);
    m_most->display(m_remembered->most);
    m_start = m_remembered->start;
    m_found = m_remembered->found;
    m_made = m_remembered->made;
    m_aside = true;
    documentChanged();
}

void ReliefWindow::build()
{
    m_run = new RunRow(tr("&Look for changes"), tr("Looking for what relieves strain \u2026"), this);
    connect(m_run, &RunRow::started, this, &ReliefWindow::find);
    connect(m_run, &RunRow::stopped, this, &ReliefWindow::stop);
    m_said =
        new QLabel(tr("Where cloth is strained or pressed together more than it may be, changes of the pattern "
                      "are tried, and the best are solved."),
                   this);
    m_said->setWordWrap(true);
    m_cards = new QWidget;
    m_rows = new QVBoxLayout(m_cards);
    m_rows->setContentsMargins({});
    m_rows->addStretch(1);
    auto* scroll = new ColumnScroll(this);
    scroll->setWidget(m_cards);
    scroll->setAccessibleName(tr("Proposed changes"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(buildOrder());
    layout->addWidget(new PullNote(m_document, this));
    layout->addWidget(m_run);
    layout->addWidget(m_said);
    layout->addWidget(scroll, 1);
    layout->addWidget(buttons);
    const QRect screenArea = screen()->availableGeometry();
    constexpr int titleBar = 40; // pixels, at most
    resize(600, std::min(800, screenArea.height() - titleBar));
    if (const QWidget* window = parentWidget()) // over the pattern: the cover is what it is about
        move(window->geometry().left() + 24,
             std::min(window->geometry().top() + 80, screenArea.bottom() - height() - titleBar));
}

QWidget* ReliefWindow::buildOrder()
{
    auto* box = new QWidget(this);
    m_ownLimit = new QCheckBox(tr("Strain is at &most"), box);
    m_ownLimit->setToolTip(tr("Else the limits of the fabrics count"));
    m_limit = new NumberBox({tr(" %"), 2, strainLimit.least, strainLimit.most, 0.5}, box);
    m_limit->setAccessibleName(tr("Limit of strain"));
    m_limit->display(StretchLimits{}.along);
    m_limit->setEnabled(false);
    connect(m_ownLimit, &QCheckBox::toggled, m_limit, &QWidget::setEnabled);
    m_most = new NumberBox({millimetreSuffix, 2, 0.1, 100, 1, true}, box);
    m_most->display(ReliefOrder{}.most);
    auto* label = new QLabel(tr("Edges move &by at most"), box);
    label->setBuddy(m_most);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins({});
    row->addWidget(m_ownLimit);
    row->addWidget(m_limit);
    row->addSpacing(16);
    row->addWidget(label);
    row->addWidget(m_most);
    row->addStretch(1);
    return box;
}

void ReliefWindow::find()
{
    if (!takeTyped(*this))
        return;
    m_document.cancelGesture();
    m_before = m_aside ? std::nullopt : std::move(m_found);
    m_found.reset();
    m_made.reset();
    putAside({});
    m_start = m_document.committed();
    ReliefWanted wanted;
    wanted.number = m_run->newRun();
    wanted.input = {m_start, m_session.files()};
    if (m_ownLimit->isChecked())
        wanted.order.limit = m_limit->value();
    wanted.order.most = m_most->value();
    wanted.camera = m_view.navigation().camera();
    wanted.pictureSize = pictureSize * devicePixelRatioF();
    m_run->setRunning(true);
    m_said->setText(tr("Trying changes \u2026"));
    m_job.request(std::move(wanted), true);
}

void ReliefWindow::stop()
{
    m_run->newRun();
    m_job.cancel();
    m_run->setRunning(false);
    m_said->setText(m_found ? tr("Stopped. These are solved:") : tr("Stopped; nothing has changed."));
    if (!m_found && m_before) { // who meant to stop what had just ended
        m_found = std::exchange(m_before, std::nullopt);
        m_aside = false;
        showFound();
    }
}

void ReliefWindow::take(ReliefFound found)
{
    if (!m_run->isNow(found.number))
        return;
    if (found.whole)
        m_run->setRunning(false);
    if (!found.list.problem.empty()) {
        m_said->setText(translated(found.list.problem));
        return;
    }
    m_found = std::move(found);
    m_aside = false;
    showFound();
}

void ReliefWindow::showFound()
{
    const ReliefList& list = m_found->list;
    clearCards();
    if (!m_found->whole)
        m_said->setText(m_run->running() ? tr("The best changes are being solved \u2026")
                                         : tr("Stopped. These are solved:"));
    else if (!(list.now.area > 0))
        m_said->setText(tr("Nothing is strained over the limit."));
    else if (m_found->pictures.empty())
        m_said->setText(
            tr("%1 of the cover is over the limit. No change relieves it.").arg(percentText(list.now.area)));
    else if (list.now.area < hardlyAny)
        m_said->setText(
            tr("Hardly anything is over the limit: there is little to gain. \"Make it\" is one step that "
               "Undo takes back."));
    else
        m_said->setText(tr("Each is solved by itself; \"Make it\" is one step that Undo takes back."));
    addCard(m_found->now, tr("As it is now"),
            tr("%1 of the cover is over the limit, by %2 (rms of all of it).")
                .arg(percentText(list.now.area), rmsText(list.now.energy)));
    for (std::size_t k = 0; k < m_found->pictures.size(); ++k)
        addRelief(k);
}

void ReliefWindow::unmark()
{
    if (std::exchange(m_marked, false))
        m_mark(std::nullopt);
}

void ReliefWindow::clearCards()
{
    unmark();
    while (m_rows->count() > 1) { // the last one is the stretch
        QLayoutItem* item = m_rows->takeAt(0);
        item->widget()->deleteLater();
        delete item;
    }
}

QFrame* ReliefWindow::addCard(const QImage& picture, const QString& title, const QString& more)
{
    auto* card = new QFrame(m_cards);
    card->setFrameShape(QFrame::StyledPanel);
    auto* shown = new QLabel(card);
    QPixmap pixmap = QPixmap::fromImage(picture);
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    shown->setPixmap(pixmap);
    shown->setFixedSize(pictureSize);
    auto* heading = new QLabel(title, card);
    QFont bold = heading->font();
    bold.setBold(true);
    heading->setFont(bold);
    heading->setWordWrap(true);
    auto* text = new QLabel(more, card);
    text->setWordWrap(true);
    text->setContentsMargins(0, 2, 0, 0); // for the dots of a capital letter
    auto* words = new QVBoxLayout;
    words->addWidget(heading);
    words->addWidget(text);
    words->addStretch(1);
    auto* row = new QHBoxLayout(card);
    row->addWidget(shown);
    row->addLayout(words, 1);
    m_rows->insertWidget(m_rows->count() - 1, card);
    return card;
}

void ReliefWindow::addRelief(std::size_t place)
{
    const Relief& relief = m_found->list.reliefs[place];
    const OverLimit& now = m_found->list.now;
    QStringList lines{tr("Over the limit: %1 of the cover, then %2")
                          .arg(percentText(now.area), percentText(now.area * (1 - relief.solved->area))),
                      tr("Strain over it (rms): %1, then %2")
                          .arg(rmsText(now.energy), rmsText(now.energy * (1 - relief.solved->energy)))};
    if (relief.sewn > 0)
        lines << (relief.kind == Relief::Kind::Dart
                      ? tr("Sewn: %1 more").arg(lengthText(relief.sewn, 0))
                      : tr("Sides of seams differ by %1 more").arg(lengthText(relief.sewn)));
    if (relief.moved > 0)
        lines << tr("Outlines change by %1").arg(lengthText(relief.moved));
    lines << tr("The cover moves by %1 (rms).").arg(lengthText(relief.shape));
    for (const ScanChange& scan : scanChanges(m_found->list, relief))
        lines << tr("From %1 (rms): %2, then %3")
                     .arg(isolated(QString::fromStdString(scan.name)), lengthText(scan.before, 2),
                          lengthText(scan.after, 2));
    QFrame* card = addCard(m_found->pictures[place], translated(relief.text), lines.join('\n'));
    auto* show = new QPushButton(tr("Show where"), card);
    show->setAutoDefault(false);
    connect(show, &QPushButton::clicked, this, [this, id = relief.element, place = relief.place] {
        m_selection.set({id});
        m_mark(CoverPoint{place.patch, place.at});
        m_marked = true;
    });
    auto* takes = new QPushButton(tr("Make it"), card);
    takes->setAutoDefault(false);
    takes->setAccessibleName(tr("Make it: %1").arg(translated(relief.text)));
    connect(takes, &QPushButton::clicked, this, [this, place] { make(place); });
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(show);
    row->addWidget(takes);
    static_cast<QVBoxLayout*>(card->layout()->itemAt(1)->layout())->addLayout(row);
}

void ReliefWindow::make(std::size_t place)
{
    const Relief relief = m_found->list.reliefs[place];
    if (m_run->running())
        stop();
    m_aside = true; // what the commit makes of the design is no surprise
    m_document.commit(relief.edit);
    if (hasSameCover(m_document.committed(), m_start)) { // it was refused, which is said elsewhere
        m_aside = false;
        return;
    }
    m_made = m_document.committed();
    putAside(tr("Made. Undo takes it back; look again to see what helps now."));
    m_selection.set({relief.element});
}

/// What was found is of no use for the design as it is now.
void ReliefWindow::putAside(const QString& why)
{
    m_aside = true;
    clearCards();
    m_said->setText(why);
}

/// Who works on meanwhile has another design; what was found comes back with the one that it was found for.
void ReliefWindow::documentChanged()
{
    if (!m_found && !m_run->running())
        return;
    const Design& now = m_document.committed();
    if (hasSameCover(now, m_start)) {
        if (m_found && std::exchange(m_aside, false))
            showFound();
        return;
    }
    if (m_run->running())
        stop();
    if (m_made && hasSameCover(now, *m_made))
        putAside(tr("Made. Undo takes it back; look again to see what helps now."));
    else
        putAside(tr("The design has changed meanwhile: look again, or undo that."));
}

} // namespace bolster
