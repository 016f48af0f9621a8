#include "GuessParts.h"

#include "BodyTree.h"

#include <algorithm>
#include <limits>

namespace bolster {

namespace {

/// Some of the places where each component is fixed, in the frame's axes.
std::vector<std::vector<Vec3>> fixedPlaces(const Placement& frame, const SewnMesh& mesh)
{
    std::vector<std::vector<Vec3>> places(mesh.diameter.size());
    for (const SewnMesh::Part& part : mesh.parts)
        for (int v = part.firstVertex; v < part.firstVertex + part.boundaryCount; ++v)
            if (const auto unknown = static_cast<int>(mesh.topology->unknown[v]); unknown >= mesh.freeCount)
                places[part.component].push_back(frame.filePoint(mesh.targets[unknown - mesh.freeCount]));
    constexpr std::size_t enough = 100;
    for (auto& list : places) {
        const std::size_t step = list.size() / enough + 1;
        std::vector<Vec3> some;
        for (std::size_t i = 0; i < list.size(); i += step)
            some.push_back(list[i]);
        list = std::move(some);
    }
    return places;
}

std::vector<BodyTree> treesOf(const FrameParts& parts, const std::stop_token& stop)
{
    std::vector<BodyTree> trees;
    for (const std::vector<FrameBody>& part : parts) {
        std::vector<const FrameBody*> bodies;
        for (const FrameBody& body : part)
            bodies.push_back(&body);
        trees.emplace_back(bodies, stop);
    }
    return trees;
}

/// 0 inside.
double distanceTo(const BodyTree& bodies, const Vec3& point)
{
    return bodies.contains(point) ? 0 : bodies.distance(point, std::numeric_limits<double>::max());
}

/// What speaks for a part under a component.
struct Claim {
    double share = 0; ///< of the component's fixed vertices that are nearest to the part
    double distance = std::numeric_limits<double>::max(); ///< mean

    bool operator<(const Claim& other) const
    {
        return share != other.share ? share < other.share : distance > other.distance;
    }
};

std::vector<Claim> claims(const std::vector<BodyTree>& parts, const std::vector<Vec3>& places,
                          const std::stop_token& stop)
{
    std::vector<Claim> claims(parts.size());
    if (places.empty() || parts.empty())
        return claims;
    std::vector<double> sums(parts.size(), 0);
    for (const Vec3& place : places) {
        if (stop.stop_requested())
            break;
        std::vector<double> distances;
        for (const BodyTree& bodies : parts)
            distances.push_back(distanceTo(bodies, place));
        const double nearest = *std::min_element(distances.begin(), distances.end());
        for (std::size_t p = 0; p < parts.size(); ++p) {
            claims[p].share += distances[p] == nearest ? 1.0 / static_cast<double>(places.size()) : 0;
            sums[p] += distances[p];
        }
    }
    for (std::size_t p = 0; p < parts.size(); ++p)
        claims[p].distance = sums[p] / static_cast<double>(places.size());
    return claims;
}

} // namespace

std::vector<std::vector<int>> guessParts(const FrameParts& parts, const Placement& frame, const SewnMesh& mesh,
                                         const std::stop_token& stop)
{
    Placement unscaled = frame;
    unscaled.scale = 1;
    const std::vector<BodyTree> trees = treesOf(parts, stop);
    std::vector<std::vector<Claim>> all;
    for (const std::vector<Vec3>& places : fixedPlaces(unscaled, mesh))
        all.push_back(claims(trees, places, stop));
    std::vector<std::vector<int>> guess(all.size());
    std::vector<int> left;
    for (int p = 0; p < std::ssize(parts); ++p) {
        const auto best =
            std::max_element(all.begin(), all.end(), [p](const auto& a, const auto& b) { return a[p] < b[p]; });
        if (best != all.end() && best->at(p).distance < std::numeric_limits<double>::max())
            guess[best - all.begin()].push_back(p);
        else
            left.push_back(p);
    }
    for (std::size_t c = 0; c < guess.size(); ++c) {
        if (!guess[c].empty() || parts.empty())
            continue;
        if (mesh.anchored[c])
            guess[c] = {static_cast<int>(std::max_element(all[c].begin(), all[c].end()) - all[c].begin())};
        else
            guess[c] = left;
    }
    return guess;
}

} // namespace bolster
