#include "Templates.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace bolster {

namespace {

struct Templates {
    Q_DECLARE_TR_FUNCTIONS(Templates)
};

/// In the order in which they are shown.
QList<std::pair<QString, QString>> templateTitles()
{
    return {{QStringLiteral("cushion"), Templates::tr("Cushion")},
            {QStringLiteral("bolster"), Templates::tr("Bolster")},
            {QStringLiteral("bench"), Templates::tr("Bench")},
            {QStringLiteral("dining-chair"), Templates::tr("Dining chair")},
            {QStringLiteral("wing-chair"), Templates::tr("Wing chair")},
            {QStringLiteral("car-seat"), Templates::tr("Car seat")},
            {QStringLiteral("headrest"), Templates::tr("Headrest")}};
}

} // namespace

QString templatesFolder()
{
    return shippedFolder("templates");
}

QString templateTitle(const QString& path)
{
    const QString name = QFileInfo(path).completeBaseName();
    for (const auto& [known, title] : templateTitles())
        if (known == name)
            return title;
    return name;
}

QList<Sample> templates(const QString& folder)
{
    if (folder.isEmpty())
        return {};
    const auto titles = templateTitles();
    QList<std::pair<qsizetype, Sample>> placed;
    for (const QFileInfo& file : QDir(folder).entryInfoList({QStringLiteral("*.json"), QStringLiteral("*.bolster")},
                                                            QDir::Files, QDir::Name)) {
        const QString name = file.completeBaseName();
        const auto known = std::ranges::find(titles, name, &std::pair<QString, QString>::first);
        placed.append(
            {known - titles.begin(), {file.filePath(), known == titles.end() ? name : known->second, {}}});
    }
    std::ranges::stable_sort(placed, {}, &std::pair<qsizetype, Sample>::first);
    QList<Sample> found;
    for (const auto& [place, one] : placed)
        found.append(one);
    return found;
}

QString pictureBeside(const QString& design)
{
    const QFileInfo file(design);
    return QDir(file.path()).filePath(file.completeBaseName() + QStringLiteral(".png"));
}

} // namespace bolster
