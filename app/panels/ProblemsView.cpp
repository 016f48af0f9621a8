#include "ProblemsView.h"

#include "Document.h"
#include "ElementText.h"
#include "Icons.h"
#include "ProblemSet.h"
#include "Translated.h"
#include "ViewColors.h"

#include <QPainter>

namespace bolster {

namespace {

constexpr int keyRole = Qt::UserRole + 1;

} // namespace

ProblemsView::ProblemsView(const ProblemSet& problems, const Document& document, QWidget* parent)
    : QListWidget(parent)
    , m_problems(problems)
    , m_document(document)
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
            auto* item = new QListWidgetItem(severity == Severity::Error ? error : warning, textOf(problem), this);
            item->setData(Qt::UserRole, number(problem.element));
            item->setData(keyRole, QString::fromStdString(problem.message.key));
            item->setToolTip(tr("F1: what it means, and what to do"));
        }
}

/// By the names that the other panels have; where there is no element, by the place in the file.
QString ProblemsView::textOf(const Problem& problem) const
{
    const ElementPtr element = m_document.design().element(problem.element);
    if (!element || problem.element == settingsId || std::holds_alternative<Quarantined>(*element))
        return translated(problem);
    return tr("%1: %2").arg(displayName(m_document.design(), problem.element), translated(problem.message));
}

/// An empty list might be one that waits.
void ProblemsView::paintEvent(QPaintEvent* event)
{
    QListWidget::paintEvent(event);
    if (count() > 0)
        return;
    QPainter painter(viewport());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(viewport()->rect().adjusted(8, 8, -8, -8), Qt::AlignTop | Qt::AlignLeft | Qt::TextWordWrap,
                     tr("All elements can be used. How the cover is, the line at the bottom says."));
}

QString ProblemsView::currentKey() const
{
    return currentItem() ? currentItem()->data(keyRole).toString() : QString();
}

} // namespace bolster
