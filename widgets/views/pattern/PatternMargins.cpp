#include "PatternMargins.h"

#include "MapLegend.h"
#include "PatternGrid.h"
#include "PatternNavigation.h"
#include "PatternRulers.h"
#include "PatternScene.h"

namespace bolster {

PatternMargins::PatternMargins(const PatternScene& scene, PatternNavigation& navigation, DrawingAids& aids,
                               QWidget& view)
    : m_scene(scene)
    , m_navigation(navigation)
    , m_view(view)
    , m_rulers{new PatternRuler(navigation, aids, Qt::Horizontal, view),
               new PatternRuler(navigation, aids, Qt::Vertical, view)}
    , m_legend(new MapLegend(&view))
{
    for (const PatternRuler* ruler : m_rulers)
        connect(ruler, &PatternRuler::pointerMoved, this, &PatternMargins::pointerMoved);
    connect(&navigation, &PatternNavigation::fitted, this, &PatternMargins::makeRoom);
}

void PatternMargins::setRulersShown(bool shown)
{
    for (PatternRuler* ruler : m_rulers)
        ruler->setVisible(shown);
    emit freeRoomChanged();
}

QRect PatternMargins::freeRoom() const
{
    const int ruler = m_rulers.front()->isHidden() ? 0 : PatternRuler::thickness;
    return m_view.rect().adjusted(ruler, ruler, 0, -scaleBarRoom);
}

void PatternMargins::setMap(const ShownMapPtr& map)
{
    m_map = map;
    showLegend();
}

void PatternMargins::setLegendShown(bool shown)
{
    m_legendShown = shown;
    showLegend();
}

void PatternMargins::setMapReading(const QString& reading)
{
    m_legend->setReading(reading);
}

void PatternMargins::showLegend()
{
    m_legend->setMap(m_legendShown ? m_map : nullptr);
    placeLegend();
    m_navigation.fitAgain();
    m_view.update();
}

/// The legend gets a strip of its own where it would cover patches.
void PatternMargins::makeRoom()
{
    if (m_legend->isHidden() || placeLegend())
        return;
    const int strip = m_legend->height();
    if (m_view.height() < 3 * strip)
        return;
    m_navigation.fitAbove(strip);
    placeLegend();
}

bool PatternMargins::placeLegend()
{
    return m_legend->place(busyPlaces());
}

/// Where the legend would cover something: rulers, the scale bar, patches. Pixels.
std::vector<QRectF> PatternMargins::busyPlaces() const
{
    const PatternTransform& transform = m_navigation.transform();
    std::vector<QRectF> places{scaleBarPlace(transform, m_view.size())};
    for (const PatternRuler* ruler : m_rulers)
        if (!ruler->isHidden())
            places.push_back(ruler->geometry());
    for (const auto& [id, patch] : m_scene.patches())
        places.push_back(
            QRectF(transform.toPixels(patch.box.min()), transform.toPixels(patch.box.max())).normalized());
    return places;
}

void PatternMargins::place()
{
    for (PatternRuler* ruler : m_rulers)
        ruler->place();
    placeLegend();
}

void PatternMargins::update()
{
    for (PatternRuler* ruler : m_rulers)
        ruler->update();
}

void PatternMargins::showPointer(const std::optional<Vec2>& layout)
{
    for (PatternRuler* ruler : m_rulers)
        ruler->showPointer(layout);
}

} // namespace bolster
