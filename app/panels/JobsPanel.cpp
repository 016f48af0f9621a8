#include "JobsPanel.h"

#include "Jobs.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace bolster {

JobsPanel::JobsPanel(QWidget* parent)
    : QWidget(parent)
{
    auto* inside = new QWidget;
    m_list = new QVBoxLayout(inside);
    m_list->setContentsMargins(10, 10, 10, 10);
    m_nothing = new QLabel(tr("Nothing is being worked at."), inside);
    m_nothing->setForegroundRole(QPalette::PlaceholderText);
    m_nothing->setWordWrap(true);
    m_list->addWidget(m_nothing);
    m_list->addStretch();
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(inside);
    scroll->setAccessibleName(tr("Jobs"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
    connect(&Jobs::all(), &Jobs::changed, this, &JobsPanel::fill);
    connect(&Jobs::all(), &Jobs::progressed, this, &JobsPanel::showProgress);
    fill();
}

void JobsPanel::fill()
{
    const QList<Jobs::Job>& jobs = Jobs::all().running();
    for (const int number : m_rows.keys())
        if (std::ranges::find(jobs, number, &Jobs::Job::number) == jobs.end())
            m_rows.take(number).widget->deleteLater();
    for (const Jobs::Job& job : jobs)
        if (!m_rows.contains(job.number)) {
            addJob(job.number, job.name);
            showProgress(job.number, job.share);
        }
    m_nothing->setVisible(jobs.isEmpty());
}

void JobsPanel::addJob(int number, const QString& name)
{
    auto* row = new QWidget(m_nothing->parentWidget());
    auto* label = new QLabel(name, row);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    auto* bar = new QProgressBar(row);
    bar->setTextVisible(false);
    auto* stop = new QPushButton(tr("Stop"), row);
    connect(stop, &QPushButton::clicked, this, [number, stop] {
        stop->setEnabled(false); // it may take a moment
        Jobs::all().cancel(number);
    });
    auto* below = new QHBoxLayout;
    below->addWidget(bar, 1);
    below->addWidget(stop);
    auto* layout = new QVBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 6);
    layout->addWidget(label);
    layout->addLayout(below);
    m_list->insertWidget(m_list->count() - 1, row);
    m_rows.insert(number, {row, bar});
}

void JobsPanel::showProgress(int number, double share)
{
    constexpr int steps = 100;
    const auto row = m_rows.constFind(number);
    if (row == m_rows.constEnd())
        return;
    row->bar->setRange(0, share < 0 ? 0 : steps); // without an end it moves
    row->bar->setValue(share < 0 ? 0 : static_cast<int>(steps * share));
}

} // namespace bolster
