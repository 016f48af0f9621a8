#include "CoverMeasures.h"

#include "Document.h"
#include "MeasurePicture.h"
#include "Selection.h"
#include "ShownScene.h"
#include "Units.h"

#include <QPainter>

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

void CoverMeasures::paintEvent(QPaintEvent*)
{
    const ViewColors& colors = m_shown.scene().colors;
    const std::optional<SectionPlane>& section = m_shown.scene().section;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    m_document.design().each<Measurement>([&](ElementId id, const Measurement& measured) {
        const auto from = m_shown.onCover({measured.from.patch, measured.from.position});
        const auto to = m_shown.onCover({measured.to.patch, measured.to.position});
        if (!from || !to || (section && !(section->keeps(*from) && section->keeps(*to))))
            return;
        const std::optional<Vec2> a = m_camera.pixel(*from), b = m_camera.pixel(*to);
        if (!a || !b)
            return;
        const bool selected = m_selection.contains(id), hovered = m_selection.hovered() == id;
        const QColor color = selected ? colors.accent : hovered ? colors.hover : colors.label;
        paintMeasure(painter,
                     {{a->x(), a->y()}, {b->x(), b->y()}, lengthText((*to - *from).norm(), 1), selected || hovered},
                     color, colors.canvas);
    });
}

} // namespace bolster
