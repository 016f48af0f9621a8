#include "PageFactsOf.h"

#include "FabricShown.h"
#include "Srgb.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bolster {

namespace {

std::string patchName(const Design& design, const SurfaceTopology& topology, std::uint32_t vertex)
{
    for (const SurfaceTopology::PatchRange& range : topology.patches)
        if (vertex >= range.firstVertex && vertex < range.firstVertex + range.vertexCount) {
            const auto* const patch = design.find<Patch>(range.patch);
            return patch && !patch->name.empty() ? patch->name : std::to_string(number(range.patch));
        }
    return {};
}

PageSeam pageSeam(const Design& design, const SurfaceMesh& surface, const SurfaceTopology::Chain& chain)
{
    constexpr float above = 0.5F; // mm, so that the line is seen
    PageSeam seam;
    const std::string a = patchName(design, *surface.topology, chain.a.front());
    const std::string b = chain.b.empty() ? "" : patchName(design, *surface.topology, chain.b.front());
    seam.name = b.empty() || b == a ? a : a + " \u2013 " + b;
    for (std::size_t i = 0; i < chain.a.size(); ++i) {
        Eigen::Vector3f outwards = surface.normals[chain.a[i]];
        if (i < chain.b.size())
            outwards += surface.normals[chain.b[i]];
        const Vec3& at = surface.positions[chain.a[i]];
        const bool known = outwards.allFinite() && outwards.norm() > 0.1F;
        seam.line.push_back(at.cast<float>() + (known ? above : 0) * outwards.normalized());
        if (i > 0)
            seam.length += (at - surface.positions[chain.a[i - 1]]).norm();
    }
    return seam;
}

/// Of the largest patch's fabric: what one remembers of a colourway.
std::string colorOf(const CoverModel& model, std::size_t colourway)
{
    const ModelMesh* largest = nullptr;
    for (const ModelMesh& mesh : model.meshes)
        if (mesh.kind == ModelMesh::Kind::Patch && (!largest || mesh.triangles.size() > largest->triangles.size()))
            largest = &mesh;
    if (!largest)
        return "#808080";
    const Eigen::Vector3f& color = model.materials[largest->materials[colourway]].mean;
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x",
                  static_cast<unsigned>(std::lround(255 * srgbFromLinear(std::clamp(color.x(), 0.F, 1.F)))),
                  static_cast<unsigned>(std::lround(255 * srgbFromLinear(std::clamp(color.y(), 0.F, 1.F)))),
                  static_cast<unsigned>(std::lround(255 * srgbFromLinear(std::clamp(color.z(), 0.F, 1.F)))));
    return text;
}

/// As somebody sees it who stands before the front.
Eigen::Vector3f sizeFromFront(const CoverModel& model)
{
    const Eigen::AngleAxisf turn(static_cast<float>(-model.front), Eigen::Vector3f::UnitZ());
    Eigen::AlignedBox3f box;
    for (const ModelMesh& mesh : model.meshes)
        for (const Eigen::Vector3f& p : mesh.points)
            box.extend(turn * p);
    return box.isEmpty() ? Eigen::Vector3f(Eigen::Vector3f::Zero()) : Eigen::Vector3f(box.sizes());
}

} // namespace

PageFacts pageFacts(const ModelSubject& subject, const CoverModel& model, const std::string& title)
{
    PageFacts facts;
    facts.title = title;
    facts.size = sizeFromFront(model);
    for (const SurfaceTopology::Chain& chain : subject.surface->topology->seams)
        if (chain.a.size() > 1)
            if (PageSeam seam = pageSeam(subject.design, *subject.surface, chain); seam.length > 0)
                facts.seams.push_back(std::move(seam));
    std::ranges::stable_sort(facts.seams, std::greater<>(), &PageSeam::length);
    for (std::size_t colourway = 0; colourway < model.colourways.size(); ++colourway)
        facts.colors.push_back(colorOf(model, colourway));
    return facts;
}

} // namespace bolster
