#include "MakeCoverModel.h"

#include "ColourwayEdits.h"
#include "CoverRefiner.h"
#include "FabricShown.h"
#include "FrameMeshes.h"
#include "MaterialBook.h"
#include "MeshShape.h"
#include "SeamLines.h"
#include "SeamTrims.h"
#include "TriangleTree.h"

#include <algorithm>

namespace bolster {

namespace {

using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;

/// Takes the vertices of some triangles, each once, in the order in which they come.
class VertexTaker {
public:
    explicit VertexTaker(std::size_t vertices)
        : m_new(vertices, none)
    {}

    /// The new number; `take` is called for one that is seen for the first time.
    template <class Take>
    std::uint32_t operator()(std::uint32_t vertex, const Take& take)
    {
        if (m_new[vertex] == none) {
            m_new[vertex] = m_count++;
            take(vertex);
        }
        return m_new[vertex];
    }

private:
    static constexpr std::uint32_t none = ~0U;

    std::vector<std::uint32_t> m_new;
    std::uint32_t m_count = 0;
};

TriangleTree coverTree(const SurfaceMesh& cover, const std::stop_token& stop)
{
    std::vector<TriangleTree::Triangle> triangles;
    for (const auto& t : cover.topology->triangles)
        triangles.push_back({cover.positions[t[0]], cover.positions[t[1]], cover.positions[t[2]]});
    return TriangleTree(triangles, stop);
}

void append(const ModelMesh& from, ModelMesh& to)
{
    const auto first = static_cast<std::uint32_t>(to.points.size());
    to.points.insert(to.points.end(), from.points.begin(), from.points.end());
    to.normals.insert(to.normals.end(), from.normals.begin(), from.normals.end());
    for (std::size_t set = 0; set < to.places.size(); ++set)
        to.places[set].insert(to.places[set].end(), from.places[set].begin(), from.places[set].end());
    for (const auto& t : from.triangles)
        to.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

class CoverModeller {
public:
    CoverModeller(const ModelSubject& subject, const PictureKind& pictures, std::stop_token stop)
        : m_subject(subject)
        , m_design(subject.design)
        , m_stop(std::move(stop))
        , m_cover(CoverRefiner().refine(subject.surface, 1))
        , m_book(subject.design, subject.bake, pictures)
    {
        takeColourways();
    }

    CoverModel make(bool frames);

private:
    void takeColourways();
    void addPatch(const SurfaceTopology::PatchRange& range);
    void dressPatch(const SurfaceTopology::PatchRange& range, const std::vector<Vec2f>& pattern, ModelMesh& mesh);
    void addTrims();
    ModelMesh trimMesh(const TrimMesh& trims, const TrimMesh::Part& part) const;
    void addSeams();
    void addFrames();
    void join(ModelMesh mesh);

    const ModelSubject& m_subject;
    const Design& m_design;
    std::stop_token m_stop;
    CoverMeshPtr m_cover;
    MaterialBook m_book;
    std::vector<ElementId> m_colourways;
    CoverModel m_model;
};

void CoverModeller::takeColourways()
{
    const ElementId set = m_design.settings().colourway;
    const bool shows = m_design.find<Colourway>(set) != nullptr;
    m_colourways.push_back(shows ? set : noElement);
    m_model.colourways.push_back(shows ? m_design.find<Colourway>(set)->name : "Own fabrics");
    m_design.each<Colourway>([&](ElementId id, const Colourway& colourway) {
        if (id == set)
            return;
        m_colourways.push_back(id);
        m_model.colourways.push_back(colourway.name);
    });
    for (std::size_t i = 0; i < m_model.colourways.size(); ++i) {
        std::string& name = m_model.colourways[i];
        const auto before = m_model.colourways.begin() + static_cast<std::ptrdiff_t>(i);
        if (name.empty() || std::find(m_model.colourways.begin(), before, name) != before)
            name = (name.empty() ? "Colourway" : name) + " " + std::to_string(i + 1);
    }
}

/// Colourways may lay their fabrics in different directions: those that agree share texture coordinates. The first
/// fabric of a set repeats as the coordinates say, so that programs that know no more show it as it is.
void CoverModeller::dressPatch(const SurfaceTopology::PatchRange& range, const std::vector<Vec2f>& pattern,
                               ModelMesh& mesh)
{
    struct Laid {
        double turn;
        Vec2f tile;
    };
    const auto* const patch = m_design.find<Patch>(range.patch);
    std::vector<Laid> sets;
    for (const ElementId colourway : m_colourways) {
        const ElementId id = fabricShown(m_design, range.patch, colourway);
        const auto* const fabric = m_design.find<Fabric>(id);
        const FabricMapsPtr maps = fabric ? m_book.maps(id) : nullptr;
        if (!maps || !patch) {
            mesh.materials.push_back(m_book.fabric(id));
            continue;
        }
        const double turn = clothTurn(*patch, *fabric);
        const Vec2f tile(static_cast<float>(maps->widthMm), static_cast<float>(maps->heightMm));
        auto set = std::ranges::find(sets, turn, &Laid::turn);
        if (set == sets.end())
            set = sets.insert(sets.end(), Laid{turn, tile});
        mesh.materials.push_back(m_book.fabric(id, static_cast<std::size_t>(set - sets.begin()), set->tile));
    }
    for (const Laid& set : sets) {
        const Eigen::Rotation2Df toTile(static_cast<float>(-set.turn));
        ModelMesh::Places& places = mesh.places.emplace_back();
        for (const Vec2f& p : pattern)
            places.emplace_back((toTile * p).cwiseQuotient(set.tile));
    }
}

void CoverModeller::addPatch(const SurfaceTopology::PatchRange& range)
{
    const CoverTopology& topology = *m_cover->topology;
    ModelMesh mesh;
    const auto* const patch = m_design.find<Patch>(range.patch);
    mesh.name = patch && !patch->name.empty() ? patch->name : "Patch " + std::to_string(number(range.patch));
    std::vector<Vec2f> pattern;
    VertexTaker taker(topology.pattern.size());
    const std::size_t each = topology.trianglesPerCoarse(), first = each * range.firstTriangle;
    for (std::size_t t = first; t < first + each * range.triangleCount; ++t) {
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = taker(topology.triangles[t][i], [&](std::uint32_t v) {
                mesh.points.push_back(m_cover->points[v]);
                mesh.normals.push_back(unitOr(m_cover->normals[v], Vec3f::UnitZ()));
                pattern.push_back(topology.pattern[v]);
            });
        mesh.triangles.push_back(corners);
    }
    dressPatch(range, pattern, mesh);
    if (!mesh.triangles.empty())
        m_model.meshes.push_back(std::move(mesh));
}

/// What is alike but for its place becomes one mesh.
void CoverModeller::join(ModelMesh mesh)
{
    if (mesh.triangles.empty())
        return;
    for (ModelMesh& other : m_model.meshes)
        if (other.kind == mesh.kind && other.materials == mesh.materials &&
            other.places.size() == mesh.places.size()) {
            append(mesh, other);
            return;
        }
    m_model.meshes.push_back(std::move(mesh));
}

ModelMesh CoverModeller::trimMesh(const TrimMesh& trims, const TrimMesh::Part& part) const
{
    ModelMesh mesh;
    mesh.kind = ModelMesh::Kind::Trim;
    mesh.name = part.fabric == noElement ? "Stitches" : "Piping";
    if (part.fabric != noElement)
        mesh.places.emplace_back();
    VertexTaker taker(trims.points.size());
    for (std::uint32_t t = part.firstTriangle; t < part.firstTriangle + part.triangleCount; ++t) {
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = taker(trims.triangles[t][i], [&](std::uint32_t v) {
                mesh.points.push_back(trims.points[v]);
                mesh.normals.push_back(unitOr(trims.normals[v], Vec3f::UnitZ()));
                for (ModelMesh::Places& places : mesh.places)
                    places.push_back(trims.cloth[v]);
            });
        mesh.triangles.push_back(corners);
    }
    return mesh;
}

/// Their shape is that of all colourways; only what the pipes wear may differ.
void CoverModeller::addTrims()
{
    SeamTrims maker;
    std::vector<TrimMeshPtr> dressed;
    for (const ElementId colourway : m_colourways)
        dressed.push_back(maker.make(m_design.with(edits::showColourway(m_design, colourway)), *m_cover, m_stop));
    if (!dressed.front() || m_stop.stop_requested())
        return;
    for (std::size_t p = 0; p < dressed.front()->parts.size(); ++p) {
        const TrimMesh::Part& part = dressed.front()->parts[p];
        ModelMesh mesh = trimMesh(*dressed.front(), part);
        const FabricMapsPtr maps = part.fabric != noElement ? m_book.maps(part.fabric) : nullptr;
        Vec2f tile(100, 100);
        if (maps)
            tile = {static_cast<float>(maps->widthMm), static_cast<float>(maps->heightMm)};
        for (ModelMesh::Places& places : mesh.places)
            for (Vec2f& place : places)
                place = place.cwiseQuotient(tile);
        for (const TrimMeshPtr& trims : dressed) {
            const TrimMesh::Part& same = trims->parts[p];
            mesh.materials.push_back(same.fabric == noElement ? m_book.thread(same.color)
                                                              : m_book.fabric(same.fabric, 0, tile));
        }
        join(std::move(mesh));
    }
}

void CoverModeller::addSeams()
{
    for (SeamLine& line : seamLines(m_design, *m_cover)) {
        ModelMesh mesh;
        mesh.kind = ModelMesh::Kind::Seam;
        mesh.name = "Seams";
        mesh.points = std::move(line.points);
        mesh.triangles = std::move(line.triangles);
        for (const Vec3f& normal : line.normals)
            mesh.normals.push_back(unitOr(normal, Vec3f::UnitZ()));
        for (const ElementId colourway : m_colourways)
            mesh.materials.push_back(m_book.seam(fabricShown(m_design, line.patch, colourway)));
        join(std::move(mesh));
    }
}

/// What lies inside of the cover is not seen, and often most of it: frames are modelled with their foam.
void CoverModeller::addFrames()
{
    const TriangleTree cover = coverTree(*m_subject.surface, m_stop);
    const auto hidden = [&](const Vec3f& p) { return cover.windingNumber(p.cast<double>()) > 0.5; };
    for (const Scene::FrameLook& frame : framesForPicture(m_design, m_subject.files, m_subject.surface.get())) {
        if (!frame.skin)
            continue;
        ModelMesh mesh = frameMesh(*frame.skin, hidden);
        mesh.name = frame.name.empty() ? "Frame" : frame.name;
        mesh.materials.assign(m_colourways.size(), m_book.frame(frame.material));
        join(std::move(mesh));
    }
}

CoverModel CoverModeller::make(bool frames)
{
    for (const SurfaceTopology::PatchRange& range : m_cover->topology->coarse->patches)
        if (!m_stop.stop_requested())
            addPatch(range);
    addTrims();
    addSeams();
    if (frames && !m_stop.stop_requested())
        addFrames();
    for (const ModelMesh& mesh : m_model.meshes)
        for (const Vec3f& p : mesh.points)
            m_model.box.extend(p);
    m_model.front = frontAzimuth(m_subject.surface->positions);
    m_model.materials = m_book.takeMaterials();
    m_model.pictures = m_book.takePictures();
    return std::move(m_model);
}

} // namespace

CoverModel makeCoverModel(const ModelSubject& subject, bool frames, const PictureKind& pictures,
                          const std::stop_token& stop)
{
    return CoverModeller(subject, pictures, stop).make(frames);
}

} // namespace bolster
