#include "StretchEndDrag.h"

#include "ArcLength.h"
#include "DartEdits.h"
#include "Document.h"
#include "ElementText.h"
#include "SeamEase.h"
#include "SeamStretches.h"
#include "Selection.h"
#include "SnapHints.h"
#include "StretchLength.h"
#include "Units.h"
#include "ViewColors.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

// Pixels.
constexpr double endRadius = 4.5;
constexpr double handleInset = 7;
constexpr double handleReach = 7;
constexpr double endSnapReach = 8;

constexpr std::size_t mostOwners = 12; // with more selected nobody means a single end
constexpr double shortestLength = 1;   // mm: an end comes no nearer to the other one

QString text(const char* words)
{
    return QCoreApplication::translate("StretchEndDrag", words);
}

/// The stretch of a seam's side or of a fixation seam, with its patch, if both are there.
struct Place {
    Stretch stretch;
    const Patch* patch = nullptr;
    double end = 0; ///< unwrapped
};

std::optional<Place> placeOf(const Design& design, ElementId owner, edits::SeamSide side)
{
    Place place;
    if (const auto* seam = design.find<Seam>(owner))
        place.stretch = side == edits::SeamSide::A ? seam->a : seam->b;
    else if (const auto* fixation = design.find<FixationSeam>(owner); fixation && side == edits::SeamSide::A)
        place.stretch = fixation->stretch;
    else
        return std::nullopt;
    place.patch = design.find<Patch>(place.stretch.patch);
    if (!place.patch || place.patch->outline.empty() || !place.patch->outline.closed() ||
        !(stretchLength(design, place.stretch) > 0))
        return std::nullopt;
    const BSpline2& outline = place.patch->outline;
    place.end = unwrappedEnd(place.stretch.from, place.stretch.to, outline.domainStart(), outline.domainEnd());
    return place;
}

class StretchEndDrag : public PatternDrag {
public:
    StretchEndDrag(PatternToolContext& context, const PatternPointer& from, const StretchEndHandle& handle,
                   const Place& place)
        : PatternDrag(context, from)
        , m_gesture(context.document())
        , m_handle(handle)
        , m_patch(*place.patch)
        , m_length(m_patch.outline)
        , m_free(movesFrom() ? place.stretch.from : place.end)
        , m_start(toLayout(m_patch, m_patch.outline.at(m_patch.outline.wrapped(m_free))))
        , m_now(m_free)
    {
        const double other = movesFrom() ? place.end : place.stretch.from;
        const double period = m_patch.outline.period();
        const double least = std::min(shortestLength, 0.01 * m_length.total());
        const double before = m_length.parameterAt(m_length.at(other) - least);
        const double after = m_length.parameterAt(m_length.at(other) + least);
        m_low = movesFrom() ? after - period : after;
        m_high = movesFrom() ? before : before + period;
        findPlaces(other);
    }

    void update(const PatternPointer& pointer) override
    {
        const BSpline2& outline = m_patch.outline;
        const Vec2 wanted = fromLayout(m_patch, m_start + pointer.layout - m_from.layout);
        // Step by step along the outline, so that the other end stops it.
        const double period = outline.period();
        m_free += std::remainder(outline.closest(wanted).parameter - m_free, period);
        m_now = std::clamp(m_free, m_low, m_high);
        m_snap = pointer.modifiers & (Qt::ControlModifier | Qt::AltModifier) ? nullptr : placeNear(m_now);
        if (m_snap)
            m_now = m_snap->parameter;
        m_gesture.update(
            edits::dragStretchEnd(m_gesture.start(), m_handle.owner, m_handle.side, m_handle.end, m_now));
    }
    void finish() override { m_gesture.commit(); }
    bool active() const override { return m_gesture.active(); }
    Qt::CursorShape cursor() const override { return Qt::SizeAllCursor; }

    QString prompt() const override
    {
        const Design& design = m_context.document().design();
        const auto* seam = design.find<Seam>(m_handle.owner);
        if (!seam) {
            const auto* fixation = design.find<FixationSeam>(m_handle.owner);
            return text(QT_TRANSLATE_NOOP("StretchEndDrag",
                                          "%1 long \u2013 Ctrl lets go of what is near, Esc takes "
                                          "it back"))
                .arg(lengthText(fixation ? stretchLength(design, fixation->stretch) : 0));
        }
        const SeamEase ease = seamEaseOf(design, *seam);
        const bool first = m_handle.side == edits::SeamSide::A;
        return text(QT_TRANSLATE_NOOP("StretchEndDrag",
                                      "%1 long, the other side %2: ease %3, %4 \u2013 Ctrl lets go "
                                      "of what is near, Esc takes it back"))
            .arg(lengthText(first ? ease.a : ease.b), lengthText(first ? ease.b : ease.a), ease.differenceText(),
                 ease.ratioText());
    }

    void paint(QPainter& painter, const ViewColors& colors) const override
    {
        const QPointF at = pixelOf(m_now);
        const QColor color = m_context.document().breakage() ? colors.error : m_snap ? colors.snap : colors.accent;
        painter.setPen(QPen(color, 1.8));
        painter.setBrush(colors.pointFill);
        painter.drawEllipse(at, endRadius + 1, endRadius + 1);
        if (m_snap)
            paintNote(painter, colors, at, m_snap->names);
    }

private:
    /// Where the end snaps to.
    struct SnapPlace {
        double parameter = 0; ///< unwrapped, between m_low and m_high
        QStringList names;
    };

    bool movesFrom() const { return m_handle.end == edits::StretchEnd::From; }

    QPointF pixelOf(double parameter) const
    {
        return m_context.transform().toPixels(
            toLayout(m_patch, m_patch.outline.at(m_patch.outline.wrapped(parameter))));
    }

    void add(double parameter, const QString& name)
    {
        const double period = m_patch.outline.period();
        const double slack = 1e-9 * period;
        const double turns = std::ceil((m_low - parameter) / period - 1e-9);
        const double there = parameter + turns * period;
        if (there > m_high + slack)
            return;
        for (SnapPlace& place : m_places)
            if (std::abs(place.parameter - there) <= 1e-6 * period) { // the same place for one more reason
                if (!place.names.contains(name))
                    place.names += name;
                return;
            }
        m_places.push_back({there, {name}});
    }

    void findPlaces(double other)
    {
        const Design& design = m_gesture.start();
        if (!m_context.snapSettings().on)
            return;
        const auto addEnds = [&](ElementId owner, edits::SeamSide side) {
            const std::optional<Place> place = placeOf(design, owner, side);
            if (!place || place->patch != design.find<Patch>(patchId()) ||
                (owner == m_handle.owner && side == m_handle.side))
                return;
            const QString name = text(QT_TRANSLATE_NOOP("StretchEndDrag", "End of another stretch"));
            add(place->stretch.from, name);
            add(place->end, name);
        };
        for (const double corner : edits::outlineCorners(m_patch.outline))
            add(corner, text(QT_TRANSLATE_NOOP("StretchEndDrag", "Corner")));
        design.each<Seam>([&](ElementId id, const Seam&) {
            addEnds(id, edits::SeamSide::A);
            addEnds(id, edits::SeamSide::B);
        });
        design.each<FixationSeam>([&](ElementId id, const FixationSeam&) { addEnds(id, edits::SeamSide::A); });
        if (const auto* seam = design.find<Seam>(m_handle.owner)) {
            const SeamEase ease = seamEaseOf(design, *seam);
            const double wanted = m_handle.side == edits::SeamSide::A ? ease.b : ease.a;
            if (wanted > 0 && wanted < m_length.total())
                add(m_length.parameterAt(m_length.at(other) + (movesFrom() ? -wanted : wanted)),
                    text(QT_TRANSLATE_NOOP("StretchEndDrag", "As long as the other side")));
        }
    }

    ElementId patchId() const
    {
        const Design& design = m_gesture.start();
        const auto* seam = design.find<Seam>(m_handle.owner);
        if (!seam)
            return design.find<FixationSeam>(m_handle.owner)->stretch.patch;
        return (m_handle.side == edits::SeamSide::A ? seam->a : seam->b).patch;
    }

    const SnapPlace* placeNear(double parameter) const
    {
        const SnapPlace* best = nullptr;
        double nearest = m_context.transform().millimetres(endSnapReach);
        for (const SnapPlace& place : m_places)
            if (const double way = std::abs(m_length.between(parameter, place.parameter)); way < nearest) {
                nearest = way;
                best = &place;
            }
        return best;
    }

    Gesture m_gesture;
    StretchEndHandle m_handle;
    Patch m_patch; ///< at the press
    ArcLength2 m_length;
    double m_free;    ///< where the pointer would have the end, unwrapped
    Vec2 m_start;     ///< the end at the press, layout mm
    double m_low = 0; ///< where the other end stops it
    double m_high = 0;
    double m_now;
    std::vector<SnapPlace> m_places;
    const SnapPlace* m_snap = nullptr; ///< of m_places
};

} // namespace

std::vector<StretchEndHandle> stretchEndHandles(PatternToolContext& context)
{
    using edits::SeamSide, edits::StretchEnd;
    std::vector<StretchEndHandle> handles;
    const Design& design = context.document().design();
    if (context.selection().elements().size() > mostOwners)
        return handles;
    const double inset = context.transform().millimetres(handleInset);
    for (const ElementId owner : context.selection().elements()) {
        if (edits::dartOf(design, owner))
            continue; // its legs end where they are joined; it has handles of its own
        for (const SeamSide side : {SeamSide::A, SeamSide::B}) {
            const std::optional<Place> place = placeOf(design, owner, side);
            if (!place)
                continue;
            const ArcLength2 length(place->patch->outline);
            const double from = length.at(place->stretch.from), to = length.at(place->end);
            const double inside = std::min(inset, (to - from) / 4);
            for (const StretchEnd end : {StretchEnd::From, StretchEnd::To}) {
                const double t = length.parameterAt(end == StretchEnd::From ? from + inside : to - inside);
                const Vec2 at = place->patch->outline.at(place->patch->outline.wrapped(t));
                handles.push_back({owner, side, end, context.transform().toPixels(toLayout(*place->patch, at))});
            }
        }
    }
    return handles;
}

std::optional<StretchEndHandle> stretchEndAt(PatternToolContext& context, QPointF pixel)
{
    std::optional<StretchEndHandle> best;
    double nearest = handleReach;
    for (const StretchEndHandle& handle : stretchEndHandles(context))
        if (const double way = std::hypot(pixel.x() - handle.pixel.x(), pixel.y() - handle.pixel.y());
            way < nearest) {
            nearest = way;
            best = handle;
        }
    return best;
}

void paintStretchEnds(QPainter& painter, const ViewColors& colors, PatternToolContext& context,
                      const std::optional<StretchEndHandle>& over)
{
    painter.setPen(QPen(colors.accent, 1.6));
    for (const StretchEndHandle& handle : stretchEndHandles(context)) {
        const bool isOver =
            over && over->owner == handle.owner && over->side == handle.side && over->end == handle.end;
        painter.setBrush(isOver ? colors.accent : colors.pointFill);
        painter.drawEllipse(handle.pixel, endRadius, endRadius);
    }
}

std::unique_ptr<PatternDrag> dragStretchEnd(PatternToolContext& context, const PatternPointer& from,
                                            const StretchEndHandle& handle)
{
    const std::optional<Place> place = placeOf(context.document().design(), handle.owner, handle.side);
    return place ? std::make_unique<StretchEndDrag>(context, from, handle, *place) : nullptr;
}

} // namespace bolster
