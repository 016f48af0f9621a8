#include "BuiltScan.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace bolster::test {

namespace {

constexpr double farthestPoint = 60; // mm

double sizeOf(const SurfaceMesh& surface)
{
    Box3 box;
    for (const Vec3& at : surface.positions)
        box.extend(at);
    return box.diagonal().norm();
}

} // namespace

FitTarget scanOf(const SurfaceMesh& built, double spacing, double noise, unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> error(0, noise);
    std::uniform_real_distribution<double> share(0, 1);
    std::uniform_int_distribution<std::size_t> vertex(0, built.positions.size() - 1);
    const std::array holes{built.positions[vertex(random)], built.positions[vertex(random)],
                           built.positions[vertex(random)]};
    const double radius = std::min(50.0, sizeOf(built) / 10);
    PointCloud cloud;
    for (const auto& t : built.topology->triangles) {
        const Vec3 a = built.positions[t[0]], b = built.positions[t[1]] - a, c = built.positions[t[2]] - a;
        double points = 0.5 * b.cross(c).norm() / (spacing * spacing);
        for (; points > share(random); --points) {
            double u = share(random), v = share(random);
            if (u + v > 1)
                u = 1 - u, v = 1 - v;
            const Vec3 at = a + u * b + v * c;
            if (std::ranges::none_of(holes, [&](const Vec3& hole) { return (at - hole).norm() < radius; }))
                cloud.points.emplace_back(at + Vec3(error(random), error(random), error(random)));
        }
    }
    Scan scan;
    scan.threshold = farthestPoint;
    return targetOf(scan, cloud);
}

Injected injected(const std::vector<Cause>& causes, unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<Cause::Kind> kinds;
    for (const Cause& cause : causes)
        if (std::ranges::find(kinds, cause.kind) == kinds.end())
            kinds.push_back(cause.kind);
    const Cause::Kind kind = kinds[seed % kinds.size()];
    std::vector<std::size_t> ofKind;
    for (std::size_t k = 0; k < causes.size(); ++k)
        if (causes[k].kind == kind)
            ofKind.push_back(k);
    Injected result;
    result.cause = ofKind[std::uniform_int_distribution<std::size_t>(0, ofKind.size() - 1)(random)];
    const std::vector<Tolerance>& numbers = causes[result.cause].numbers;
    std::normal_distribution<double> direction;
    result.values = Eigen::VectorXd::NullaryExpr(std::ssize(numbers), [&] { return direction(random); });
    result.values *= std::uniform_real_distribution<double>(0.4, 1)(random) / result.values.norm();
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        double number = 2 * numbers[k].spread * result.values[static_cast<Eigen::Index>(k)];
        if (numbers[k].whole)
            number = std::copysign(std::ceil(std::abs(number)), number) * numbers[k].freedoms.front().step;
        result.values[static_cast<Eigen::Index>(k)] = number;
    }
    return result;
}

bool isFound(const Explanations& explanations, std::size_t cause)
{
    if (explanations.ranked.empty())
        return false;
    const Explanation& first = explanations.ranked.front();
    return first.cause == cause || std::ranges::find(first.alike, cause) != first.alike.end();
}

} // namespace bolster::test
