#include "SeamLines.h"

#include "Design.h"

#include <optional>
#include <unordered_map>

namespace bolster {

namespace {

constexpr float lineWidth = 0.8F; ///< mm to each side: where the shaded valley is darkest
constexpr float lineLift = 0.12F; ///< mm above the cover, so that they do not fight for the same place

/// What lies beside an edge: the third corner of the triangle that has it in this direction.
class Beside {
public:
    explicit Beside(const CoverTopology& topology)
    {
        for (const CoverTopology::Triangle& t : topology.triangles)
            for (std::size_t i = 0; i < 3; ++i)
                m_third.emplace(key(t[i], t[(i + 1) % 3]), t[(i + 2) % 3]);
    }

    std::optional<std::uint32_t> left(std::uint32_t from, std::uint32_t to) const
    {
        const auto found = m_third.find(key(from, to));
        return found != m_third.end() ? std::optional(found->second) : std::nullopt;
    }

private:
    static std::uint64_t key(std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} << 32 | b; }

    std::unordered_map<std::uint64_t, std::uint32_t> m_third;
};

bool isLined(const Design& design, ElementId id)
{
    const Seam* const seam = design.find<Seam>(id);
    return !seam || (seam->trim.valley && !seam->trim.hasPiping());
}

ElementId patchOf(const SurfaceTopology& topology, std::uint32_t vertex)
{
    for (const SurfaceTopology::PatchRange& range : topology.patches)
        if (vertex >= range.firstVertex && vertex < range.firstVertex + range.vertexCount)
            return range.patch;
    return noElement;
}

/// Which way the patch lies from each vertex of a run, in the cover; zero where there is nothing.
std::vector<Eigen::Vector3f> inwards(const CoverMesh& cover, const std::vector<std::uint32_t>& run,
                                     const Beside& beside, bool& isLeft)
{
    std::vector<Eigen::Vector3f> into(run.size(), Eigen::Vector3f::Zero());
    for (std::size_t i = 1; i < run.size(); ++i) {
        const auto left = beside.left(run[i - 1], run[i]), right = beside.left(run[i], run[i - 1]);
        if (!left && !right)
            continue;
        isLeft = left.has_value();
        const Eigen::Vector3f &a = cover.points[run[i - 1]], &b = cover.points[run[i]];
        const Eigen::Vector3f along = (b - a).normalized(), aside = cover.points[left ? *left : *right] - a;
        const Eigen::Vector3f across = (aside - aside.dot(along) * along).normalized();
        for (const std::size_t end : {i - 1, i})
            if (across.allFinite())
                into[end] += across;
    }
    return into;
}

SeamLine lineAlong(const CoverMesh& cover, const std::vector<std::uint32_t>& run, const Beside& beside)
{
    SeamLine line;
    bool isLeft = true;
    const std::vector<Eigen::Vector3f> into = inwards(cover, run, beside, isLeft);
    for (std::size_t i = 0; i < run.size(); ++i) {
        const Eigen::Vector3f& normal = cover.normals[run[i]];
        Eigen::Vector3f aside = into[i] - into[i].dot(normal) * normal;
        aside =
            aside.norm() > 1e-3F ? Eigen::Vector3f(aside.normalized()) : Eigen::Vector3f(Eigen::Vector3f::Zero());
        const Eigen::Vector3f on = cover.points[run[i]] + lineLift * normal;
        line.points.insert(line.points.end(), {on, Eigen::Vector3f(on + lineWidth * aside)});
        line.normals.insert(line.normals.end(), 2, normal);
    }
    for (std::uint32_t i = 0; i + 3 < line.points.size(); i += 2) {
        const std::uint32_t a = i, b = i + 1, c = i + 2, d = i + 3;
        if (isLeft)
            line.triangles.insert(line.triangles.end(), {{a, c, d}, {a, d, b}});
        else
            line.triangles.insert(line.triangles.end(), {{a, d, c}, {a, b, d}});
    }
    return line;
}

} // namespace

std::vector<SeamLine> seamLines(const Design& design, const CoverMesh& cover)
{
    const SurfaceTopology& coarse = *cover.topology->coarse;
    const Beside beside(*cover.topology);
    std::vector<SeamLine> lines;
    for (const SurfaceTopology::Chain& chain : coarse.seams) {
        if (!isLined(design, chain.seam))
            continue;
        for (const std::vector<std::uint32_t>* side : {&chain.a, &chain.b}) {
            if (side->size() < 2)
                continue;
            SeamLine line = lineAlong(cover, cover.topology->along(*side), beside);
            line.seam = chain.seam;
            line.patch = patchOf(coarse, side->front());
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

} // namespace bolster
