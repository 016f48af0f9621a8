// The curves of the design, to tick those along which a form is cut.
#pragma once

#include "Form.h"

#include <QTreeWidget>

#include <map>
#include <vector>

namespace bolster {

class SeamLineList : public QTreeWidget {
    Q_OBJECT

public:
    explicit SeamLineList(QWidget* parent = nullptr);

    /// Curves that are new are ticked, others stay as they are. What holds a cover already is beside them, closed
    /// up: that may be much.
    void fill(const Design& design);
    /// All as they are at first, or none.
    void tick(const Design& design, bool ticked);

    using States = std::map<quint32, Qt::CheckState>; ///< by the numbers of the curves
    States states() const;
    void setStates(const States& states);

    std::vector<ElementId> tickedCurves() const;
    std::vector<FormLine> ticked(const Design& design) const;

signals:
    void ticksChanged();

private:
    std::vector<QTreeWidgetItem*> items() const;
};

} // namespace bolster
