#include "SeamProposalsWindow.h"

#include "ElementText.h"
#include "Units.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace bolster {

namespace {

constexpr double likelyFrom = 0.5;

} // namespace

SeamProposalsWindow::SeamProposalsWindow(Document& document, Selection& selection, QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_selection(selection)
    , m_job(
          [](const Wanted& wanted, const std::stop_token& stop) {
              return Found{wanted.number, proposeSeams(wanted.design, stop)};
          },
          [this](const Found& found) {
              if (found.number == m_asked)
                  showProposals(found.proposals);
          })
{
    setWindowTitle(tr("Proposed seams"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connect(&m_document, &Document::historyChanged, this, &SeamProposalsWindow::look);
    look();
}

void SeamProposalsWindow::build()
{
    m_list = new QTreeWidget(this);
    m_list->setRootIsDecorated(false);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setUniformRowHeights(true);
    m_list->setHeaderLabels({tr("Edge of"), tr("to edge of"), tr("Lengths"), tr("Certainty")});
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_list->setAccessibleName(tr("Proposed seams"));
    m_list->setToolTip(tr("Select rows to see their edges in the pattern; Enter or a double click sews them."));
    m_hint = new QLabel(this);
    m_hint->setWordWrap(true);
    m_hint->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_hint->setMinimumHeight(2 * m_hint->fontMetrics().lineSpacing()); // rows stay where they are while it searches
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_sew = buttons->addButton(tr("&Sew selected"), QDialogButtonBox::ActionRole);
    m_sewLikely = buttons->addButton(tr("Sew &likely ones"), QDialogButtonBox::ActionRole);
    m_sewLikely->setToolTip(tr("Those of 50 % and more. What is sewn tells where its neighbours belong."));
    m_sewAll = buttons->addButton(tr("Sew &all"), QDialogButtonBox::ActionRole);
    m_sew->setDefault(true);
    connect(m_sew, &QPushButton::clicked, this, &SeamProposalsWindow::sewSelected);
    connect(m_sewLikely, &QPushButton::clicked, this, [this] { sew(likely()); });
    connect(m_sewAll, &QPushButton::clicked, this, [this] { sew(m_proposals); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(m_list, &QTreeWidget::itemSelectionChanged, this, &SeamProposalsWindow::selectEdges);
    connect(m_list, &QTreeWidget::itemActivated, this, &SeamProposalsWindow::sewSelected);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_hint);
    layout->addWidget(m_list, 1);
    layout->addWidget(buttons);
    resize(640, 460);
    // Over the cover: the pattern is what one wants to see.
    if (const QWidget* window = parentWidget())
        move(window->geometry().right() - width() - 24, window->geometry().top() + 140);
}

void SeamProposalsWindow::look()
{
    m_sew->setEnabled(false);
    m_sewLikely->setEnabled(false);
    m_sewAll->setEnabled(false);
    m_hint->setText(tr("Looking for edges that belong together \u2026"));
    m_job.request({++m_asked, m_document.design()}, true);
}

/// Where one stands in a list that is made again: at the same proposal, or in the same place when that has been
/// sewn.
int SeamProposalsWindow::rowAfter(const std::vector<SeamProposal>& proposals) const
{
    const int row = std::max(m_list->indexOfTopLevelItem(m_list->currentItem()), 0);
    if (row < std::ssize(m_proposals)) {
        const SeamProposal& here = m_proposals[static_cast<std::size_t>(row)];
        const auto same = std::ranges::find_if(
            proposals, [&](const SeamProposal& other) { return other.a == here.a && other.b == here.b; });
        if (same != proposals.end())
            return static_cast<int>(same - proposals.begin());
    }
    return std::min(row, static_cast<int>(std::ssize(proposals)) - 1);
}

void SeamProposalsWindow::showProposals(const std::vector<SeamProposal>& proposals)
{
    const int row = rowAfter(proposals);
    m_proposals = proposals;
    m_list->clear();
    const Design& design = m_document.design();
    for (const SeamProposal& proposal : proposals)
        new QTreeWidgetItem(m_list,
                            {displayName(design, proposal.a.patch), displayName(design, proposal.b.patch),
                             tr("%1 and %2").arg(lengthText(proposal.lengthA, 0), lengthText(proposal.lengthB, 0)),
                             tr("%1 %").arg(QLocale().toString(qRound(100 * proposal.certainty)))});
    m_hint->setText(
        proposals.empty()
            ? tr("There are no free edges that seem to belong together.")
            : tr("Found by their lengths, corners that would close, names and directions; the most certain "
                 "first. Look at each in the pattern before you sew it."));
    m_sewLikely->setEnabled(!likely().empty());
    m_sewAll->setEnabled(!proposals.empty());
    if (m_list->topLevelItemCount() > 0)
        m_list->setCurrentItem(m_list->topLevelItem(row));
}

std::vector<SeamProposal> SeamProposalsWindow::likely() const
{
    std::vector<SeamProposal> found;
    std::ranges::copy_if(m_proposals, std::back_inserter(found),
                         [](const SeamProposal& proposal) { return proposal.certainty >= likelyFrom; });
    return found;
}

std::vector<SeamProposal> SeamProposalsWindow::selected() const
{
    std::vector<SeamProposal> found;
    for (int row = 0; row < m_list->topLevelItemCount(); ++row)
        if (m_list->topLevelItem(row)->isSelected())
            found.push_back(m_proposals[static_cast<std::size_t>(row)]);
    return found;
}

void SeamProposalsWindow::selectEdges()
{
    const std::vector<SeamProposal> rows = selected();
    m_sew->setEnabled(!rows.empty());
    Selection::Edges edges;
    for (const SeamProposal& row : rows)
        for (const Stretch& stretch : {row.a, row.b})
            edges.push_back({stretch.patch, stretch});
    m_selection.set({}, {}, std::move(edges));
    if (!rows.empty())
        emit edgesSelected();
}

void SeamProposalsWindow::sewSelected()
{
    sew(selected());
}

void SeamProposalsWindow::sew(const std::vector<SeamProposal>& proposals)
{
    m_document.cancelGesture();
    if (const Edit edit = sewProposals(m_document.design(), proposals); !edit.empty())
        m_document.commit(edit);
}

} // namespace bolster
