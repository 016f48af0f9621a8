#include "ScanPoints.h"

#include <algorithm>

namespace bolster {

namespace {

// Of a scan: more would hide the cover, or take long to draw.
constexpr std::size_t fewPoints = 25'000;
constexpr std::size_t mostPoints = 200'000; // of one that is selected

bool drawnAlike(const Scan& a, const Scan& b)
{
    return static_cast<const Placement&>(a) == b && a.cuts == b.cuts;
}

} // namespace

void ScanPoints::update(const Design& design, const DesignFiles& files)
{
    std::map<ElementId, Placed> scans;
    design.each<Scan>([&](ElementId id, const Scan& scan) {
        const auto cloud = files.clouds.find(id);
        if (cloud == files.clouds.end())
            return;
        const auto before = m_scans.find(id);
        const bool same = before != m_scans.end() && before->second.cloud == cloud->second &&
                          drawnAlike(before->second.scan, scan);
        scans.emplace(id, same ? before->second : place(scan, cloud->second));
    });
    m_scans = std::move(scans);
}

ScanPoints::Placed ScanPoints::place(const Scan& scan, std::shared_ptr<const PointCloud> cloud)
{
    Placed placed;
    Points kept, cut;
    Colors keptColors, fewColors;
    const bool colored = cloud->colors.size() == cloud->points.size();
    const std::size_t step = 1 + cloud->points.size() / mostPoints;
    for (std::size_t i = 0; i < cloud->points.size(); i += step) {
        const Vec3 at = scan.placed(cloud->points[i]);
        const bool gone = scan.isCutAway(cloud->points[i]);
        (gone ? cut : kept).push_back(at.cast<float>());
        if (!gone)
            placed.box.extend(at);
        if (!gone && colored)
            keptColors.push_back(cloud->colors[i]);
    }
    Points few;
    const std::size_t stride = 1 + kept.size() / fewPoints;
    for (std::size_t i = 0; i < kept.size(); i += stride) {
        few.push_back(kept[i]);
        if (colored)
            fewColors.push_back(keptColors[i]);
    }
    if (colored) {
        placed.keptColors = std::make_shared<const Colors>(std::move(keptColors));
        placed.fewColors = std::make_shared<const Colors>(std::move(fewColors));
    }
    placed.few = std::make_shared<const Points>(std::move(few));
    placed.scan = scan;
    placed.cloud = std::move(cloud);
    placed.kept = std::make_shared<const Points>(std::move(kept));
    placed.cut = std::make_shared<const Points>(std::move(cut));
    return placed;
}

std::vector<ViewScene::PointsLook> ScanPoints::looks(const std::set<ElementId>& selected, const ViewColors& colors,
                                                     const std::set<ElementId>& hidden, bool own) const
{
    std::vector<ViewScene::PointsLook> looks;
    for (const auto& [id, placed] : m_scans) {
        if (hidden.contains(id))
            continue;
        const QColor plain = colors.dark ? QColor(0x6f, 0xb6, 0xe8) : QColor(0x1f, 0x6f, 0xa8);
        if (!selected.contains(id)) {
            looks.push_back(
                {placed.few, plain, own && placed.fewColors ? 2.2F : 1.6F, own ? placed.fewColors : nullptr});
            continue;
        }
        looks.push_back({placed.kept, colors.accent, own && placed.keptColors ? 2.2F : 1.4F,
                         own ? placed.keptColors : nullptr});
        QColor faint = colors.mutedLabel;
        faint.setAlphaF(0.35F);
        if (!placed.cut->empty())
            looks.push_back({placed.cut, faint, 1.6F});
    }
    return looks;
}

Box3 ScanPoints::box(ElementId scan) const
{
    const auto found = m_scans.find(scan);
    return found == m_scans.end() ? Box3() : found->second.box;
}

bool ScanPoints::hasColors() const
{
    return std::ranges::any_of(m_scans, [](const auto& scan) { return scan.second.fewColors != nullptr; });
}

Box3 ScanPoints::box() const
{
    Box3 all;
    for (const auto& [id, placed] : m_scans)
        all.extend(placed.box);
    return all;
}

} // namespace bolster
