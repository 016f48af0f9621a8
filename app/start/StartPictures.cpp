#include "StartPictures.h"

#include "Background.h"
#include "DesignSession.h"
#include "Project.h"
#include "Templates.h"
#include "WholeFile.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImageReader>

namespace bolster {

namespace {

constexpr QSize largestPicture(2048, 2048); // pixels; the file may come from anywhere
constexpr qint64 largestFile = 4'000'000;   // bytes

QByteArray pictureBytes(const QString& design)
{
    if (DesignSession::isProject(design))
        if (const std::string png = projectPicture(design).png; !png.empty() && std::ssize(png) <= largestFile)
            return QByteArray::fromStdString(png);
    return QByteArray::fromStdString(readWholeFile(pictureBeside(design), largestFile).bytes);
}

} // namespace

QImage StartPictures::pictureOf(const QString& design)
{
    QByteArray png = pictureBytes(design);
    if (png.isEmpty())
        return {};
    QBuffer bytes(&png);
    QImageReader reader(&bytes, "png");
    const bool sensible = reader.size().isValid() && reader.size().boundedTo(largestPicture) == reader.size();
    return sensible ? reader.read() : QImage();
}

void StartPictures::read(const QStringList& designs)
{
    readNext(designs, ++m_asked);
}

/// One job each: a disk that is asleep holds up no other work for long, and what was read is seen at once.
void StartPictures::readNext(QStringList designs, int asked)
{
    if (designs.isEmpty() || asked != m_asked)
        return;
    const QString design = designs.takeFirst();
    inBackground<Found>([design] {
        return Found{QFileInfo::exists(design), pictureOf(design)};
    }).then(this, [this, design, designs, asked](const Found& result) {
        if (asked != m_asked)
            return;
        emit found(design, result.there, result.picture);
        readNext(designs, asked);
    });
}

} // namespace bolster
