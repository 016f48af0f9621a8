// The list of edits: a click jumps to the design as it was then, a double click or F2 names that version, Shift+F2
// its branch.
#pragma once

#include <QListView>

#include <cstdint>

namespace bolster {

using NodeId = std::int32_t;
class Document;
class HistoryModel;
class PictureTip;

class HistoryView : public QListView {
    Q_OBJECT

public:
    explicit HistoryView(Document& document, QWidget* parent = nullptr);

    /// Shows only what has these words in its text or name; everything when there are none.
    void setFilter(const QString& words);
    HistoryModel& history() { return *m_model; }
    /// Asks for the name of the branch that a version is on, in its first line. Does nothing where the history has
    /// not forked yet.
    void nameBranchOf(NodeId node);

signals:
    /// With the present one.
    void compareWanted(bolster::NodeId node);

protected:
    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void showCurrent();
    void applyFilter(int first, int last);

    Document& m_document;
    HistoryModel* m_model;
    PictureTip* m_tip;
    QStringList m_filter;
    NodeId m_shown = -1; ///< the present version that was last shown
};

} // namespace bolster
