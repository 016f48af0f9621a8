#include "Rims.h"

#include <cmath>

namespace bolster {

namespace {

constexpr double flatRim = 0.1, wavyRim = 0.3; // of its radius, across its plane
constexpr double leastTurn = 0.1;              // of a disc's area: what a rim must go around

/// What is added up over a component's vertices.
struct RimSums {
    double vertices = 0, squares = 0, across = 0; ///< mm^2: from the centre, and along `up`
};

} // namespace

bool isHeld(const SewnMesh& mesh, int v)
{
    return static_cast<int>(mesh.topology->unknown[v]) >= mesh.freeCount;
}

const Vec3& heldAt(const SewnMesh& mesh, int v)
{
    return mesh.targets[mesh.topology->unknown[v] - static_cast<std::uint32_t>(mesh.freeCount)];
}

int nextOf(const SewnMesh::Part& part, int v)
{
    return v + 1 < part.firstVertex + part.boundaryCount ? v + 1 : part.firstVertex;
}

std::optional<int> nextHeld(const SewnMesh& mesh, const SewnMesh::Part& part, int v)
{
    if (v >= part.firstVertex + part.boundaryCount || !isHeld(mesh, nextOf(part, v)))
        return std::nullopt;
    return nextOf(part, v);
}

double senseOf(const SewnMesh& mesh, const SewnMesh::Part& part)
{
    double area = 0;
    for (int v = part.firstVertex; v < part.firstVertex + part.boundaryCount; ++v) {
        const Vec2 &here = mesh.rest()[v], &next = mesh.rest()[nextOf(part, v)];
        area += here.x() * next.y() - here.y() * next.x();
    }
    return area < 0 ? -1 : 1;
}

std::vector<Rim> rimsOf(const SewnMesh& mesh)
{
    std::vector<Rim> rims(mesh.diameter.size());
    std::vector<RimSums> sums(rims.size());
    const auto eachHeld = [&](const auto& visit) {
        for (const SewnMesh::Part& part : mesh.parts)
            for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v)
                if (isHeld(mesh, v))
                    visit(v, rims[part.component], sums[part.component]);
    };
    eachHeld([&](int v, Rim& rim, RimSums& sum) {
        rim.centre += heldAt(mesh, v);
        sum.vertices += 1;
    });
    for (std::size_t c = 0; c < rims.size(); ++c)
        rims[c].centre /= std::max(sums[c].vertices, 1.0);
    eachHeld(
        [&](int v, const Rim& rim, RimSums& sum) { sum.squares += (heldAt(mesh, v) - rim.centre).squaredNorm(); });
    for (const SewnMesh::Part& part : mesh.parts) {
        Rim& rim = rims[part.component];
        const double sense = part.outward * senseOf(mesh, part);
        for (int v = part.firstVertex; v < part.firstVertex + part.boundaryCount; ++v)
            if (isHeld(mesh, v) && isHeld(mesh, nextOf(part, v)))
                rim.up +=
                    sense / 2 * (heldAt(mesh, v) - rim.centre).cross(heldAt(mesh, nextOf(part, v)) - rim.centre);
    }
    for (std::size_t c = 0; c < rims.size(); ++c) {
        const double disc = EIGEN_PI * sums[c].squares / std::max(sums[c].vertices, 1.0);
        rims[c].up = rims[c].up.norm() > leastTurn * disc ? Vec3(rims[c].up.normalized()) : Vec3(Vec3::Zero());
    }
    eachHeld([&](int v, const Rim& rim, RimSums& sum) {
        sum.across += std::pow(rim.up.dot(heldAt(mesh, v) - rim.centre), 2);
    });
    for (std::size_t c = 0; c < rims.size(); ++c) {
        const double wave = std::sqrt(sums[c].across / std::max(sums[c].squares, 1e-300));
        rims[c].isFlat = wave < flatRim;
        if (wave > wavyRim)
            rims[c].up.setZero();
    }
    return rims;
}

} // namespace bolster
