#include "CushionGhosts.h"

#include "CushionVoxels.h"
#include "DrawField.h"
#include "FrameWarnings.h"
#include "GuessParts.h"
#include "SolveReport.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace bolster {

namespace {

// Weights of the rows gamma A_i / D^2: stiff enough to carry a cover, soft enough to let it move in few iterations.
constexpr double cushionGamma = 100;
constexpr double contactGamma = 1000;

} // namespace

CushionGhosts::CushionGhosts(ElementId element, double gamma, const Placement& frame, Fields fields,
                             std::vector<double> strengths)
    : m_element(element)
    , m_gamma(gamma)
    , m_frame(frame)
    , m_fields(std::move(fields))
    , m_strengths(std::move(strengths))
{
    m_frame.scale = 1;
    m_axes = m_frame.rotation.toRotationMatrix();
}

/// f_v, mm.
Vec3 CushionGhosts::push(const SheetMoment& sheet, const SewnMesh::Part& part, int vertex) const
{
    const ForceField::Push push =
        m_fields[part.component]->at(m_axes.transpose() * (sheet.position(vertex) - m_frame.position), m_strengths);
    if (push.depth == 0)
        return Vec3::Zero();
    const Vec3 normal = sheet.outside(part, vertex);
    return std::clamp(normal.dot(m_axes * push.force), 0.0, 2 * push.depth) * normal;
}

void CushionGhosts::displace(const SheetMoment& sheet, const SewnMesh::Part& part, int begin, int end,
                             Columns& displacements) const
{
    for (int v = begin; v < end; ++v) {
        displacements.col(v).setZero();
        displacements.col(v).head<3>() = 0.5 * push(sheet, part, v);
    }
}

void CushionGhosts::report(const SheetMoment& sheet, SolveReport& report) const
{
    SolveReport::Cushion cushion;
    cushion.element = m_element;
    const std::set<std::shared_ptr<const ForceField>> fields(m_fields.begin(), m_fields.end());
    for (const auto& field : fields)
        cushion.voxels += field ? static_cast<std::int64_t>(field->insideCount()) : 0;
    constexpr double touch = 1e-3; // mm
    for (const SewnMesh::Part& part : sheet.mesh.parts) {
        if (!m_fields[part.component])
            continue;
        for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v) {
            const double length = push(sheet, part, v).norm();
            if (length > touch)
                cushion.push.mean += (length - cushion.push.mean) / static_cast<double>(++cushion.vertices);
            cushion.push.max = std::max(cushion.push.max, length);
        }
    }
    report.cushions.push_back(cushion);
}

void CushionGhosts::draw(FieldPicture& picture) const
{
    const auto place = [this](const std::vector<FieldPicture::Segment>& from,
                              std::vector<FieldPicture::Segment>& to) {
        for (const auto& [a, b] : from)
            to.push_back(
                {m_frame.placed(a.cast<double>()).cast<float>(), m_frame.placed(b.cast<double>()).cast<float>()});
    };
    for (const auto& field : std::set<std::shared_ptr<const ForceField>>(m_fields.begin(), m_fields.end())) {
        if (!field)
            continue;
        const FieldPicture own = drawField(*field);
        place(own.contours, picture.contours);
        place(own.arrows, picture.arrows);
    }
}

namespace {

/// The foam of a cushion.
struct FoamList {
    std::vector<FrameFields::FoamKey> keys;
    std::vector<double> strengths;
};

/// In the frame's axes: moving foam and frame together changes nothing.
Placement relative(const Placement& placement, const Placement& frame)
{
    Placement result = placement;
    result.position = frame.rotation.conjugate() * (placement.position - frame.position);
    result.rotation = frame.rotation.conjugate() * placement.rotation;
    return result;
}

void addWarning(Problems& problems, ElementId id, const Design& design, std::string field, Message message)
{
    const Problem problem{id, elementLabel(id, *design.element(id)), std::move(field), std::move(message),
                          Severity::Warning};
    if (std::find(problems.begin(), problems.end(), problem) == problems.end())
        problems.push_back(problem);
}

/// What the fields of all components together lack.
class FieldWarnings {
public:
    void met(const ForceField& field, const std::vector<int>& thin)
    {
        m_met = true;
        m_any = m_any || field.insideCount() > 0;
        m_thin.insert(thin.begin(), thin.end());
    }

    /// Nothing when there is nothing to say.
    std::optional<Message> message(VoxelUser user, const TriangleMesh& mesh, double edge) const
    {
        if (!m_met)
            return Message{
                QT_TRANSLATE_NOOP("Message", "it pushes nothing: no part of the frame lies under the cover")};
        if (!m_any)
            return noVoxelsMessage(user, edge);
        if (m_thin.empty())
            return std::nullopt;
        return thinPartsMessage(user, mesh, {m_thin.begin(), m_thin.end()}, edge);
    }

private:
    bool m_met = false; ///< a field
    bool m_any = false; ///< voxel inside
    std::set<int> m_thin;
};

class CushionMaker {
public:
    CushionMaker(const SolveInput& input, const SewnMesh& mesh, FrameFields& fields, WorkerPool& pool,
                 const std::stop_token& stop, Problems& problems)
        : m_input(input)
        , m_mesh(mesh)
        , m_fields(fields)
        , m_pool(pool)
        , m_stop(stop)
        , m_problems(problems)
    {}

    /// Null when it pushes nothing.
    std::unique_ptr<GhostSource> make(ElementId id, const Cushion& cushion)
    {
        const Frame& frame = *m_input.design.find<Frame>(cushion.frame);
        const TriangleMeshPtr mesh = meshOfFrame(m_input, cushion.frame);
        const FoamList foam = foamOf(id, cushion, frame);
        if (!mesh || *std::max_element(foam.strengths.begin(), foam.strengths.end()) == 0)
            return nullptr;
        const std::vector<std::vector<int>> parts = partsOf(id, cushion, frame, mesh);
        CushionGhosts::Fields fields(m_mesh.diameter.size());
        FieldWarnings warnings;
        for (const int component : componentsOf(cushion)) {
            if (parts[component].empty() && foam.keys.empty())
                continue;
            const FrameFields::CushionKey key{{{mesh, frame.scale}, parts[component], cushion.voxel},
                                              cushion.dilation,
                                              cushion.distance,
                                              foam.keys};
            if (isTooLarge(id, key))
                return nullptr;
            fields[component] = m_fields.cushion(key, m_pool, m_stop);
            if (fields[component])
                warnings.met(*fields[component], m_fields.thinParts(key.frame, m_pool, m_stop));
        }
        if (m_stop.stop_requested())
            return nullptr;
        if (auto message = warnings.message(VoxelUser::Cushion, *mesh, cushion.voxel))
            warn(id, "voxel_mm", std::move(*message));
        return std::make_unique<CushionGhosts>(id, cushionGamma, frame, std::move(fields), foam.strengths);
    }

private:
    FoamList foamOf(ElementId id, const Cushion& cushion, const Frame& frame)
    {
        FoamList list{{}, {cushion.strength}};
        m_input.design.each<Foam>([&](ElementId foamId, const Foam& foam) {
            const auto file = m_input.files.meshes.find(foamId);
            const bool known = foam.shape == Foam::Shape::Mesh && file != m_input.files.meshes.end();
            const TriangleMeshPtr mesh = known ? file->second : nullptr;
            if (foam.cushion != id || (foam.shape == Foam::Shape::Mesh && !mesh))
                return;
            constexpr std::size_t most = 255; // an owner is a byte
            if (list.keys.size() == most) {
                warn(foamId, "cushion",
                     {QT_TRANSLATE_NOOP("Message",
                                        "a cushion takes at most %1 bodies of foam; this one is left out"),
                      {std::to_string(most)}});
                return;
            }
            list.keys.push_back({foam.shape, foam.size, mesh, relative(foam, frame), foam.dilation, foam.cut});
            list.strengths.push_back(foam.cut ? 0 : foam.strength);
        });
        return list;
    }

    /// The parts under each component.
    std::vector<std::vector<int>> partsOf(ElementId id, const Cushion& cushion, const Frame& frame,
                                          const TriangleMeshPtr& mesh)
    {
        if (cushion.parts.empty())
            return guessParts(*m_fields.parts({mesh, frame.scale}, m_stop), frame, m_mesh, m_stop);
        std::vector<int> parts;
        for (const std::string& name : cushion.parts) {
            const std::size_t before = parts.size();
            for (int p = 0; p < std::ssize(mesh->parts); ++p)
                if (mesh->parts[p].name == name)
                    parts.push_back(p);
            if (parts.size() == before)
                warn(id, "parts",
                     {QT_TRANSLATE_NOOP("Message", "the frame has no part \"%1\"; it has %2"),
                      {name, partNames(*mesh)}});
        }
        std::sort(parts.begin(), parts.end());
        parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
        return std::vector<std::vector<int>>(m_mesh.diameter.size(), parts);
    }

    std::set<int> componentsOf(const Cushion& cushion) const
    {
        std::set<int> components;
        for (const SewnMesh::Part& part : m_mesh.parts)
            if (cushion.patches.empty() ||
                std::find(cushion.patches.begin(), cushion.patches.end(), part.patch) != cushion.patches.end())
                components.insert(part.component);
        return components;
    }

    bool isTooLarge(ElementId id, const FrameFields::CushionKey& key)
    {
        const double count = m_fields.voxelCount(key, m_stop);
        if (count <= mostVoxels)
            return false;
        const double enough = key.frame.edge * std::cbrt(count / mostVoxels);
        warn(id, "voxel_mm",
             {QT_TRANSLATE_NOOP("Message",
                                "a smallest detail of %1 mm is too fine for a frame as large as this (%2 million "
                                "cubes of it, and %3 are the limit), so the cushion is left out; take at least "
                                "%4 mm"),
              {numberText(key.frame.edge), numberText(count / 1e6, 3), numberText(mostVoxels / 1e6, 3),
               numberText(std::ceil(enough * 10) / 10)}});
        return true;
    }

    void warn(ElementId id, std::string field, Message message)
    {
        addWarning(m_problems, id, m_input.design, std::move(field), std::move(message));
    }

    const SolveInput& m_input;
    const SewnMesh& m_mesh;
    FrameFields& m_fields;
    WorkerPool& m_pool;
    const std::stop_token& m_stop;
    Problems& m_problems;
};

} // namespace

void addCushionGhosts(const SolveInput& input, const SewnMesh& mesh, FrameFields& fields, WorkerPool& pool,
                      const std::stop_token& stop, Ghosts& ghosts, Problems& problems)
{
    CushionMaker maker(input, mesh, fields, pool, stop, problems);
    addTooManyCushions(input, problems);
    int count = 0;
    input.design.each<Cushion>([&](ElementId id, const Cushion& cushion) {
        if (!cushion.enabled || ++count > mostCushions || stop.stop_requested())
            return;
        if (auto source = maker.make(id, cushion))
            ghosts.push_back(std::move(source));
    });
}

void addContactGhosts(const SolveInput& input, const SewnMesh& mesh, FrameFields& fields, WorkerPool& pool,
                      const std::stop_token& stop, Ghosts& ghosts, Problems& problems)
{
    input.design.each<Frame>([&](ElementId id, const Frame& frame) {
        const TriangleMeshPtr triangles = meshOfFrame(input, id);
        if (!frame.contact || !triangles || stop.stop_requested())
            return;
        const FrameFields::Shape shape{triangles, frame.scale};
        CushionGhosts::Fields ofComponents;
        FieldWarnings warnings;
        double edge = 0;
        for (const std::vector<int>& parts : guessParts(*fields.parts(shape, stop), frame, mesh, stop)) {
            const FrameFields::ContactKey key{shape, parts, frame.contactGap};
            ofComponents.push_back(parts.empty() ? nullptr : fields.contact(key, pool, stop));
            if (!ofComponents.back())
                continue;
            edge = std::max(edge, fields.edgeOf(key, stop));
            warnings.met(*ofComponents.back(), fields.thinParts(key, pool, stop));
        }
        if (stop.stop_requested())
            return;
        if (auto message = warnings.message(VoxelUser::Contact, *triangles, edge))
            addWarning(problems, id, input.design, "contact", std::move(*message));
        constexpr double wholeWay = 2; // the target is p + f / 2
        ghosts.push_back(std::make_unique<CushionGhosts>(id, contactGamma, frame, std::move(ofComponents),
                                                         std::vector<double>{wholeWay}));
    });
}

} // namespace bolster
