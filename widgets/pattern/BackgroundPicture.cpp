#include "BackgroundPicture.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QImageReader>
#include <QPainter>

#include <algorithm>

namespace bolster {

namespace {

constexpr int mostPicturePixels = 4096; // along a side; larger pictures are read smaller
constexpr double share = 0.8;           // of the place that the picture gets

} // namespace

Box2 BackgroundPicture::box() const
{
    const Vec2 size(image.width() * pixelSize, image.height() * pixelSize);
    return {Vec2(corner.x(), corner.y() - size.y()), Vec2(corner.x() + size.x(), corner.y())};
}

BackgroundPicture BackgroundPicture::scaled(double factor, const Vec2& about) const
{
    BackgroundPicture result = *this;
    result.pixelSize *= factor;
    result.corner = about + factor * (corner - about);
    return result;
}

BackgroundPicture BackgroundPicture::moved(const Vec2& delta) const
{
    BackgroundPicture result = *this;
    result.corner += delta;
    return result;
}

BackgroundPicture readBackground(const QString& path, const Box2& into, QString* problem)
{
    if (const QFileInfo file(path); file.exists() && !file.isFile()) { // reading a pipe would wait for its writer
        if (problem)
            *problem = QCoreApplication::translate("BackgroundPicture", "\"%1\" is not an ordinary file.")
                           .arg(file.fileName());
        return {};
    }
    QImageReader reader(path);
    reader.setAutoTransform(true);
    if (const QSize size = reader.size(); std::max(size.width(), size.height()) > mostPicturePixels)
        reader.setScaledSize(size.scaled(mostPicturePixels, mostPicturePixels, Qt::KeepAspectRatio));
    BackgroundPicture picture;
    picture.image = reader.read();
    if (picture.empty()) {
        if (problem)
            *problem = QCoreApplication::translate("BackgroundPicture", "%1 cannot be read as a picture: %2")
                           .arg(QFileInfo(path).fileName(), reader.errorString());
        return {};
    }
    picture.path = path;
    const Vec2 room = into.isEmpty() ? Vec2(1000, 1000) : Vec2(share * into.sizes());
    const Vec2 centre = into.isEmpty() ? Vec2(0, 0) : Vec2(into.center());
    picture.pixelSize = std::min(room.x() / picture.image.width(), room.y() / picture.image.height());
    const Vec2 size(picture.image.width() * picture.pixelSize, picture.image.height() * picture.pixelSize);
    picture.corner = centre + Vec2(-size.x(), size.y()) / 2;
    return picture;
}

void paintBackground(QPainter& painter, const BackgroundPicture& picture, const PatternTransform& transform,
                     bool dark)
{
    if (picture.empty() || !picture.shown)
        return;
    const Box2 box = picture.box();
    painter.save();
    painter.setOpacity(picture.opacity);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!dark)
        painter.setCompositionMode(QPainter::CompositionMode_Multiply);
    painter.drawImage(QRectF(transform.toPixels(box.min()), transform.toPixels(box.max())).normalized(),
                      picture.image);
    painter.restore();
}

} // namespace bolster
