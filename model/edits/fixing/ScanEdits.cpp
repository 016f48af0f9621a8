#include "ScanEdits.h"

#include "EditHelpers.h"
#include "ElementEdits.h"

#include <algorithm>
#include <cmath>

namespace bolster::edits {

namespace {

Edit changedScan(const Design& design, ElementId id, const char* verb, const std::function<void(Scan&)>& change)
{
    const Scan* found = design.find<Scan>(id);
    if (!found)
        return {};
    Scan scan = *found;
    change(scan);
    return replaceElement(design, id, makeElement(std::move(scan)), {verb, {found->name}});
}

/// The height, if the cut is one half-space that ends in a level plane.
std::optional<double> levelOf(const ScanCut& cut, const Placement& placement)
{
    if (cut.keep || cut.halfSpaces.size() != 1)
        return std::nullopt;
    const HalfSpace& half = cut.halfSpaces.front();
    const Vec3 normal = placement.rotation * half.normal;
    const bool level = normal.z() > 0 && normal.head<2>().norm() < 1e-6 * normal.z();
    const double height = half.distance * placement.scale / normal.z() + placement.position.z();
    return level ? std::optional(height) : std::nullopt;
}

} // namespace

HalfSpace halfSpaceIn(const Placement& placement, const Vec3& normal, double distance)
{
    // normal . (R (scale p) + position) <= distance
    return {placement.rotation.conjugate() * normal, (distance - normal.dot(placement.position)) / placement.scale};
}

ScanCut boxCut(const Placement& placement, const Box3& box, bool keep)
{
    ScanCut cut{{}, keep};
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 normal = Vec3::Unit(axis);
        cut.halfSpaces.push_back(halfSpaceIn(placement, normal, box.max()[axis]));
        cut.halfSpaces.push_back(halfSpaceIn(placement, -normal, -box.min()[axis]));
    }
    return cut;
}

Edit addCut(const Design& design, ElementId scan, ScanCut cut)
{
    return changedScan(design, scan, QT_TRANSLATE_NOOP("Message", "Cut %1"),
                       [&](Scan& s) { s.cuts.push_back(std::move(cut)); });
}

Edit removeCuts(const Design& design, ElementId scan)
{
    return changedScan(design, scan, QT_TRANSLATE_NOOP("Message", "Show all of %1"),
                       [](Scan& s) { s.cuts.clear(); });
}

Edit cutFloor(const Design& design, ElementId scan, double height)
{
    return changedScan(design, scan, QT_TRANSLATE_NOOP("Message", "Cut the floor off %1"), [&](Scan& s) {
        std::erase_if(s.cuts, [&](const ScanCut& cut) { return levelOf(cut, s).has_value(); });
        s.cuts.push_back({{halfSpaceIn(s, Vec3::UnitZ(), height)}, false});
    });
}

std::optional<double> floorOf(const Scan& scan)
{
    for (const ScanCut& cut : scan.cuts)
        if (const auto level = levelOf(cut, scan))
            return level;
    return std::nullopt;
}

} // namespace bolster::edits
