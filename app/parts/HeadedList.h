// A list with columns.
#pragma once

#include <QTreeWidget>

namespace bolster {

/// At least as wide as the heads of its columns, which are as wide as what is in them; one has what is left.
class HeadedList : public QTreeWidget {
    Q_OBJECT

public:
    HeadedList(const QStringList& heads, int widest, QWidget* parent);

    QSize minimumSizeHint() const override;
};

} // namespace bolster
