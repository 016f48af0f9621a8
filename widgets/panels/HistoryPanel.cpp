#include "HistoryPanel.h"

#include "HistoryView.h"
#include "Icons.h"

#include <QLineEdit>
#include <QVBoxLayout>

namespace bolster {

HistoryPanel::HistoryPanel(Document& document, QWidget* parent)
    : QWidget(parent)
    , m_search(new QLineEdit(this))
    , m_view(new HistoryView(document, this))
{
    m_search->setPlaceholderText(tr("Find a change or a version"));
    m_search->setAccessibleName(m_search->placeholderText());
    m_view->setAccessibleName(tr("History"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    connect(m_search, &QLineEdit::textChanged, m_view, &HistoryView::setFilter);
    setFocusProxy(m_view);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    auto* top = new QVBoxLayout;
    top->setContentsMargins(6, 6, 6, 6);
    top->addWidget(m_search);
    layout->addLayout(top);
    layout->addWidget(m_view);
}

} // namespace bolster
