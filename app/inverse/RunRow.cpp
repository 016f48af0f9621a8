#include "RunRow.h"

#include "Jobs.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>

namespace bolster {

namespace {

constexpr int tooLate = 1000; // ms

} // namespace

RunRow::RunRow(QString text, QString job, QWidget* parent)
    : QWidget(parent)
    , m_text(std::move(text))
    , m_job(std::move(job))
    , m_bar(new QProgressBar(this))
    , m_button(new QPushButton(this))
{
    m_bar->setRange(0, 100);
    QSizePolicy keeps = m_bar->sizePolicy();
    keeps.setRetainSizeWhenHidden(true);
    m_bar->setSizePolicy(keeps);
    m_button->setDefault(true);
    connect(m_button, &QPushButton::clicked, this, [this] {
        if (m_running) {
            emit stopped();
            m_ended.invalidate();
        } else if (!m_ended.isValid() || m_ended.hasExpired(tooLate))
            emit started();
    });
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins({});
    row->addWidget(m_bar, 1);
    row->addWidget(m_button);
    setRunning(false);
}

RunRow::~RunRow() = default;

void RunRow::setRunning(bool running)
{
    if (m_running && !running)
        m_ended.start();
    m_running = running ? std::make_unique<RunningJob>(m_job, [this] { emit stopped(); }) : nullptr;
    m_button->setText(running ? tr("&Stop") : m_text);
    m_bar->setVisible(running);
    m_bar->setValue(0);
}

void RunRow::setShare(double share)
{
    m_bar->setValue(static_cast<int>(100 * share));
    if (m_running)
        m_running->report(share);
}

void RunRow::later(int run, std::function<void()> what)
{
    QMetaObject::invokeMethod(
        this,
        [this, run, what = std::move(what)] {
            if (isNow(run))
                what();
        },
        Qt::QueuedConnection);
}

std::function<void(double)> RunRow::sharesOf(int run)
{
    return [this, run](double share) { later(run, [this, share] { setShare(share); }); };
}

} // namespace bolster
