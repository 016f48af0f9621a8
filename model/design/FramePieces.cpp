#include "FramePieces.h"

#include <algorithm>
#include <deque>
#include <mutex>
#include <numeric>
#include <set>
#include <tuple>

namespace bolster {

namespace {

constexpr std::size_t mostPieces = 200; // of a part

/// Points in the same place get the same number.
std::vector<std::uint32_t> placeNumbers(const std::vector<Vec3>& points)
{
    const auto place = [&](std::uint32_t i) { return std::tuple(points[i].x(), points[i].y(), points[i].z()); };
    std::vector<std::uint32_t> order(points.size()), number(points.size(), 0);
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool same = k > 0 && place(order[k - 1]) == place(order[k]);
        number[order[k]] = same ? number[order[k - 1]] : order[k];
    }
    return number;
}

/// What hangs together, by the smallest number of its places.
class Groups {
public:
    explicit Groups(std::size_t count)
        : m_parent(count)
    {
        std::iota(m_parent.begin(), m_parent.end(), 0U);
    }
    std::uint32_t root(std::uint32_t i)
    {
        while (m_parent[i] != i)
            i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b)
    {
        a = root(a);
        b = root(b);
        m_parent[std::max(a, b)] = std::min(a, b);
    }
    void separate(std::uint32_t i) { m_parent[i] = i; }

private:
    std::vector<std::uint32_t> m_parent;
};

/// The pieces of one part after another.
class PieceFinder {
public:
    explicit PieceFinder(const TriangleMesh& mesh)
        : m_mesh(mesh)
        , m_place(placeNumbers(mesh.points))
        , m_groups(mesh.points.size())
        , m_pieceOf(mesh.points.size(), 0)
    {
        m_result.ofTriangle.assign(mesh.triangles.size(), 0);
    }

    FramePieces run()
    {
        for (std::uint32_t part = 0; part < m_mesh.parts.size(); ++part)
            addPart(part);
        return std::move(m_result);
    }

private:
    void addPart(std::uint32_t part)
    {
        const auto [name, first, count] = m_mesh.parts[part];
        for (std::uint32_t t = first; t < first + count; ++t) // parts may share points
            for (const std::uint32_t corner : m_mesh.triangles[t])
                m_groups.separate(m_place[corner]);
        for (std::uint32_t t = first; t < first + count; ++t) {
            const auto& [a, b, c] = m_mesh.triangles[t];
            m_groups.join(m_place[a], m_place[b]);
            m_groups.join(m_place[b], m_place[c]);
        }
        std::vector<FramePiece> pieces = boxes(part, first, count);
        std::vector<std::size_t> order(pieces.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
            return pieces[a].box.diagonal().norm() > pieces[b].box.diagonal().norm();
        });
        const auto start = static_cast<std::uint32_t>(m_result.pieces.size());
        std::vector<std::uint32_t> rank(pieces.size());
        for (std::size_t k = 0; k < order.size(); ++k) {
            const std::size_t place = std::min(k, mostPieces);
            rank[order[k]] = start + static_cast<std::uint32_t>(place);
            FramePiece& piece = pieces[order[k]];
            if (k > mostPieces) { // together with those before
                m_result.pieces.back().triangleCount += piece.triangleCount;
                m_result.pieces.back().box.extend(piece.box);
                continue;
            }
            piece.name = pieces.size() == 1 ? name : name + "#" + std::to_string(place + 1);
            m_result.pieces.push_back(std::move(piece));
        }
        for (std::uint32_t t = first; t < first + count; ++t)
            m_result.ofTriangle[t] = rank[m_pieceOf[rootOf(t)]];
    }

    std::uint32_t rootOf(std::uint32_t triangle) { return m_groups.root(m_place[m_mesh.triangles[triangle][0]]); }

    /// In the order of their first triangles; m_pieceOf says which one belongs to the root of a group.
    std::vector<FramePiece> boxes(std::uint32_t part, std::uint32_t first, std::uint32_t count)
    {
        std::vector<FramePiece> pieces;
        constexpr std::uint32_t none = UINT32_MAX;
        for (std::uint32_t t = first; t < first + count; ++t)
            m_pieceOf[rootOf(t)] = none;
        for (std::uint32_t t = first; t < first + count; ++t) {
            std::uint32_t& number = m_pieceOf[rootOf(t)];
            if (number == none) {
                number = static_cast<std::uint32_t>(pieces.size());
                pieces.push_back({{}, part, 0, {}});
            }
            ++pieces[number].triangleCount;
            for (const std::uint32_t corner : m_mesh.triangles[t])
                pieces[number].box.extend(m_mesh.points[corner]);
        }
        return pieces;
    }

    const TriangleMesh& m_mesh;
    std::vector<std::uint32_t> m_place;
    Groups m_groups;
    std::vector<std::uint32_t> m_pieceOf;
    FramePieces m_result;
};

TriangleMesh without(const TriangleMesh& mesh, const FramePieces& pieces, const std::vector<bool>& hidden)
{
    TriangleMesh shown;
    shown.points = mesh.points;
    for (const TriangleMesh::Part& part : mesh.parts) {
        const auto first = static_cast<std::uint32_t>(shown.triangles.size());
        for (std::uint32_t t = part.firstTriangle; t < part.firstTriangle + part.triangleCount; ++t)
            if (!hidden[pieces.ofTriangle[t]])
                shown.triangles.push_back(mesh.triangles[t]);
        const auto count = static_cast<std::uint32_t>(shown.triangles.size()) - first;
        if (count > 0)
            shown.parts.push_back({part.name, first, count});
    }
    std::vector<std::uint32_t> kept(mesh.points.size(), UINT32_MAX);
    shown.points.clear();
    for (auto& triangle : shown.triangles)
        for (std::uint32_t& corner : triangle) {
            if (kept[corner] == UINT32_MAX) {
                kept[corner] = static_cast<std::uint32_t>(shown.points.size());
                shown.points.push_back(mesh.points[corner]);
            }
            corner = kept[corner];
        }
    return shown;
}

/// What has been found of meshes that are still there. A value, once made, is the same for everybody.
class Found {
public:
    std::shared_ptr<const FramePieces> pieces(const FrameMeshPtr& mesh)
    {
        const std::scoped_lock lock(m_mutex);
        return entry(mesh).pieces;
    }

    FrameMeshPtr shown(const FrameMeshPtr& mesh, const std::vector<std::string>& names)
    {
        const std::scoped_lock lock(m_mutex);
        Entry& known = entry(mesh);
        const auto found = std::ranges::find(known.shown, names, &Shown::names);
        if (found != known.shown.end())
            return found->mesh;
        const std::vector<bool> hidden = known.pieces->hiddenBy(*mesh, names);
        const bool any = std::ranges::find(hidden, true) != hidden.end();
        constexpr std::size_t enough = 8; // frames of one file, and versions that are compared
        if (known.shown.size() == enough)
            known.shown.pop_front();
        known.shown.push_back(
            {names, any ? std::make_shared<const TriangleMesh>(without(*mesh, *known.pieces, hidden)) : mesh});
        const FrameMeshPtr result = known.shown.back().mesh;
        if (!any)
            known.shown.pop_back(); // would keep the mesh for ever
        return result;
    }

private:
    struct Shown {
        std::vector<std::string> names;
        FrameMeshPtr mesh;
    };
    struct Entry {
        std::weak_ptr<const TriangleMesh> mesh;
        std::shared_ptr<const FramePieces> pieces;
        std::deque<Shown> shown;
    };

    Entry& entry(const FrameMeshPtr& mesh)
    {
        std::erase_if(m_entries, [](const Entry& e) { return e.mesh.expired(); });
        const auto found = std::ranges::find_if(m_entries, [&](const Entry& e) { return e.mesh.lock() == mesh; });
        if (found != m_entries.end())
            return *found;
        m_entries.push_back({mesh, std::make_shared<const FramePieces>(framePieces(*mesh)), {}});
        return m_entries.back();
    }

    std::mutex m_mutex;
    std::vector<Entry> m_entries;
};

Found& found()
{
    static Found all;
    return all;
}

} // namespace

std::vector<bool> FramePieces::hiddenBy(const TriangleMesh& mesh, const std::vector<std::string>& names) const
{
    const std::set<std::string> hiding(names.begin(), names.end());
    std::vector<bool> hidden(pieces.size(), false);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        hidden[i] = hiding.contains(pieces[i].name) || hiding.contains(mesh.parts[pieces[i].part].name);
    return hidden;
}

std::vector<std::string> FramePieces::namesFor(const TriangleMesh& mesh, const std::vector<bool>& hidden,
                                               const std::vector<std::string>& before) const
{
    std::vector<std::string> names;
    for (std::size_t i = 0, end = 0; i < pieces.size(); i = end) {
        while (end < pieces.size() && pieces[end].part == pieces[i].part)
            ++end;
        const auto first = hidden.begin() + static_cast<std::ptrdiff_t>(i),
                   last = hidden.begin() + static_cast<std::ptrdiff_t>(end);
        if (std::find(first, last, false) == last)
            names.push_back(mesh.parts[pieces[i].part].name);
        else
            for (std::size_t k = i; k < end; ++k)
                if (hidden[k])
                    names.push_back(pieces[k].name);
    }
    for (std::string& name : unknown(mesh, before))
        names.push_back(std::move(name));
    return names;
}

std::vector<std::string> FramePieces::unknown(const TriangleMesh& mesh, const std::vector<std::string>& names) const
{
    std::set<std::string> known;
    for (const FramePiece& piece : pieces)
        known.insert({piece.name, mesh.parts[piece.part].name});
    std::vector<std::string> others;
    std::ranges::copy_if(names, std::back_inserter(others),
                         [&](const std::string& name) { return !known.contains(name); });
    return others;
}

FramePieces framePieces(const TriangleMesh& mesh)
{
    return PieceFinder(mesh).run();
}

std::shared_ptr<const FramePieces> piecesOf(const FrameMeshPtr& mesh)
{
    return found().pieces(mesh);
}

std::optional<int> FramePieces::ofShown(const TriangleMesh& mesh, const std::vector<bool>& hidden,
                                        std::uint32_t triangle) const
{
    for (const TriangleMesh::Part& part : mesh.parts)
        for (std::uint32_t t = part.firstTriangle; t < part.firstTriangle + part.triangleCount; ++t)
            if (!hidden[ofTriangle[t]] && triangle-- == 0)
                return static_cast<int>(ofTriangle[t]);
    return std::nullopt;
}

FrameMeshPtr shownMesh(const FrameMeshPtr& mesh, const std::vector<std::string>& hidden)
{
    return mesh && !hidden.empty() ? found().shown(mesh, hidden) : mesh;
}

} // namespace bolster
