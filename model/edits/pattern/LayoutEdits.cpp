#include "LayoutEdits.h"

#include "PlaneCurves.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace bolster::edits {

namespace {

struct PlacedPatch {
    ElementId id{};
    Box2 box;
    Vec2 delta = Vec2::Zero();
};

std::vector<PlacedPatch> placedOf(const Design& design, std::span<const ElementId> ids)
{
    std::vector<PlacedPatch> placed;
    for (const ElementId id : std::set<ElementId>(ids.begin(), ids.end()))
        if (const Patch* patch = design.find<Patch>(id))
            if (const Box2 box = layoutBox(*patch); !box.isEmpty())
                placed.push_back({id, box});
    return placed;
}

Box2 around(const std::vector<PlacedPatch>& placed)
{
    Box2 box;
    for (const PlacedPatch& one : placed)
        box.extend(one.box);
    return box;
}

/// One change each: thousands of patches come from other programs at once.
Edit moved(const Design& design, std::vector<PlacedPatch> placed, Message verb)
{
    std::ranges::sort(placed, {}, &PlacedPatch::id);
    Edit edit{std::move(verb), {}};
    for (const PlacedPatch& one : placed) {
        Patch patch = *design.find<Patch>(one.id);
        patch.position += one.delta;
        if (one.delta.norm() > 1e-6)
            edit.changes.push_back({one.id, design.element(one.id), makeElement(std::move(patch))});
    }
    return edit.empty() ? Edit{} : edit;
}

Message countVerb(const char* key, const std::vector<PlacedPatch>& placed)
{
    return {key, {std::to_string(placed.size())}};
}

/// Which edge of its box: 0 the lower one, 1 the upper one, in between the centre.
double edge(const Box2& box, int axis, double share)
{
    return box.min()[axis] + share * box.sizes()[axis];
}

/// About as wide as high, but never narrower than the widest.
double rowWidth(const std::vector<PlacedPatch>& placed, double gap)
{
    double area = 0, widest = 0;
    for (const PlacedPatch& one : placed) {
        const Vec2 size = one.box.sizes();
        area += (size.x() + gap) * (size.y() + gap);
        widest = std::max(widest, size.x());
    }
    return std::max(widest, 1.25 * std::sqrt(area));
}

} // namespace

Box2 layoutBox(const Patch& patch)
{
    if (patch.outline.empty())
        return {};
    Map2 place = Map2::Identity();
    place.translate(patch.position).rotate(patch.rotation * std::numbers::pi / 180);
    const auto placed = mapped(patch.outline, place);
    return placed ? placed->boundingBox() : Box2(); // nothing lies that far out
}

Box2 layoutBox(const Design& design, std::span<const ElementId> patches)
{
    return around(placedOf(design, patches));
}

Edit alignPatches(const Design& design, std::span<const ElementId> patches, Alignment alignment)
{
    std::vector<PlacedPatch> placed = placedOf(design, patches);
    if (placed.size() < 2)
        return {};
    const bool x = alignment == Alignment::Left || alignment == Alignment::Right || alignment == Alignment::CentreX;
    const bool low = alignment == Alignment::Left || alignment == Alignment::Bottom;
    const bool high = alignment == Alignment::Right || alignment == Alignment::Top;
    const int axis = x ? 0 : 1;
    const double share = low ? 0 : high ? 1 : 0.5;
    const double line = edge(around(placed), axis, share);
    for (PlacedPatch& one : placed)
        one.delta[axis] = line - edge(one.box, axis, share);
    return moved(design, placed, countVerb(QT_TRANSLATE_NOOP("Message", "Align %1 patches"), placed));
}

Edit distributePatches(const Design& design, std::span<const ElementId> patches, Direction direction)
{
    std::vector<PlacedPatch> placed = placedOf(design, patches);
    if (placed.size() < 3)
        return {};
    const int axis = direction == Direction::Horizontal ? 0 : 1;
    std::stable_sort(placed.begin(), placed.end(), [axis](const PlacedPatch& a, const PlacedPatch& b) {
        return a.box.center()[axis] < b.box.center()[axis];
    });
    const double sizes =
        std::accumulate(placed.begin(), placed.end(), 0.0,
                        [axis](double sum, const PlacedPatch& one) { return sum + one.box.sizes()[axis]; });
    const double start = placed.front().box.min()[axis], end = placed.back().box.max()[axis];
    const double gap = (end - start - sizes) / static_cast<double>(placed.size() - 1);
    double at = start;
    for (PlacedPatch& one : placed) {
        one.delta[axis] = at - one.box.min()[axis];
        at += one.box.sizes()[axis] + gap;
    }
    return moved(design, placed, countVerb(QT_TRANSLATE_NOOP("Message", "Distribute %1 patches"), placed));
}

Edit arrangePatches(const Design& design, std::span<const ElementId> patches, double gap)
{
    std::vector<ElementId> all(patches.begin(), patches.end());
    if (all.empty())
        design.each<Patch>([&](ElementId id, const Patch&) { all.push_back(id); });
    std::vector<PlacedPatch> placed = placedOf(design, all);
    if (placed.empty() || !(gap >= 0))
        return {};
    const Box2 whole = around(placed);
    const auto height = [](const PlacedPatch& one) {
        return std::round(1e3 * one.box.sizes().y());
    }; // not its rounding
    std::stable_sort(placed.begin(), placed.end(),
                     [&](const PlacedPatch& a, const PlacedPatch& b) { return height(a) > height(b); });
    const double width = rowWidth(placed, gap);
    const Vec2 corner(whole.min().x(), whole.max().y());
    Vec2 at = corner; // the next one's upper left corner
    double rowHeight = 0;
    for (PlacedPatch& one : placed) {
        const Vec2 size = one.box.sizes();
        if (at.x() > corner.x() && at.x() + size.x() > corner.x() + width) {
            at = {corner.x(), at.y() - rowHeight - gap};
            rowHeight = 0;
        }
        one.delta = at - Vec2(one.box.min().x(), one.box.max().y());
        at.x() += size.x() + gap;
        rowHeight = std::max(rowHeight, size.y());
    }
    return moved(design, placed, countVerb(QT_TRANSLATE_NOOP("Message", "Arrange %1 patches"), placed));
}

} // namespace bolster::edits
