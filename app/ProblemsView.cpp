#include "ProblemsView.h"

#include "Icons.h"
#include "ProblemSet.h"
#include "Translated.h"
#include "ViewColors.h"

#include <QHeaderView>

namespace bolster {

ProblemsView::ProblemsView(const ProblemSet& problems, QWidget* parent)
    : QTreeWidget(parent)
    , m_problems(problems)
{
    setHeaderLabels({tr("Element"), tr("Problem")});
    setRootIsDecorated(false);
    setFrameShape(NoFrame);
    setWordWrap(true);
    setAlternatingRowColors(true);
    header()->setStretchLastSection(true);
    header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    connect(&problems, &ProblemSet::changed, this, &ProblemsView::fill);
    connect(this, &QTreeWidget::itemClicked, this,
            [this](QTreeWidgetItem* item) { emit chosen(ElementId{item->data(0, Qt::UserRole).toInt()}); });
    fill();
}

void ProblemsView::fill()
{
    clear();
    const QColor error = ViewColors::of(palette()).error;
    // Errors first: a warning stops nothing.
    for (const Severity severity : {Severity::Error, Severity::Warning})
        for (const Problem& problem : m_problems.all()) {
            if (problem.severity != severity)
                continue;
            const QString place = QString::fromStdString(problem.label.empty() ? problem.field : problem.label);
            auto* item = new QTreeWidgetItem(this, {place, translated(problem.message)});
            item->setIcon(0, severity == Severity::Error
                                 ? icon(QStringLiteral("error"), error)
                                 : icon(QStringLiteral("warning"), QColor(0xd9, 0x8a, 0x00)));
            item->setData(0, Qt::UserRole, number(problem.element));
            item->setToolTip(1, translated(problem));
        }
}

} // namespace bolster
