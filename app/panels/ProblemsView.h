// The list of everything that is wrong, with the design and in its cover; a click shows the place.
#pragma once

#include "CoverFindings.h"
#include "Problem.h"

#include <QListWidget>

namespace bolster {

class Document;
class ProblemSet;

class ProblemsView : public QListWidget {
    Q_OBJECT

public:
    ProblemsView(const ProblemSet& problems, const Document& document, QWidget* parent = nullptr);

    /// What there is to worry about in the cover, the worst first; `known`: it is that of the cover that is shown.
    /// Those of the cover before stay in the list until then.
    void setFindings(const std::vector<CoverFinding>& findings, bool known);
    /// There is no cover that they would be about.
    void forgetFindings();

    /// Of the problem that is chosen: the key of its message, by which the manual knows it; "" when there is none.
    QString currentKey() const;

signals:
    void chosen(bolster::ElementId element);
    void findingChosen(const bolster::CoverFinding& finding);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void fill();
    QListWidgetItem* addRow(const QIcon& sign, const QString& text, const std::string& key);
    void choose(const QListWidgetItem& item);
    QString textOf(const Problem& problem) const;

    const ProblemSet& m_problems;
    const Document& m_document;
    std::vector<CoverFinding> m_findings;
    bool m_findingsKnown = false;
};

} // namespace bolster
