#include "FeelRecorder.h"

#include "CoverView.h"
#include "Document.h"
#include "PatternView.h"

#include <cmath>

namespace bolster {

namespace {

const QString pattern = QStringLiteral("pattern");
const QString cover = QStringLiteral("cover");
constexpr int dragSteps = 20;

template <class T>
std::vector<ElementId> idsOf(const Design& design)
{
    std::vector<ElementId> ids;
    design.each<T>([&](ElementId id, const T&) { ids.push_back(id); });
    return ids;
}

} // namespace

QWidget& FeelRecorder::view(const QString& widget) const
{
    if (widget == cover)
        return m_window.coverView();
    return m_window.patternView();
}

QPointF FeelRecorder::way(int most)
{
    const double angle = below(360) * M_PI / 180;
    const double length = 8 + below(most);
    return {length * std::cos(angle), length * std::sin(angle)};
}

void FeelRecorder::add(FeelEvent event)
{
    m_player.play(event);
    m_script.push_back(std::move(event));
}

void FeelRecorder::begin(const char* kind)
{
    FeelEvent event;
    event.text = QString::fromLatin1(kind);
    add(event);
}

void FeelRecorder::pointer(FeelEvent::Kind kind, const QString& widget, QPointF pixel, Qt::MouseButton button)
{
    FeelEvent event;
    event.kind = kind;
    event.widget = widget;
    // The middle of the pixel: what is rounded in the text stays in it.
    const QWidget& target = view(widget);
    event.at = {(std::floor(pixel.x()) + 0.5) / target.width(), (std::floor(pixel.y()) + 0.5) / target.height()};
    event.button = button;
    add(event);
}

void FeelRecorder::wheel(const QString& widget, QPointF pixel, double steps)
{
    FeelEvent event;
    event.kind = FeelEvent::Kind::Wheel;
    event.widget = widget;
    event.at = {pixel.x() / view(widget).width(), pixel.y() / view(widget).height()};
    event.steps = steps;
    add(event);
}

void FeelRecorder::key(const QString& widget, const QString& keys)
{
    FeelEvent event;
    event.kind = FeelEvent::Kind::Key;
    event.widget = widget;
    event.text = keys;
    add(event);
}

void FeelRecorder::click(const QString& widget, QPointF pixel)
{
    pointer(FeelEvent::Kind::Move, widget, pixel);
    pointer(FeelEvent::Kind::Press, widget, pixel);
    pointer(FeelEvent::Kind::Release, widget, pixel);
}

void FeelRecorder::drag(const QString& widget, QPointF from, QPointF by, Qt::MouseButton button)
{
    const QPointF across(-by.y() * 0.2, by.x() * 0.2);
    pointer(FeelEvent::Kind::Move, widget, from, button);
    pointer(FeelEvent::Kind::Press, widget, from, button);
    for (int step = 1; step <= dragSteps; ++step) {
        const double share = static_cast<double>(step) / dragSteps;
        pointer(FeelEvent::Kind::Move, widget, from + by * share + across * std::sin(share * M_PI), button);
    }
    if (button == Qt::LeftButton && below(12) == 0)
        key(widget, QStringLiteral("Esc"));
    pointer(FeelEvent::Kind::Release, widget, from + by, button);
}

bool FeelRecorder::dragPatch()
{
    key(pattern, QStringLiteral("Home"));
    const Design& design = m_window.document().design();
    const std::vector<ElementId> patches = idsOf<Patch>(design);
    const ElementId id = patches[static_cast<std::size_t>(below(static_cast<int>(patches.size())))];
    const Patch& patch = *design.find<Patch>(id);
    PatternView& view = m_window.patternView();
    const Vec2 middle = patch.outline.boundingBox().center();
    const QPointF at = view.navigation().transform().toPixels(toLayout(patch, middle));
    if (view.hit(at).element() != id)
        return false;
    begin("patch");
    drag(pattern, at, way(40));
    return true;
}

/// Chooses a patch by a click, fills the view with it and drags one of its points.
bool FeelRecorder::dragOutline()
{
    key(pattern, QStringLiteral("Home"));
    PatternView& view = m_window.patternView();
    const Design& design = m_window.document().design();
    const std::vector<ElementId> patches = idsOf<Patch>(design);
    const ElementId id = patches[static_cast<std::size_t>(below(static_cast<int>(patches.size())))];
    const Patch patch = *design.find<Patch>(id);
    const Vec2 middle = patch.outline.boundingBox().center();
    const QPointF inside = view.navigation().transform().toPixels(toLayout(patch, middle));
    if (view.hit(inside).element() != id)
        return false;
    click(pattern, inside);
    key(pattern, QStringLiteral("F"));
    const int count = patch.outline.pointCount();
    const int first = below(count);
    for (int i = 0; i < count; ++i) {
        const int point = (first + i) % count;
        const QPointF at = view.navigation().transform().toPixels(
            toLayout(patch, patch.outline.points()[static_cast<std::size_t>(point)]));
        const PatternHit hit = view.hit(at);
        if (!view.rect().adjusted(60, 60, -60, -60).contains(at.toPoint()) || hit.kind != PatternHit::Kind::Point ||
            hit.patch != id)
            continue;
        begin("outline");
        drag(pattern, at, way(16));
        return true;
    }
    return false;
}

/// Chooses a fixation curve by a click on it and drags one of its points.
bool FeelRecorder::dragFixation()
{
    CoverView& view = m_window.coverView();
    const Design& design = m_window.document().design();
    const std::vector<ElementId> curves = idsOf<FixationCurve>(design);
    const int first = below(static_cast<int>(curves.size()));
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const ElementId id = curves[(static_cast<std::size_t>(first) + c) % curves.size()];
        const BSpline3 curve = design.find<FixationCurve>(id)->curve;
        for (int i = 0; i < 40; ++i) {
            const double t = curve.domainStart() + (curve.domainEnd() - curve.domainStart()) * (i + 0.5) / 40;
            const auto on = view.navigation().camera().pixel(curve.at(t));
            const QPointF at = on ? QPointF(on->x(), on->y()) : QPointF(-1, -1);
            if (!view.rect().adjusted(30, 30, -30, -30).contains(at.toPoint()) || view.hit(at).element != id)
                continue;
            click(cover, at);
            break;
        }
        for (const Vec3& point : curve.points()) {
            const auto on = view.navigation().camera().pixel(point);
            const QPointF at = on ? QPointF(on->x(), on->y()) : QPointF(-1, -1);
            if (!view.rect().adjusted(60, 60, -60, -60).contains(at.toPoint()))
                continue;
            const CoverHit hit = view.hit(at);
            if (hit.kind != CoverHit::Kind::Point || hit.element != id)
                continue;
            begin("fixation");
            drag(cover, at, way(14));
            return true;
        }
    }
    return false;
}

void FeelRecorder::orbit()
{
    begin("orbit");
    drag(cover, QRectF(view(cover).rect()).center(), way(160), Qt::MiddleButton);
}

void FeelRecorder::zoom()
{
    begin("zoom");
    const QString widget = below(2) ? pattern : cover;
    const QPointF at = QRectF(view(widget).rect()).center() + way(60);
    const double steps = below(2) ? 0.5 : -0.5;
    for (int i = 0; i < 8; ++i)
        wheel(widget, at, i < 4 ? steps : -steps);
}

void FeelRecorder::undo()
{
    begin("undo");
    const int steps = 1 + below(3);
    for (int i = 0; i < steps; ++i)
        key(pattern, QStringLiteral("Ctrl+Z"));
    for (int i = below(steps + 1); i > 0; --i)
        key(pattern, QStringLiteral("Ctrl+Shift+Z"));
}

void FeelRecorder::makeGestures(int count)
{
    for (int made = 0; made < count;) {
        const int choice = below(100);
        bool done = true;
        if (choice < 28)
            done = dragOutline();
        else if (choice < 56)
            done = dragFixation();
        else if (choice < 68)
            done = dragPatch();
        else if (choice < 80)
            orbit();
        else if (choice < 90)
            zoom();
        else
            undo();
        if (done)
            ++made;
        else
            key(cover, QStringLiteral("0")); // another look
    }
    m_player.finishGesture();
}

} // namespace bolster
