// The list of the places where the cover suffers most.
#pragma once

#include "MapLink.h"

#include <QWidget>

class QAction;
class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace bolster {

class Commands;

/// Follows the map while the cover changes. Without a map of strain it says how to get one.
class SpotsPanel : public QWidget {
    Q_OBJECT

public:
    enum Column { Where, Value, Limit, ColumnCount };

    SpotsPanel(const MapLink& maps, Commands& commands, QWidget* parent = nullptr);

    /// A row for each of MapLink::spots().
    QTreeWidget& table() { return *m_table; }
    /// Room for all rows, even while there are none.
    QSize sizeHint() const override;

signals:
    /// By a click, by Enter or by walking through the list.
    void chosen(const bolster::CoverPoint& place);

protected:
    void changeEvent(QEvent* event) override;

private:
    void buildHint(QAction& strain);
    void buildTable();
    void fill();
    void fillTable();
    void fillRow(QTreeWidgetItem& row, const MapLink::Spot& spot);
    void reselect();
    void showPage(QWidget& page);
    void choose(QTreeWidgetItem& row);

    const MapLink& m_maps;
    QWidget* m_list;
    QLabel* m_title;
    QLabel* m_summary;
    QTreeWidget* m_table;
    QWidget* m_hint;
    QLabel* m_advice;
    QPushButton* m_offer;               ///< switches a map of strain on
    std::optional<CoverPoint> m_chosen; ///< where the selected spot was last
    std::optional<CoverMap::Kind> m_of; ///< the map whose spots are listed
};

} // namespace bolster
