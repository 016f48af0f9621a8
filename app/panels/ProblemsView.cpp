#include "ProblemsView.h"

#include "Icons.h"
#include "ProblemSet.h"
#include "Translated.h"
#include "ViewColors.h"

namespace bolster {

namespace {

constexpr int keyRole = Qt::UserRole + 1;

} // namespace

ProblemsView::ProblemsView(const ProblemSet& problems, QWidget* parent)
    : QListWidget(parent)
    , m_problems(problems)
{
    setFrameShape(NoFrame);
    setWordWrap(true);
    setResizeMode(Adjust);
    setSpacing(2);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(ScrollPerPixel);
    connect(&problems, &ProblemSet::changed, this, &ProblemsView::fill);
    connect(this, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { emit chosen(ElementId{item->data(Qt::UserRole).toInt()}); });
    fill();
}

void ProblemsView::fill()
{
    clear();
    const QIcon error = icon(QStringLiteral("error"), ViewColors::of(palette()).error);
    const QIcon warning = icon(QStringLiteral("warning"), ViewColors::of(palette()).warning);
    // Errors first: a warning stops nothing.
    for (const Severity severity : {Severity::Error, Severity::Warning})
        for (const Problem& problem : m_problems.all()) {
            if (problem.severity != severity)
                continue;
            auto* item =
                new QListWidgetItem(severity == Severity::Error ? error : warning, translated(problem), this);
            item->setData(Qt::UserRole, number(problem.element));
            item->setData(keyRole, QString::fromStdString(problem.message.key));
            item->setToolTip(tr("F1: what it means, and what to do"));
        }
}

QString ProblemsView::currentKey() const
{
    return currentItem() ? currentItem()->data(keyRole).toString() : QString();
}

} // namespace bolster
