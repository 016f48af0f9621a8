// For people: what a test sees is kept as a picture when BOLSTER_PICTURES names a folder.
#pragma once

#include <QDir>
#include <QWidget>

namespace bolster {

inline void keepPicture(QWidget& widget, const QString& name)
{
    const QString folder = qEnvironmentVariable("BOLSTER_PICTURES");
    if (!folder.isEmpty())
        widget.grab().save(QDir(folder).filePath(name + QStringLiteral(".png")));
}

} // namespace bolster
