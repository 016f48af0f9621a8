#include "StatusLine.h"

#include "Ask.h"
#include "ElidedLabel.h"
#include "Icons.h"
#include "Translated.h"
#include "Units.h"
#include "ViewColors.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QToolButton>
#include <QWhatsThis>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace bolster {

/// Of the colour of the mood.
class StateDot : public QWidget {
public:
    explicit StateDot(QWidget* parent)
        : QWidget(parent)
    {
        setFixedSize(10, 10);
    }

    void setColor(const QColor& color)
    {
        if (color == m_color)
            return;
        m_color = color;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_color);
        painter.drawEllipse(QRectF(rect()).adjusted(1, 1, -1, -1));
    }

private:
    QColor m_color = Qt::gray;
};

namespace {

using namespace std::chrono_literals;

constexpr auto shortFlash = 6s;
constexpr auto longFlash = 20s;

/// What a designer can do about a cover that does not come to rest.
QString unrestText()
{
    return StatusLine::tr("The cloth went on moving until the computation was ended. What usually causes that:\n"
                          "\u2022 A piece that nothing holds: fix one of its edges, or sew it on.\n"
                          "\u2022 A seam whose two sides differ much in length: make them more alike.\n"
                          "\u2022 A very long or very narrow piece: divide it, or make it wider.\n"
                          "\u2022 High pressure: lower it in the properties of the patch.\n"
                          "What you see is where the cloth was at the end.");
}

bool hasWarnings(const Problems& problems)
{
    return std::ranges::any_of(problems, [](const Problem& p) { return p.severity == Severity::Warning; });
}

} // namespace

QColor StatusLine::colorOf(Mood mood)
{
    switch (mood) {
    case Mood::Idle:
        return {0x7f, 0x86, 0x8f};
    case Mood::Busy:
        return {0xb8, 0x74, 0x00};
    case Mood::Good:
        return {0x27, 0x8a, 0x4f};
    case Mood::Worried:
        return {0xd8, 0x61, 0x1a};
    case Mood::Failed:
        return {0xd9, 0x46, 0x3a};
    }
    return Qt::gray;
}

StatusLine::StatusLine(QWidget* parent)
    : QStatusBar(parent)
    , m_promptLabel(new ElidedLabel(this))
    , m_why(new QToolButton(this))
    , m_coordinates(new QLabel(this))
    , m_note(new QLabel(this))
    , m_problems(new QToolButton(this))
    , m_dot(new StateDot(this))
    , m_solver(new ElidedLabel(this))
    , m_show(new QToolButton(this))
    , m_unrest(new QToolButton(this))
{
    setSizeGripEnabled(false);
    setContentsMargins(8, 0, 8, 0);
    m_coordinates->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("x 0000.00   y 0000.00 mm")));
    m_coordinates->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_note->hide();
    m_problems->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_why->setObjectName(QStringLiteral("why"));
    m_why->setText(tr("Why?"));
    m_show->setObjectName(QStringLiteral("show-finding"));
    m_show->setMenu(new QMenu(m_show));
    m_unrest->setObjectName(QStringLiteral("why-unrest"));
    m_unrest->setText(tr("Why?"));
    for (QToolButton* button : {m_problems, m_why, m_show, m_unrest}) {
        button->setAutoRaise(true);
        button->hide();
    }
    addPrompt();
    addPermanentWidget(m_note);
    addPermanentWidget(m_coordinates);
    addPermanentWidget(m_problems);
    addSolver();
    connectButtons();
    connect(&NumberStyles::instance(), &NumberStyles::changed, this, [this] {
        if (m_where)
            m_coordinates->setText(m_where());
        showState(); // a finding may have a length in it
    });
}

void StatusLine::addPrompt()
{
    auto* prompt = new QWidget(this);
    auto* words = new QHBoxLayout(prompt);
    words->setContentsMargins(0, 0, 0, 0);
    words->setSpacing(6);
    words->addWidget(m_why); // first, where nothing beside it can move it
    words->addWidget(m_promptLabel, 1);
    addWidget(prompt, 1);
}

void StatusLine::addSolver()
{
    auto* solver = new QWidget(this);
    auto* row = new QHBoxLayout(solver);
    row->setContentsMargins(8, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(m_dot);
    row->addWidget(m_solver, 1);
    row->addWidget(m_unrest);
    row->addWidget(m_show);
    solver->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("Solved - 00000 iterations")) + 40);
    addPermanentWidget(solver);
    m_solver->installEventFilter(this);
}

void StatusLine::connectButtons()
{
    connect(m_unrest, &QToolButton::clicked, this,
            [this] { QWhatsThis::showText(m_unrest->mapToGlobal(QPoint()), unrestText(), m_unrest); });
    connect(m_show, &QToolButton::clicked, this, &StatusLine::goThere);
    connect(m_show->menu(), &QMenu::aboutToShow, this, &StatusLine::fillMenu);
    connect(m_problems, &QToolButton::clicked, this, &StatusLine::problemsWanted);
    connect(m_why, &QToolButton::clicked, this, [this] {
        m_flashTime.start(longFlash); // there is something to read
        QWhatsThis::showText(m_why->mapToGlobal(QPoint()), m_reasons, m_why);
    });
    m_flashTime.setParent(this);
    m_flashTime.setObjectName(QStringLiteral("flash-time"));
    m_flashTime.setSingleShot(true);
    connect(&m_flashTime, &QTimer::timeout, this, [this] {
        m_flash.clear();
        if (const auto next = std::exchange(m_next, std::nullopt))
            return flashWithReason(next->first, next->second);
        showPrompt();
    });
}

void StatusLine::setPrompt(const QString& prompt)
{
    m_prompt = prompt;
    showPrompt();
}

void StatusLine::flashWithReason(const QString& message, const QString& why)
{
    m_next.reset();
    m_flash = asSentence(message);
    m_reasons = why;
    m_flashTime.start(why.isEmpty() ? shortFlash : longFlash);
    showPrompt();
}

void StatusLine::flashNext(const QString& message, const QString& why)
{
    if (m_flash.isEmpty() || !m_reasons.isEmpty())
        flashWithReason(message, why);
    else
        m_next = {message, why};
}

void StatusLine::forgetReason()
{
    m_next.reset();
    if (!m_reasons.isEmpty())
        flash({});
}

void StatusLine::showPrompt()
{
    m_promptLabel->setFullText(m_flash.isEmpty() ? m_prompt : m_flash);
    m_why->setVisible(!m_flash.isEmpty() && !m_reasons.isEmpty());
}

void StatusLine::setCoordinates(const std::function<QString()>& text)
{
    m_where = text;
    m_coordinates->setText(text());
}

void StatusLine::setSolver(const SolverStatus& status, bool paused, bool preview)
{
    m_status = status;
    m_paused = paused;
    m_preview = preview;
    showState();
}

void StatusLine::setFindings(const std::vector<CoverFinding>& findings, bool known)
{
    m_findings = findings;
    m_findingsKnown = known;
    showState();
}

StatusLine::Mood StatusLine::mood() const
{
    using State = SolverStatus::State;
    if (m_paused || m_status.state == State::Idle)
        return Mood::Idle;
    if (m_status.state == State::Failed)
        return Mood::Failed;
    if (m_status.state != State::Settled || !m_status.resting)
        return Mood::Busy;
    if (m_preview)
        return Mood::Idle;
    if (!m_status.reason.empty())
        return Mood::Worried;
    if (!m_findingsKnown)
        return Mood::Busy;
    return m_status.problems.empty() && m_findings.empty() ? Mood::Good : Mood::Worried;
}

QString StatusLine::stateText() const
{
    using State = SolverStatus::State;
    switch (m_paused ? State::Idle : m_status.state) {
    case State::Idle:
        return m_paused ? tr("Paused") : tr("Nothing to sew yet");
    case State::Preparing:
        return preparing();
    case State::Moving:
        return tr("Moving, %1/s").arg(QLocale().toString(std::lround(m_status.iterationsPerSecond)));
    case State::Failed:
        return translated(m_status.reason);
    case State::Settled:
        break;
    }
    if (!m_status.resting)
        return tr("Following the drag");
    if (m_preview)
        return tr("A preview, not checked yet");
    if (mood() == Mood::Busy) // what is not seen yet is not called solved, not in part either
        return tr("Drawing and checking \u2026");
    if (hasErrors(m_status.problems))
        return tr("Solved in part");
    if (restless())
        return translated(m_status.reason);
    if (m_findingsKnown && !m_findings.empty())
        return translated(m_findings.front().text);
    if (hasWarnings(m_status.problems))
        return tr("Solved, with warnings");
    return tr("Solved \u2013 %1 iterations").arg(QLocale().toString(m_status.iterations));
}

QString StatusLine::preparing() const
{
    switch (m_status.stage) {
    case SolverStatus::Stage::Triangles:
        break;
    case SolverStatus::Stage::FewerTriangles:
        return tr("Preparing: on fewer triangles \u2026");
    case SolverStatus::Stage::Equations:
        return tr("Preparing: forces and equations \u2026");
    }
    return tr("Preparing \u2026");
}

/// It has stopped without having come to rest.
bool StatusLine::restless() const
{
    return !m_paused && !m_preview && m_status.state == SolverStatus::State::Settled && m_status.resting &&
           !hasErrors(m_status.problems) && !m_status.reason.empty();
}

void StatusLine::showState()
{
    m_dot->setColor(colorOf(mood()));
    m_solver->setFullText(stateText());
    const auto count = static_cast<int>(m_findings.size());
    m_show->setVisible(finds() || blames());
    m_unrest->setVisible(restless());
    m_show->setText(finds() && count > 1 ? tr("Show (%1)").arg(count) : tr("Show"));
    m_show->setPopupMode(finds() && count > 1 ? QToolButton::InstantPopup : QToolButton::MenuButtonPopup);
    m_solver->setCursor(finds() || blames() ? Qt::PointingHandCursor : Qt::ArrowCursor);
    // Long sentences get room, but not that of the prompt.
    const int wanted = m_solver->fontMetrics().horizontalAdvance(m_solver->fullText()) + 8;
    m_solver->setMinimumWidth(std::min(wanted, 2 * width() / 5));
}

bool StatusLine::finds() const
{
    const bool atRest =
        !m_paused && !m_preview && m_status.state == SolverStatus::State::Settled && m_status.resting;
    return atRest && m_findingsKnown && !m_findings.empty();
}

/// An element for a failure.
bool StatusLine::blames() const
{
    return !m_paused && m_status.state == SolverStatus::State::Failed && m_status.culprit != noElement;
}

QString StatusLine::solverKey() const
{
    const bool failed = !m_paused && m_status.state == SolverStatus::State::Failed;
    if (failed || restless())
        return QString::fromStdString(m_status.reason.key);
    return finds() ? QString::fromStdString(m_findings.front().text.key) : QString();
}

/// To what the line speaks of.
void StatusLine::goThere()
{
    if (!m_show->isVisible())
        return;
    if (m_status.state == SolverStatus::State::Failed)
        emit culpritWanted(m_status.culprit);
    else
        emit findingWanted(m_findings.front());
}

void StatusLine::fillMenu()
{
    QMenu& menu = *m_show->menu();
    menu.clear();
    if (finds() && m_findings.size() > 1) {
        for (const CoverFinding& finding : m_findings)
            menu.addAction(translated(finding.text).replace(u'&', QStringLiteral("&&")), this,
                           [this, finding] { emit findingWanted(finding); });
        menu.addSeparator();
    }
    menu.addAction(tr("&What does it mean?"), this, [this] { emit meaningWanted(solverKey()); });
}

bool StatusLine::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_solver && event->type() == QEvent::MouseButtonRelease)
        goThere();
    return QStatusBar::eventFilter(watched, event);
}

QString StatusLine::solverText() const
{
    return m_solver->fullText();
}

void StatusLine::setProblems(int errors, int warnings)
{
    m_problems->setVisible(errors + warnings > 0);
    const ViewColors colors = ViewColors::of(palette());
    m_problems->setIcon(errors > 0 ? icon(QStringLiteral("error"), colors.error)
                                   : icon(QStringLiteral("warning"), colors.warning));
    QStringList parts;
    if (errors > 0)
        parts << tr("%n problems", nullptr, errors);
    if (warnings > 0)
        parts << tr("%n warnings", nullptr, warnings);
    m_problems->setText(parts.join(QStringLiteral(", ")));
}

void StatusLine::setRendererNote(const QString& note)
{
    m_note->setText(note);
    m_note->setVisible(!note.isEmpty());
}

} // namespace bolster
