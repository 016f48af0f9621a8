#include "PatternScene.h"

#include "ArcLength.h"
#include "CurvePath.h"
#include "FabricShown.h"
#include "PatchMark.h"
#include "StretchLength.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

std::vector<char> cornerPoints(const BSpline2& outline)
{
    std::vector<char> corners(static_cast<std::size_t>(outline.pointCount()), outline.degree() == 1);
    if (outline.degree() == 1)
        return corners;
    for (const double t : outline.corners()) {
        const Vec2 at = outline.at(t);
        for (int i = 0; i < outline.pointCount(); ++i)
            if ((outline.points()[static_cast<std::size_t>(i)] - at).squaredNorm() < 1e-12)
                corners[static_cast<std::size_t>(i)] = true;
    }
    return corners;
}

std::vector<PatternEdge> outlineEdges(const BSpline2& outline)
{
    std::vector<PatternEdge> edges;
    if (outline.empty() || !outline.closed())
        return edges;
    std::vector<double> corners = outline.corners();
    const bool ends = !corners.empty();
    if (!ends)
        corners.push_back(outline.domainStart());
    std::sort(corners.begin(), corners.end());
    const ArcLength2 lengths(outline);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double from = corners[i];
        const double to = i + 1 < corners.size() ? corners[i + 1] : corners.front() + outline.period();
        const double half = (lengths.at(from) + lengths.at(to)) / 2;
        edges.push_back(
            {from, to, lengths.between(from, to), outline.at(outline.wrapped(lengths.parameterAt(half))), ends});
    }
    return edges;
}

} // namespace

const LabelPlace& PatternPatch::label() const
{
    if (!knownLabel)
        knownLabel = LabelPlace::inside(path.toFillPolygon());
    return *knownLabel;
}

bool PatternStretch::contains(const BSpline2& outline, double parameter) const
{
    const double t = parameter < from ? parameter + outline.period() : parameter;
    return t >= from && t <= to;
}

void PatternScene::reset(const Design& design)
{
    m_patches.clear();
    m_stretches.clear();
    m_lines.clear();
    m_marks.clear();
    m_trims = {};
    std::set<ElementId> all;
    for (const auto& [id, element] : design.elements())
        all.insert(id);
    update(design, all);
}

void PatternScene::update(const Design& design, const std::set<ElementId>& changed)
{
    std::set<ElementId> patches;
    std::set<ElementId> owners;
    for (const ElementId id : changed) {
        patches.insert(id);
        owners.insert(id);
    }
    // What a patch's fabric and outline change beyond the patch itself.
    const bool others = changed.contains(settingsId) || changed.contains(design.settings().colourway);
    design.each<Patch>([&](ElementId id, const Patch&) {
        if (others || changed.contains(fabricShown(design, id)))
            patches.insert(id);
    });
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        if (changed.contains(seam.a.patch) || changed.contains(seam.b.patch))
            owners.insert(id);
    });
    design.each<FixationSeam>([&](ElementId id, const FixationSeam& seam) {
        if (changed.contains(seam.stretch.patch))
            owners.insert(id);
    });
    eachMarkKind([&]<class T>() {
        design.each<T>([&](ElementId id, const T& mark) {
            if (changed.contains(whereOf(mark).patch))
                owners.insert(id);
        });
    });
    design.each<Measurement>([&](ElementId id, const Measurement& measurement) {
        if (changed.contains(measurement.from.patch) || changed.contains(measurement.to.patch))
            owners.insert(id);
    });
    for (const auto& [id, element] : design.elements())
        if (const PatchCurve* drawn = patchCurve(*element); drawn && changed.contains(drawn->patch))
            owners.insert(id);
    for (const ElementId id : patches)
        updatePatch(design, id);
    for (const ElementId id : owners)
        updateLine(design, id);
    for (const ElementId id : owners)
        updateMark(design, id);
    for (const ElementId id : owners)
        updateStretches(design, id);
    m_measures.update(design, owners);
    m_trims.update(design, owners, changed);
    m_twins = PatternTwins::of(design);
}

namespace {

/// In outline coordinates; of the allowance of an edge the middle of its cut line.
std::optional<Vec2> markPlace(const Patch& patch, const Element& element)
{
    const BSpline2& outline = patch.outline;
    if (const auto* edge = std::get_if<EdgeAllowance>(&element)) {
        const auto range = stretchRange(edge->stretch, outline);
        if (!range)
            return std::nullopt;
        const double middle = outline.wrapped((range->first + range->second) / 2);
        const Vec2 along = outline.derivative(middle).normalized();
        const Vec2 right(along.y(), -along.x());
        return outline.at(middle) + edge->width * (outline.signedArea() < 0 ? Vec2(-right) : right);
    }
    std::optional<Vec2> place;
    visitMark(element, [&](const auto& mark) {
        if constexpr (requires { mark.place.at; }) {
            if (std::isfinite(mark.place.at))
                place = outline.at(outline.wrapped(mark.place.at));
        } else if constexpr (requires { mark.place.position; }) {
            place = mark.place.position;
        }
    });
    return place;
}

} // namespace

void PatternScene::updateMark(const Design& design, ElementId id)
{
    m_marks.erase(id);
    const ElementPtr element = design.element(id);
    if (!element)
        return;
    ElementId on = noElement;
    visitMark(*element, [&](const auto& mark) { on = whereOf(mark).patch; });
    const Patch* patch = on == noElement ? nullptr : design.find<Patch>(on);
    if (!patch || patch->outline.empty())
        return;
    if (const std::optional<Vec2> place = markPlace(*patch, *element))
        m_marks.emplace(id, PatternMark{id, on, toLayout(*patch, *place)});
}

void PatternScene::setFabricColors(const Design& design, std::map<ElementId, QColor> colors)
{
    m_fabricColors = std::move(colors);
    for (auto& [id, patch] : m_patches)
        patch.fabric = colorShown(design, id);
}

QColor PatternScene::colorShown(const Design& design, ElementId patch) const
{
    const ElementId id = fabricShown(design, patch);
    if (const auto known = m_fabricColors.find(id); known != m_fabricColors.end())
        return known->second;
    const Fabric* fabric = design.find<Fabric>(id);
    return fabric ? QColor(QString::fromStdString(fabric->color)) : QColor(Qt::gray);
}

void PatternScene::updatePatch(const Design& design, ElementId id)
{
    const Patch* patch = design.find<Patch>(id);
    if (!patch) {
        m_patches.erase(id);
        return;
    }
    PatternPatch& entry = m_patches[id];
    const ElementPtr before = std::exchange(entry.element, design.element(id));
    entry.id = id;
    entry.fabric = colorShown(design, id);
    entry.path = curvePath(patch->outline, [patch](const Vec2& p) { return toLayout(*patch, p); });
    const QRectF bounds = entry.path.boundingRect();
    entry.box = Box2(toVec(bounds.topLeft()), toVec(bounds.bottomRight()));
    entry.points.clear();
    for (const Vec2& p : patch->outline.points())
        entry.points.push_back(toLayout(*patch, p));
    entry.corners = cornerPoints(patch->outline);

    const Patch* old = before ? std::get_if<Patch>(before.get()) : nullptr;
    if (!old || old->outline != patch->outline)
        entry.edges = outlineEdges(patch->outline);
    if (!old || old->outline != patch->outline || old->rotation != patch->rotation)
        entry.knownLabel.reset();
    else if (entry.knownLabel)
        entry.knownLabel->move(patch->position - old->position);
}

void PatternScene::updateLine(const Design& design, ElementId id)
{
    const ElementPtr element = design.element(id);
    const PatchCurve* drawn = element ? patchCurve(*element) : nullptr;
    const Patch* on = drawn ? design.find<Patch>(drawn->patch) : nullptr;
    if (!on || drawn->curve.empty()) {
        m_lines.erase(id);
        return;
    }
    PatternLine line{id, drawn->patch, element, {}, {}, cornerPoints(drawn->curve)};
    line.path = curvePath(drawn->curve, [on](const Vec2& p) { return toLayout(*on, p); });
    for (const Vec2& p : drawn->curve.points())
        line.points.push_back(toLayout(*on, p));
    m_lines.insert_or_assign(id, std::move(line));
}

void PatternScene::updateStretches(const Design& design, ElementId owner)
{
    m_stretches.erase(owner);
    PatternStretch side;
    side.owner = owner;
    if (const Seam* seam = design.find<Seam>(owner)) {
        addStretch(side, seam->a);
        side.backwards = seam->reversed;
        addStretch(side, seam->b);
    } else if (const FixationSeam* fixation = design.find<FixationSeam>(owner)) {
        side.fixation = true;
        side.curve = fixation->curve;
        addStretch(side, fixation->stretch);
    } else if (const OutlineTrim* border = design.find<OutlineTrim>(owner)) {
        addStretch(side, border->stretch);
    }
}

void PatternScene::addStretch(PatternStretch added, const Stretch& stretch)
{
    const PatternPatch* entry = patch(stretch.patch);
    if (!entry)
        return;
    const Patch& on = entry->patch();
    const auto range = stretchRange(stretch, on.outline);
    if (!range)
        return;
    added.patch = stretch.patch;
    added.from = range->first;
    added.to = range->second;
    added.path = curvePath(on.outline, added.from, added.to, [&on](const Vec2& p) { return toLayout(on, p); });
    if (added.backwards)
        added.path = added.path.toReversed();
    m_stretches.emplace(added.owner, added);
}

const PatternPatch* PatternScene::patch(ElementId id) const
{
    const auto found = m_patches.find(id);
    return found == m_patches.end() ? nullptr : &found->second;
}

Box2 PatternScene::boundingBox() const
{
    Box2 box;
    for (const auto& [id, patch] : m_patches)
        box.extend(patch.box);
    return box;
}

Box2 PatternScene::boundingBox(const std::set<ElementId>& ids) const
{
    Box2 box;
    for (const ElementId id : ids) {
        if (const PatternPatch* entry = patch(id))
            box.extend(entry->box);
        if (const auto line = m_lines.find(id); line != m_lines.end()) {
            const QRectF bounds = line->second.path.boundingRect();
            box.extend(Box2(toVec(bounds.topLeft()), toVec(bounds.bottomRight())));
        }
        const auto [first, last] = m_stretches.equal_range(id);
        for (auto stretch = first; stretch != last; ++stretch)
            if (const PatternPatch* entry = patch(stretch->second.patch))
                box.extend(entry->box);
    }
    return box;
}

PatternHit PatternScene::hit(const Vec2& at, double tolerance, const std::function<bool(ElementId)>& pointsShown,
                             const std::function<bool(const PatternLine&)>& lineShown, bool marksShown,
                             bool measuresShown) const
{
    if (const std::optional<PatternHit> point = hitPoint(at, tolerance, pointsShown))
        return *point;
    if (const std::optional<PatternHit> mark = marksShown ? hitMark(at, tolerance) : std::nullopt)
        return *mark;
    if (const PatternMeasure* measure = measuresShown ? m_measures.at(at, tolerance) : nullptr)
        return {PatternHit::Kind::Measure, measure->patch, -1, 0, measure->id};
    if (const std::optional<PatternHit> line = hitLine(at, tolerance, lineShown))
        return *line;
    if (const std::optional<PatternHit> outline = hitOutline(at, tolerance))
        return *outline;
    for (auto entry = m_patches.rbegin(); entry != m_patches.rend(); ++entry)
        if (entry->second.box.contains(at) && entry->second.path.contains(toPoint(at)))
            return {PatternHit::Kind::Inside, entry->first};
    return {};
}

std::optional<PatternHit> PatternScene::hitMark(const Vec2& at, double tolerance) const
{
    std::optional<PatternHit> best;
    double nearest = tolerance;
    for (const auto& [id, mark] : m_marks)
        if (const double distance = (mark.place - at).norm(); distance < nearest) {
            nearest = distance;
            best = PatternHit{PatternHit::Kind::Mark, mark.patch, -1, 0, id};
        }
    return best;
}

std::optional<PatternHit> PatternScene::hitPoint(const Vec2& at, double tolerance,
                                                 const std::function<bool(ElementId)>& pointsShown) const
{
    std::optional<PatternHit> best;
    double nearest = tolerance * tolerance;
    const auto offer = [&](ElementId id, const std::vector<Vec2>& points) {
        if (!pointsShown(id))
            return;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double distance = (points[i] - at).squaredNorm();
            if (distance < nearest) {
                nearest = distance;
                best = PatternHit{PatternHit::Kind::Point, id, static_cast<int>(i)};
            }
        }
    };
    for (const auto& [id, line] : m_lines)
        offer(id, line.points);
    for (auto entry = m_patches.rbegin(); entry != m_patches.rend(); ++entry)
        offer(entry->first, entry->second.points);
    return best;
}

std::optional<PatternHit> PatternScene::hitLine(const Vec2& at, double tolerance,
                                                const std::function<bool(const PatternLine&)>& lineShown) const
{
    std::optional<PatternHit> best;
    double nearest = tolerance;
    for (const auto& [id, line] : m_lines) {
        const PatternPatch* on = patch(line.patch);
        if (!on || on->box.exteriorDistance(at) > tolerance || (lineShown && !lineShown(line)))
            continue;
        const BSpline2::Closest closest = line.curve().closest(fromLayout(on->patch(), at));
        if (closest.distance >= nearest)
            continue;
        nearest = closest.distance;
        best = PatternHit{PatternHit::Kind::Line, line.patch, -1, closest.parameter, id};
    }
    return best;
}

std::optional<PatternHit> PatternScene::hitOutline(const Vec2& at, double tolerance) const
{
    std::optional<PatternHit> best;
    double nearest = tolerance;
    for (auto entry = m_patches.rbegin(); entry != m_patches.rend(); ++entry) {
        const PatternPatch& patch = entry->second;
        if (patch.patch().outline.empty() || patch.box.exteriorDistance(at) > tolerance)
            continue;
        const BSpline2::Closest closest = patch.patch().outline.closest(fromLayout(patch.patch(), at));
        if (closest.distance >= nearest)
            continue;
        nearest = closest.distance;
        best = PatternHit{PatternHit::Kind::Outline, entry->first, -1, closest.parameter};
    }
    if (!best)
        return best;
    for (const auto& [owner, stretch] : m_stretches)
        if (stretch.patch == best->patch &&
            stretch.contains(m_patches.at(best->patch).patch().outline, best->parameter))
            best->seam = owner;
    return best;
}

} // namespace bolster
