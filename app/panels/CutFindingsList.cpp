#include "CutFindingsList.h"

#include "ElementText.h"
#include "Icons.h"
#include "Translated.h"
#include "ViewColors.h"

#include <utility>

namespace bolster {

CutFindingsList::CutFindingsList(QWidget* parent)
    : QListWidget(parent)
{
    setAccessibleName(tr("What to look at before cutting"));
    setWordWrap(true);
    setResizeMode(Adjust);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(ScrollPerPixel);
    connect(this, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
        if (const auto place = static_cast<std::size_t>(row(item)); place < m_findings.size())
            emit chosen(CutFinding(m_findings[place])); // a copy: who hears it may change the list
    });
}

void CutFindingsList::setFindings(const Design& design, std::vector<CutFinding> findings)
{
    const int before = currentRow();
    std::optional<Problem> current;
    if (before >= 0 && before < static_cast<int>(m_findings.size()))
        current = m_findings[static_cast<std::size_t>(before)].problem;
    m_findings = std::move(findings);
    clear();
    const QIcon sign = icon(QStringLiteral("warning"), ViewColors::of(palette()).warning);
    for (const CutFinding& finding : m_findings) {
        auto* item = new QListWidgetItem(
            sign,
            tr("%1: %2").arg(displayName(design, finding.problem.element), translated(finding.problem.message)),
            this);
        if (current == finding.problem)
            setCurrentItem(item);
    }
}

} // namespace bolster
