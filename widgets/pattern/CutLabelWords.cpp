#include "CutLabelWords.h"

#include <QCoreApplication>

namespace bolster {

CutWords cutLabelWords()
{
    return {QCoreApplication::translate("CutLabelWords", "Cut %1").toStdString(),
            QCoreApplication::translate("CutLabelWords", "Cut %1 and %1 mirrored").toStdString()};
}

} // namespace bolster
