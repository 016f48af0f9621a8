// The history with a field to find something in it.
#pragma once

#include <QWidget>

class QLineEdit;

namespace bolster {

class Document;
class HistoryView;

class HistoryPanel : public QWidget {
    Q_OBJECT

public:
    explicit HistoryPanel(Document& document, QWidget* parent = nullptr);

    HistoryView& view() { return *m_view; }
    QLineEdit& search() { return *m_search; }

private:
    QLineEdit* m_search;
    HistoryView* m_view;
};

} // namespace bolster
