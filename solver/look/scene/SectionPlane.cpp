#include "SectionPlane.h"

#include <algorithm>
#include <iterator>

namespace bolster {

std::vector<std::vector<Eigen::Vector3f>> keptParts(const std::vector<Eigen::Vector3f>& line,
                                                    const SectionPlane& section)
{
    std::vector<std::vector<Eigen::Vector3f>> parts;
    std::vector<Eigen::Vector3f> part;
    const auto end = [&] {
        if (part.size() > 1)
            parts.push_back(part);
        part.clear();
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        const double here = section.height(line[i].cast<double>());
        const double before = i > 0 ? section.height(line[i - 1].cast<double>()) : here;
        if ((before < 0) != (here < 0)) {
            const auto share = static_cast<float>(before / (before - here));
            part.emplace_back(line[i - 1] + share * (line[i] - line[i - 1]));
        }
        if (here >= 0)
            part.push_back(line[i]);
        else
            end();
    }
    end();
    return parts;
}

std::vector<Eigen::Vector3f> keptPoints(const std::vector<Eigen::Vector3f>& points, const SectionPlane& section)
{
    std::vector<Eigen::Vector3f> kept;
    std::ranges::copy_if(points, std::back_inserter(kept),
                         [&](const Eigen::Vector3f& p) { return section.keeps(p.cast<double>()); });
    return kept;
}

std::pair<double, double> sectionRange(const Box3& box, const Vec3& normal)
{
    if (box.isEmpty())
        return {-1, 1};
    const double middle = normal.dot(box.center()), reach = normal.cwiseAbs().dot(box.sizes()) / 2;
    return {middle - reach, middle + reach};
}

std::vector<Vec3> planeFrame(const Box3& box, const Vec3& normal, double offset)
{
    constexpr double margin = 0.04; // of the box's diagonal
    const Vec3 up = std::abs(normal.z()) > 0.9 ? Vec3::UnitY() : Vec3::UnitZ();
    const Vec3 u = up.cross(normal).normalized(), v = normal.cross(u), center = box.center();
    const Vec3 middle = center + (offset - normal.dot(center)) * normal;
    const Vec3 half = box.sizes() / 2;
    const double more = margin * box.diagonal().norm();
    const Vec3 x = (half.dot(u.cwiseAbs()) + more) * u, y = (half.dot(v.cwiseAbs()) + more) * v;
    return {middle - x - y, middle + x - y, middle + x + y, middle - x + y, middle - x - y};
}

} // namespace bolster
