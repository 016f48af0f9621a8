// The check before cutting beside the pattern: up to date while it is seen.
#pragma once

#include "CutFindingsList.h"
#include "LatestJob.h"

namespace bolster {

class Document;

class CuttingPanel : public CutFindingsList {
    Q_OBJECT

public:
    /// The document must outlive it.
    explicit CuttingPanel(const Document& document, QWidget* parent = nullptr);

    /// The list is that of the present design.
    bool known() const { return m_known; }

protected:
    void showEvent(QShowEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    struct Result {
        Design design;
        std::vector<CutFinding> findings;
        bool nothing = true; ///< there are no pieces
    };

    void look();

    const Document& m_document;
    bool m_known = false;
    bool m_nothing = false;
    LatestJob<Design, Result> m_job; ///< last: it uses the others
};

} // namespace bolster
