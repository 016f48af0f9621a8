// The parts of a file as a tree: those that are wanted are checked.
#pragma once

#include "Assembly.h"

#include <QTreeWidget>

namespace bolster {

class PartsTree : public QTreeWidget {
    Q_OBJECT

public:
    /// Those whose names are `unwanted` are not checked. Parts without any triangles below them are left out.
    PartsTree(const std::vector<PartOutline>& parts, const std::vector<std::string>& unwanted,
              QWidget* parent = nullptr);

    /// Names of the parts with triangles that are not checked.
    std::vector<std::string> unwanted() const;

signals:
    void changed();

private:
    std::vector<std::pair<QTreeWidgetItem*, std::string>> m_items; // of parts with triangles
};

} // namespace bolster
