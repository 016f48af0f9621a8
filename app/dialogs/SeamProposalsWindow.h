// Seams that seem to belong together: a list beside the views, from which the user takes some or all.
#pragma once

#include "Document.h"
#include "LatestJob.h"
#include "SeamProposals.h"
#include "Selection.h"

#include <QDialog>

class QLabel;
class QPushButton;
class QTreeWidget;

namespace bolster {

class SeamProposalsWindow : public QDialog {
    Q_OBJECT

public:
    SeamProposalsWindow(Document& document, Selection& selection, QWidget* parent = nullptr);

signals:
    /// The edges of the chosen rows are selected, and shall be seen.
    void edgesSelected();

private:
    void build();
    void look();
    int rowAfter(const std::vector<SeamProposal>& proposals) const;
    void showProposals(const std::vector<SeamProposal>& proposals);
    void selectEdges();
    void sew(const std::vector<SeamProposal>& proposals);
    void sewSelected();
    std::vector<SeamProposal> likely() const;
    std::vector<SeamProposal> selected() const;

    Document& m_document;
    Selection& m_selection;
    std::vector<SeamProposal> m_proposals;
    int m_asked = 0;
    QTreeWidget* m_list = nullptr;
    QLabel* m_hint = nullptr;
    QPushButton* m_sew = nullptr;
    QPushButton* m_sewLikely = nullptr;
    QPushButton* m_sewAll = nullptr;
    struct Wanted {
        int number = 0;
        Design design;
    };
    struct Found {
        int number = 0;
        std::vector<SeamProposal> proposals;
    };
    LatestJob<Wanted, Found> m_job; ///< last: it uses the others
};

} // namespace bolster
