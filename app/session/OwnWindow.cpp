#include "OwnWindow.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QProcess>

namespace bolster {

bool openInWindowOfItsOwn(const QString& path)
{
    QStringList words;
    if (QCoreApplication::instance()->property("portable").toBool())
        words << QStringLiteral("--portable");
    if (!path.isEmpty())
        words << QFileInfo(path).absoluteFilePath();
    return QProcess::startDetached(QCoreApplication::applicationFilePath(), words);
}

} // namespace bolster
