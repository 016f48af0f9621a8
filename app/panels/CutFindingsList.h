// What to look at before a pattern is cut, the worst first.
#pragma once

#include "CutCheck.h"

#include <QListWidget>

namespace bolster {

class CutFindingsList : public QListWidget {
    Q_OBJECT

public:
    explicit CutFindingsList(QWidget* parent = nullptr);

    /// Of this design. Who has chosen one of them still has it if it is there.
    void setFindings(const Design& design, std::vector<CutFinding> findings);
    const std::vector<CutFinding>& findings() const { return m_findings; }

signals:
    /// By a double click or Enter.
    void chosen(const bolster::CutFinding& finding);

private:
    std::vector<CutFinding> m_findings;
};

} // namespace bolster
