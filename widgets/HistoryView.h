// The list of edits: a click jumps to the design as it was then.
#pragma once

#include <QListView>

namespace bolster {

class Document;
class HistoryModel;

class HistoryView : public QListView {
    Q_OBJECT

public:
    explicit HistoryView(Document& document, QWidget* parent = nullptr);

private:
    void showCurrent();

    Document& m_document;
    HistoryModel* m_model;
};

} // namespace bolster
