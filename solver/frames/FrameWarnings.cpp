#include "FrameWarnings.h"

#include "FramePieces.h"
#include "Voxelise.h"

#include <algorithm>
#include <numeric>

namespace bolster {

namespace {

constexpr std::size_t enoughNames = 10;

std::string listed(std::string list, const std::string& name)
{
    return list.append(list.empty() ? "" : ", ").append("\"").append(name).append("\"");
}

/// Looks at frames with the voxels that a cushion or the contact would have.
class FrameCheck {
public:
    explicit FrameCheck(const SolveInput& input)
        : m_input(input)
    {}

    Problems run()
    {
        addUnknownParts(m_input, m_problems);
        addTooManyCushions(m_input, m_problems);
        int count = 0;
        m_input.design.each<Cushion>([&](ElementId id, const Cushion& cushion) {
            if (!cushion.enabled || ++count > mostCushions)
                return;
            const auto* frame = m_input.design.find<Frame>(cushion.frame);
            const TriangleMeshPtr mesh = meshOfFrame(m_input, cushion.frame);
            if (frame && mesh)
                look(id, VoxelUser::Cushion, *mesh,
                     FrameFields::SolidKey{{mesh, frame->scale}, named(cushion, *mesh), cushion.voxel});
        });
        m_input.design.each<Frame>([&](ElementId id, const Frame& frame) {
            const TriangleMeshPtr mesh = meshOfFrame(m_input, id);
            if (!frame.contact || !mesh)
                return;
            const FrameFields::ContactKey key{{mesh, frame.scale}, named({}, *mesh), frame.contactGap};
            look(id, VoxelUser::Contact, *mesh, {key.shape, key.parts, m_fields.edgeOf(key)});
        });
        return std::move(m_problems);
    }

private:
    /// Those that the cushion names, or all.
    static std::vector<int> named(const Cushion& cushion, const TriangleMesh& mesh)
    {
        std::vector<int> parts;
        for (int p = 0; p < std::ssize(mesh.parts); ++p)
            if (cushion.parts.empty() ||
                std::ranges::find(cushion.parts, mesh.parts[p].name) != cushion.parts.end())
                parts.push_back(p);
        return parts;
    }

    void look(ElementId id, VoxelUser user, const TriangleMesh& mesh, const FrameFields::SolidKey& key)
    {
        if (!(key.edge > 0))
            return;
        const auto all = m_fields.parts(key.shape);
        std::vector<int> thin;
        bool something = key.parts.empty();
        for (const int part : key.parts)
            for (const FrameBody& body : (*all)[part]) {
                // A closed body that is not thin has an inside; of others it is looked for.
                const bool thick = body.thickness && *body.thickness >= key.edge;
                const std::optional<bool> found = thick ? std::optional(true) : hasInside(body, key.edge, m_looks);
                something = something || found != false;
                if (isThin(body, key.edge, found) && (thin.empty() || thin.back() != part))
                    thin.push_back(part);
            }
        if (!something)
            add(id, user, noVoxelsMessage(user, key.edge));
        else if (!thin.empty())
            add(id, user, thinPartsMessage(user, mesh, thin, key.edge));
    }

    void add(ElementId id, VoxelUser user, Message message)
    {
        m_problems.push_back({id, elementLabel(id, *m_input.design.element(id)),
                              user == VoxelUser::Cushion ? "voxel_mm" : "contact", std::move(message),
                              Severity::Warning});
    }

    const SolveInput& m_input;
    FrameFields m_fields;
    int m_looks = 200'000; ///< at voxels that are left: a second or so for all frames together
    Problems m_problems;
};

} // namespace

std::string partNames(const TriangleMesh& mesh, const std::vector<int>& chosen)
{
    std::string list;
    for (std::size_t k = 0; k < std::min(enoughNames, chosen.size()); ++k)
        list = listed(std::move(list), mesh.parts[chosen[k]].name);
    return chosen.size() > enoughNames ? list + " \u2026" : list;
}

std::string partNames(const TriangleMesh& mesh)
{
    std::vector<int> all(mesh.parts.size());
    std::iota(all.begin(), all.end(), 0);
    return partNames(mesh, all);
}

Message thinPartsMessage(VoxelUser user, const TriangleMesh& mesh, const std::vector<int>& thin, double edge)
{
    return {user == VoxelUser::Cushion
                ? QT_TRANSLATE_NOOP("Message",
                                    "something of these parts of the frame is thinner than the smallest detail of "
                                    "the padding, %1 mm, so that it may have gaps there: %2; take a smaller detail")
                : QT_TRANSLATE_NOOP(
                      "Message",
                      "contact looks at the frame in steps of %1 mm; something of these parts is thinner, "
                      "so that the cover may pass through: %2; make it thicker"),
            {numberText(edge, 3), partNames(mesh, thin)}};
}

Message noVoxelsMessage(VoxelUser user, double edge)
{
    return {
        user == VoxelUser::Cushion
            ? QT_TRANSLATE_NOOP(
                  "Message",
                  "it pushes nothing: with a smallest detail of %1 mm there is no inside of the frame, which is "
                  "thinner than that, or so open that it has none; take a smaller detail, "
                  "or close the frame")
            : QT_TRANSLATE_NOOP("Message",
                                "contact does nothing: in steps of %1 mm it finds no inside of the frame, which is "
                                "thinner than that, or so open that it has none; close the frame, or make it "
                                "thicker"),
        {numberText(edge, 3)}};
}

TriangleMeshPtr meshOfFrame(const SolveInput& input, ElementId frame)
{
    const auto found = input.files.meshes.find(frame);
    const Frame* element = input.design.find<Frame>(frame);
    return found == input.files.meshes.end() || !element ? nullptr : shownMesh(found->second, element->hiddenParts);
}

void addUnknownParts(const SolveInput& input, Problems& problems)
{
    input.design.each<Frame>([&](ElementId id, const Frame& frame) {
        const auto found = input.files.meshes.find(id);
        if (frame.hiddenParts.empty() || found == input.files.meshes.end() || !found->second)
            return;
        const TriangleMesh& mesh = *found->second;
        for (const std::string& name : piecesOf(found->second)->unknown(mesh, frame.hiddenParts))
            problems.push_back(
                {id,
                 elementLabel(id, *input.design.element(id)),
                 "hidden_parts",
                 {QT_TRANSLATE_NOOP("Message", "the frame has no part \"%1\"; it has %2"), {name, partNames(mesh)}},
                 Severity::Warning});
    });
}

void addTooManyCushions(const SolveInput& input, Problems& problems)
{
    int count = 0;
    input.design.each<Cushion>([&](ElementId id, const Cushion& cushion) {
        if (cushion.enabled && ++count == mostCushions + 1)
            problems.push_back(
                {id,
                 elementLabel(id, *input.design.element(id)),
                 "enabled",
                 {QT_TRANSLATE_NOOP("Message",
                                    "at most %1 cushions push; this one and those after it are left out"),
                  {std::to_string(mostCushions)}},
                 Severity::Warning});
    });
}

Problems checkFrames(const SolveInput& input)
{
    return FrameCheck(input).run();
}

} // namespace bolster
