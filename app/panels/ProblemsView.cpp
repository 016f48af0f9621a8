#include "ProblemsView.h"

#include "Document.h"
#include "ElementText.h"
#include "Icons.h"
#include "ProblemSet.h"
#include "SeamColors.h"
#include "Translated.h"
#include "ViewColors.h"

#include <QPainter>

#include <algorithm>

namespace bolster {

namespace {

constexpr int keyRole = Qt::UserRole + 1;
constexpr int findingRole = Qt::UserRole + 2; ///< its place among the findings

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
    connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { choose(*item); });
    connect(this, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) { choose(*item); });
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
            QListWidgetItem* item =
                addRow(severity == Severity::Error ? error : warning, textOf(problem), problem.message.key);
            item->setData(Qt::UserRole, number(problem.element));
        }
    for (std::size_t i = 0; i < m_findings.size(); ++i) {
        const Message& text = m_findings[i].text;
        addRow(warning, translated(text), text.key)->setData(findingRole, static_cast<int>(i));
    }
}

void ProblemsView::forgetFindings()
{
    m_findingsKnown = false;
    if (m_findings.empty())
        return;
    m_findings.clear();
    fill();
}

QListWidgetItem* ProblemsView::addRow(const QIcon& sign, const QString& text, const std::string& key)
{
    auto* item = new QListWidgetItem(sign, text, this);
    item->setData(keyRole, QString::fromStdString(key));
    item->setToolTip(tr("F1: what it means, and what to do"));
    return item;
}

void ProblemsView::choose(const QListWidgetItem& item)
{
    if (const QVariant finding = item.data(findingRole); finding.isValid())
        emit findingChosen(CoverFinding(m_findings.at(finding.toUInt()))); // who hears it may change the list
    else
        emit chosen(ElementId{item.data(Qt::UserRole).toInt()});
}

void ProblemsView::setFindings(const std::vector<CoverFinding>& findings, bool known)
{
    m_findingsKnown = known;
    if (known && std::ranges::equal(findings, m_findings, {}, &CoverFinding::text, &CoverFinding::text)) {
        m_findings = findings; // the same sentences: what is chosen in the list stays so
        viewport()->update();
        return;
    }
    if (known) {
        m_findings = findings;
        fill();
    }
}

/// By the names that the other panels have; where there is no element, by the place in the file.
QString ProblemsView::textOf(const Problem& problem) const
{
    const ElementPtr element = m_document.design().element(problem.element);
    if (!element || problem.element == settingsId || std::holds_alternative<Quarantined>(*element))
        return translated(problem);
    QString name = displayName(m_document.design(), problem.element);
    if (const QString letter = seamLetter(m_document.design(), problem.element); !letter.isEmpty())
        name += QStringLiteral(", ") + letter;
    return tr("%1: %2").arg(name, translated(problem.message));
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
                     m_findingsKnown ? tr("Nothing to worry about.") : tr("All elements can be used."));
}

QString ProblemsView::currentKey() const
{
    return currentItem() ? currentItem()->data(keyRole).toString() : QString();
}

} // namespace bolster
