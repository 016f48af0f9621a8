#include "StatusLine.h"

#include "ElidedLabel.h"
#include "Icons.h"
#include "Translated.h"
#include "Units.h"
#include "ViewColors.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QPainter>
#include <QToolButton>
#include <QWhatsThis>

#include <chrono>
#include <cmath>

namespace bolster {

/// Green: solved; amber: moving; red: failed; grey: nothing to do.
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

QString stateText(const SolverStatus& status)
{
    const QString iterations = QLocale().toString(status.iterations);
    switch (status.state) {
    case SolverStatus::State::Idle:
        return StatusLine::tr("Nothing to sew yet");
    case SolverStatus::State::Preparing:
        return StatusLine::tr("Preparing \u2026");
    case SolverStatus::State::Moving:
        return StatusLine::tr("Moving, %1/s").arg(QLocale().toString(std::lround(status.iterationsPerSecond)));
    case SolverStatus::State::Settled:
        return hasErrors(status.problems) ? StatusLine::tr("Solved in part")
                                          : StatusLine::tr("Solved \u2013 %1 iterations").arg(iterations);
    case SolverStatus::State::Failed:
        return translated(status.reason);
    }
    return {};
}

QColor stateColor(const SolverStatus& status)
{
    switch (status.state) {
    case SolverStatus::State::Idle:
        return {0x9a, 0xa0, 0xa8};
    case SolverStatus::State::Preparing:
    case SolverStatus::State::Moving:
        return {0xe0, 0x9a, 0x1a};
    case SolverStatus::State::Settled:
        return hasErrors(status.problems) ? QColor(0xe0, 0x9a, 0x1a) : QColor(0x2e, 0x9e, 0x5b);
    case SolverStatus::State::Failed:
        return {0xd0, 0x3a, 0x2d};
    }
    return Qt::gray;
}

} // namespace

StatusLine::StatusLine(QWidget* parent)
    : QStatusBar(parent)
    , m_promptLabel(new ElidedLabel(this))
    , m_why(new QToolButton(this))
    , m_coordinates(new QLabel(this))
    , m_note(new QLabel(this))
    , m_problems(new QToolButton(this))
    , m_dot(new StateDot(this))
    , m_solver(new ElidedLabel(this))
{
    setSizeGripEnabled(false);
    setContentsMargins(8, 0, 8, 0);
    m_coordinates->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("x 0000.0   y 0000.0 mm")));
    m_coordinates->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_problems->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_problems->setAutoRaise(true);
    m_problems->hide();
    m_note->hide();
    m_why->setObjectName(QStringLiteral("why"));
    m_why->setText(tr("Why?"));
    m_why->setAutoRaise(true);
    m_why->hide();

    auto* prompt = new QWidget(this);
    auto* words = new QHBoxLayout(prompt);
    words->setContentsMargins(0, 0, 0, 0);
    words->setSpacing(6);
    words->addWidget(m_promptLabel, 1);
    words->addWidget(m_why);
    addWidget(prompt, 1);
    addPermanentWidget(m_note);
    addPermanentWidget(m_coordinates);
    addPermanentWidget(m_problems);
    auto* solver = new QWidget(this);
    auto* row = new QHBoxLayout(solver);
    row->setContentsMargins(8, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(m_dot);
    row->addWidget(m_solver, 1);
    solver->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("Solved - 00000 iterations")) + 40);
    addPermanentWidget(solver);

    connect(m_problems, &QToolButton::clicked, this, &StatusLine::problemsWanted);
    connect(m_why, &QToolButton::clicked, this, [this] {
        m_flashTime.start(longFlash); // there is something to read
        QWhatsThis::showText(m_why->mapToGlobal(QPoint()), m_reasons, m_why);
    });
    m_flashTime.setSingleShot(true);
    connect(&m_flashTime, &QTimer::timeout, this, [this] {
        m_flash.clear();
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
    m_flash = message;
    m_reasons = why;
    m_flashTime.start(why.isEmpty() ? shortFlash : longFlash);
    showPrompt();
}

void StatusLine::showPrompt()
{
    m_promptLabel->setFullText(m_flash.isEmpty() ? m_prompt : m_flash);
    m_why->setVisible(!m_flash.isEmpty() && !m_reasons.isEmpty());
}

void StatusLine::setCoordinates(const QString& text)
{
    m_coordinates->setText(text);
}

void StatusLine::setSolver(const SolverStatus& status, bool paused)
{
    m_dot->setColor(paused ? QColor(0x9a, 0xa0, 0xa8) : stateColor(status));
    m_solver->setFullText(paused ? tr("Paused") : stateText(status));
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
