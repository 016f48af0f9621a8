#include "ScanPoints.h"

#include "PointShades.h"

#include <algorithm>

namespace bolster {

namespace {

// Of a scan: more would hide the cover, or take long to draw.
constexpr std::size_t fewPoints = 25'000;
constexpr std::size_t mostPoints = 200'000; // of one that is selected

constexpr double pickReach = 9; // pixels around the pointer

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
        const bool known = before != m_scans.end() && before->second.cloud == cloud->second;
        scans.emplace(id, known && drawnAlike(before->second.scan, scan)
                              ? before->second
                              : place(scan, cloud->second, known ? before->second.shades : nullptr));
    });
    m_scans = std::move(scans);
}

std::shared_ptr<const ScanPoints::Colors> ScanPoints::Tint::of(const QColor& color) const
{
    if (shades.empty() || (made && base == color.rgb()))
        return made;
    base = color.rgb();
    Colors colors;
    colors.reserve(shades.size());
    for (const float shade : shades) {
        const auto part = [shade](int value) {
            // Brighter than the colour itself, too: else dark ones show no form.
            return static_cast<std::uint32_t>(
                std::clamp(1.45F * shade * (static_cast<float>(value) + 25), 0.F, 255.F));
        };
        colors.push_back(part(color.red()) << 16U | part(color.green()) << 8U | part(color.blue()));
    }
    made = std::make_shared<const Colors>(std::move(colors));
    return made;
}

ScanPoints::Placed ScanPoints::place(const Scan& scan, std::shared_ptr<const PointCloud> cloud,
                                     std::shared_ptr<const Shades> shades)
{
    Placed placed;
    Points kept, cut;
    Colors keptColors, fewColors;
    const bool colored = cloud->colors.size() == cloud->points.size();
    const std::size_t step = 1 + cloud->points.size() / mostPoints;
    if (!colored && !shades) {
        std::vector<Vec3> drawn;
        for (std::size_t i = 0; i < cloud->points.size(); i += step)
            drawn.push_back(cloud->points[i]);
        shades = std::make_shared<const Shades>(pointShades(drawn));
    }
    for (std::size_t i = 0; i < cloud->points.size(); i += step) {
        const Vec3 at = scan.placed(cloud->points[i]);
        const bool gone = scan.isCutAway(cloud->points[i]);
        (gone ? cut : kept).push_back(at.cast<float>());
        if (!gone)
            placed.box.extend(at);
        if (!gone && colored)
            keptColors.push_back(cloud->colors[i]);
        else if (!gone)
            placed.keptTint.shades.push_back((*shades)[i / step]);
    }
    Points few;
    const std::size_t stride = 1 + kept.size() / fewPoints;
    for (std::size_t i = 0; i < kept.size(); i += stride) {
        few.push_back(kept[i]);
        if (colored)
            fewColors.push_back(keptColors[i]);
        else
            placed.fewTint.shades.push_back(placed.keptTint.shades[i]);
    }
    if (colored) {
        placed.keptColors = std::make_shared<const Colors>(std::move(keptColors));
        placed.fewColors = std::make_shared<const Colors>(std::move(fewColors));
    }
    placed.few = std::make_shared<const Points>(std::move(few));
    placed.shades = std::move(shades);
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
        const bool chosen = selected.contains(id);
        const std::shared_ptr<const Colors> given = chosen ? placed.keptColors : placed.fewColors;
        const QColor color = chosen ? colors.accent : plain;
        const std::shared_ptr<const Colors> shown =
            given ? (own ? given : nullptr) : (chosen ? placed.keptTint : placed.fewTint).of(color);
        looks.push_back({chosen ? placed.kept : placed.few, color, shown ? 2.2F : 1.6F, shown});
        if (!chosen)
            continue;
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

std::optional<Vec3> ScanPoints::pointAt(ElementId scan, const Camera& camera, QPointF pixel) const
{
    const auto found = m_scans.find(scan);
    if (found == m_scans.end())
        return std::nullopt;
    struct Near {
        Vec3 at;
        double depth, pixels;
    };
    std::vector<Near> near;
    for (const Eigen::Vector3f& point : *found->second.kept) {
        const Vec3 at = point.cast<double>();
        const std::optional<Vec2> seen = camera.pixel(at);
        const double pixels = seen ? (*seen - Vec2(pixel.x(), pixel.y())).norm() : pickReach;
        if (pixels < pickReach)
            near.push_back({at, camera.depth(at), pixels});
    }
    if (near.empty())
        return std::nullopt;
    // What lies behind the foremost surface is not meant, however near the pixel it is.
    const double foremost = std::ranges::min(near, {}, &Near::depth).depth;
    std::erase_if(near,
                  [&](const Near& one) { return one.depth > foremost + 2 * pickReach * camera.pixelSize(one.at); });
    return std::ranges::min(near, {}, &Near::pixels).at;
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
