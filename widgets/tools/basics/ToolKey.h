// What a tool can do now by a key. The menu of the right button offers the same.
#pragma once

#include <QList>
#include <QString>

namespace bolster {

struct ToolKey {
    Qt::Key key;
    QString text; ///< with a mnemonic
};

using ToolKeys = QList<ToolKey>;

} // namespace bolster
