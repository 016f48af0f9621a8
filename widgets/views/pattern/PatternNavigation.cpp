#include "PatternNavigation.h"

#include "CurvePath.h"
#include "PatternScene.h"
#include "Selection.h"
#include "StretchLength.h"

#include <QWidget>

#include <cmath>

namespace bolster {

namespace {

constexpr double fitMargin = 36; ///< pixels

} // namespace

PatternNavigation::PatternNavigation(const PatternScene& scene, const Selection& selection, const QWidget& view)
    : m_scene(scene)
    , m_selection(selection)
    , m_view(view)
{}

void PatternNavigation::setTransform(const PatternTransform& transform)
{
    m_fitted.setEmpty();
    apply(transform);
    emit transformChanged(m_transform);
}

void PatternNavigation::apply(const PatternTransform& transform)
{
    m_transform = transform;
    emit moved();
}

double PatternNavigation::closer(double notches)
{
    constexpr double wheelStep = 1.2; // as large after one notch
    return std::pow(wheelStep, notches);
}

void PatternNavigation::fitAll()
{
    fit(m_scene.boundingBox());
}

void PatternNavigation::fitSelection()
{
    const Box2 box = m_scene.boundingBox(m_selection.elements());
    fit(box.isEmpty() ? m_scene.boundingBox() : box);
}

void PatternNavigation::revealSelection()
{
    Box2 box;
    for (const Selection::Edge& edge : m_selection.edges()) {
        const PatternPatch* on = m_scene.patch(edge.stretch.patch);
        const auto range = on ? stretchRange(edge.stretch, on->patch().outline) : std::nullopt;
        if (!range)
            continue;
        const QRectF bounds = curvePath(on->patch().outline, range->first, range->second, [on](const Vec2& p) {
                                  return toLayout(on->patch(), p);
                              }).boundingRect();
        box.extend(Box2(toVec(bounds.topLeft()), toVec(bounds.bottomRight())));
    }
    if (box.isEmpty())
        box = m_scene.boundingBox(m_selection.elements());
    const QRectF seen(m_view.rect());
    if (!box.isEmpty() &&
        !(seen.contains(m_transform.toPixels(box.min())) && seen.contains(m_transform.toPixels(box.max()))))
        fitSelection();
}

void PatternNavigation::fit(const Box2& box)
{
    m_fitted = box;
    fitAbove(0);
    emit fitted();
}

void PatternNavigation::fitAgain()
{
    if (!m_fitted.isEmpty())
        fit(m_fitted);
}

void PatternNavigation::fitAbove(int strip)
{
    apply(PatternTransform::fitting(m_fitted, m_view.size() - QSize(0, strip), fitMargin));
}

void PatternNavigation::resize(QSize before)
{
    if (m_fitted.isEmpty() && before.isValid())
        m_transform = m_transform.resized(before, m_view.size());
    else
        fit(m_fitted);
}

void PatternNavigation::reveal(const Vec2& layout)
{
    const QRectF seen(m_view.rect());
    const QPointF pixel = m_transform.toPixels(layout);
    if (!seen.contains(pixel))
        setTransform(m_transform.panned(seen.center() - pixel));
}

} // namespace bolster
