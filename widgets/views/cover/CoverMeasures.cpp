#include "CoverMeasures.h"

#include "Document.h"
#include "MeasurePicture.h"
#include "Selection.h"
#include "ShownScene.h"
#include "Units.h"

#include <QPainter>

#include <algorithm>

namespace bolster {

CoverMeasures::CoverMeasures(const Document& document, const Selection& selection, ShownScene& shown,
                             const Camera& camera, QWidget* view)
    : QWidget(view)
    , m_document(document)
    , m_selection(selection)
    , m_shown(shown)
    , m_camera(camera)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    hide();
    connect(&document, &Document::changed, this, &CoverMeasures::refresh);
    connect(&selection, &Selection::changed, this, &CoverMeasures::refresh);
    connect(&selection, &Selection::hoverChanged, this, &CoverMeasures::refresh);
    connect(&shown, &ShownScene::changed, this, &CoverMeasures::refresh);
    connect(&NumberStyles::instance(), &NumberStyles::changed, this, &CoverMeasures::refresh);
    connect(&document, &Document::changed, this, &CoverMeasures::measure);
    connect(&shown, &ShownScene::rested, this, &CoverMeasures::measure);
}

void CoverMeasures::setWanted(bool wanted)
{
    m_wanted = wanted;
    refresh();
}

void CoverMeasures::refresh()
{
    const bool any = m_wanted && m_shown.surface() && m_document.design().count<Measurement>() > 0;
    if (any && size() != parentWidget()->size())
        resize(parentWidget()->size());
    setVisible(any);
    update();
}

std::optional<CoverMeasures::Ends> CoverMeasures::endsOf(const Measurement& measured) const
{
    const std::optional<Vec3> from = m_shown.onCover({measured.from.patch, measured.from.position});
    const std::optional<Vec3> to = m_shown.onCover({measured.to.patch, measured.to.position});
    return from && to ? std::optional(Ends{*from, *to}) : std::nullopt;
}

void CoverMeasures::measure()
{
    std::map<ElementId, double> lengths;
    m_document.design().each<Measurement>([&](ElementId id, const Measurement& measured) {
        if (const std::optional<Ends> ends = endsOf(measured))
            lengths.emplace(id, ends->length());
    });
    emit measured(lengths);
}

std::vector<CoverMeasures::Seen> CoverMeasures::seen() const
{
    std::vector<Seen> found;
    const std::optional<SectionPlane>& section = m_shown.scene().section;
    m_document.design().each<Measurement>([&](ElementId id, const Measurement& measured) {
        const std::optional<Ends> ends = endsOf(measured);
        if (!ends || (section && !(section->keeps(ends->from) && section->keeps(ends->to))))
            return;
        if (const std::optional<Vec2> a = m_camera.pixel(ends->from), b = m_camera.pixel(ends->to); a && b)
            found.push_back({id, {a->x(), a->y(), b->x(), b->y()}, ends->length()});
    });
    return found;
}

ElementId CoverMeasures::at(QPointF pixel) const
{
    constexpr double reach = 5; // pixels
    if (!isVisible())
        return noElement;
    for (const Seen& measure : seen()) {
        const QPointF way = measure.line.p2() - measure.line.p1(), to = pixel - measure.line.p1();
        const double square = QPointF::dotProduct(way, way);
        const double share = square > 0 ? std::clamp(QPointF::dotProduct(to, way) / square, 0.0, 1.0) : 0;
        if (QLineF(measure.line.p1() + share * way, pixel).length() <= reach)
            return measure.id;
    }
    return noElement;
}

void CoverMeasures::paintEvent(QPaintEvent*)
{
    const ViewColors& colors = m_shown.scene().colors;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Seen& measure : seen()) {
        const bool selected = m_selection.contains(measure.id), hovered = m_selection.hovered() == measure.id;
        const QColor color = selected ? colors.accent : hovered ? colors.hover : colors.label;
        paintMeasure(painter,
                     {measure.line.p1(), measure.line.p2(), lengthText(measure.length, 1), selected || hovered},
                     color, colors.canvas);
    }
}

} // namespace bolster
