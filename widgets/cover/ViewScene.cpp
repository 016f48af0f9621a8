#include "ViewScene.h"

namespace bolster {

QColor ViewScene::PointsLook::colorOf(std::size_t point) const
{
    if (!own)
        return color;
    QColor shade = QColor::fromRgb((*own)[point]);
    shade.setAlphaF(color.alphaF());
    return shade;
}

ViewScene::ViewScene()
{
    setColors({});
}

void ViewScene::setColors(const ViewColors& of)
{
    colors = of;
    backgroundTop = of.dark ? "#434850" : "#d8dde3";
    backgroundBottom = of.dark ? "#26292e" : "#f6f7f8";
}

QColor ViewScene::veil() const
{
    return mixed(colorOf(backgroundTop), colorOf(backgroundBottom), 0.5);
}

QColor colorOf(const std::string& written)
{
    return QColor(QString::fromStdString(written));
}

} // namespace bolster
