#include "SeamTrims.h"

#include "FabricShown.h"
#include "TrimRows.h"
#include "TrimShapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bolster {

namespace {

constexpr double shownPart = 0.82; // of a stitch; the rest is the hole
constexpr float sunk = 0.45F;      // of a pipe's radius, between the two sides of its seam

/// Trims and what they lie on.
std::vector<ElementPtr> concerned(const Design& design)
{
    std::vector<ElementPtr> elements;
    bool any = false;
    for (const auto& [id, element] : design.elements()) {
        const SeamTrim* trim = seamTrim(*element);
        const bool trimmed = trim && trim->hasTrimmings();
        any = any || trimmed;
        if (trimmed || std::holds_alternative<Patch>(*element))
            elements.push_back(element);
    }
    return any ? elements : std::vector<ElementPtr>();
}

/// Points of a row by their length.
class RowLength {
public:
    explicit RowLength(const TrimRow& row)
        : m_row(row)
        , m_at{0}
    {
        for (std::size_t i = 1; i < row.points.size() + (row.closed ? 1 : 0); ++i)
            m_at.push_back(m_at.back() + (point(i) - point(i - 1)).norm());
    }

    double total() const { return m_at.back(); }
    Vec2 at(double length) const
    {
        const auto next = std::upper_bound(m_at.begin() + 1, m_at.end() - 1, length);
        const auto i = static_cast<std::size_t>(next - m_at.begin());
        const double span = m_at[i] - m_at[i - 1];
        const double share = span > 0 ? (length - m_at[i - 1]) / span : 0;
        return point(i - 1) + share * (point(i) - point(i - 1));
    }

private:
    const Vec2& point(std::size_t i) const { return m_row.points[i % m_row.points.size()]; }

    const TrimRow& m_row;
    std::vector<double> m_at;
};

/// Of the two sides of a seam; the first where they turn their backs to each other.
Eigen::Vector3f between(const Eigen::Vector3f& a, const Eigen::Vector3f& b)
{
    const Eigen::Vector3f sum = a + b;
    return sum.norm() > 0.1F ? Eigen::Vector3f(sum.normalized()) : a;
}

void beginPart(ElementId element, TrimMesh& mesh)
{
    TrimMesh::Part part;
    part.element = element;
    part.firstTriangle = static_cast<std::uint32_t>(mesh.triangles.size());
    mesh.parts.push_back(part);
}

void endPart(TrimMesh& mesh)
{
    TrimMesh::Part& part = mesh.parts.back();
    part.triangleCount = static_cast<std::uint32_t>(mesh.triangles.size()) - part.firstTriangle;
    if (part.triangleCount == 0)
        mesh.parts.pop_back();
}

} // namespace

bool SeamTrims::prepared(const Design& design, const CoverMesh& cover) const
{
    return m_places && m_places->cover() == cover.topology && m_of == concerned(design);
}

bool SeamTrims::any(const Design& design)
{
    return !concerned(design).empty();
}

void SeamTrims::prepare(const Design& design, const CoverMesh& cover, const std::stop_token& stop)
{
    m_of = concerned(design);
    m_rows.clear();
    m_pipes.clear();
    if (m_of.empty())
        return;
    if (!m_places || m_places->cover() != cover.topology)
        m_places.emplace(cover.topology);
    for (const auto& [id, element] : design.elements()) {
        if (stop.stop_requested()) {
            m_places.reset(); // what is there is not all
            return;
        }
        addRows(design, id, *element);
        addPipe(design, id, *element);
    }
}

void SeamTrims::addRows(const Design& design, ElementId id, const Element& element)
{
    for (const TrimRow& row : stitchRows(design, element)) {
        if (!m_places->has(row.patch))
            continue;
        const RowLength length(row);
        const double stitch = seamTrim(element)->stitchLength;
        const int count = std::max(1, static_cast<int>(std::lround(length.total() / stitch)));
        const double pitch = length.total() / count;
        Row& places = m_rows.emplace_back(Row{id, row.patch, {}});
        for (int s = 0; s < count; ++s)
            for (int i = 0; i < stitchPoints; ++i) {
                const double inStitch = 0.5 + shownPart * (static_cast<double>(i) / (stitchPoints - 1) - 0.5);
                places.places.push_back(m_places->locate(row.patch, length.at((s + inStitch) * pitch)));
            }
    }
}

void SeamTrims::addPipe(const Design& design, ElementId id, const Element& element)
{
    const std::vector<TrimRow> rows = pipingRows(design, element);
    if (rows.empty())
        return;
    Pipe pipe{id, rows.front().patch, rows.size() > 1 ? rows.back().patch : noElement, rows.front().closed, {}, {}};
    for (std::size_t r = 0; r < rows.size(); ++r) {
        if (!m_places->has(rows[r].patch))
            return;
        for (const Vec2& p : rows[r].points)
            (r == 0 ? pipe.places : pipe.otherSide).push_back(m_places->locate(rows[r].patch, p));
    }
    if (!pipe.places.empty())
        m_pipes.push_back(std::move(pipe));
}

void SeamTrims::skinRow(const Design& design, const CoverMesh& cover, const Row& row, TrimMesh& to) const
{
    const SeamTrim& trim = *seamTrim(*design.element(row.element));
    beginPart(row.element, to);
    to.parts.back().color = trim.thread;
    to.parts.back().patch = row.patch;
    for (std::size_t i = 0; i < row.places.size(); i += stitchPoints) {
        std::array<CoverPoint3, stitchPoints> on;
        for (std::size_t k = 0; k < stitchPoints; ++k)
            on[k] = coverPoint(cover, row.places[i + k]);
        bolster::addStitch(on, static_cast<float>(trim.threadWidth), to);
    }
    endPart(to);
}

void SeamTrims::skinPipe(const Design& design, const CoverMesh& cover, const Pipe& pipe, TrimMesh& to) const
{
    const SeamTrim& trim = *seamTrim(*design.element(pipe.element));
    const auto radius = static_cast<float>(trim.pipingRadius);
    std::vector<CoverPoint3> along;
    for (std::size_t i = 0; i < pipe.places.size(); ++i) {
        CoverPoint3 at = coverPoint(cover, pipe.places[i]);
        if (i < pipe.otherSide.size())
            at.normal = between(at.normal, coverPoint(cover, pipe.otherSide[i]).normal);
        at.point += (1 - sunk) * radius * at.normal;
        along.push_back(at);
    }
    beginPart(pipe.element, to);
    TrimMesh::Part& part = to.parts.back();
    part.patch = pipe.patch;
    part.other = pipe.other;
    part.fabric = trim.pipingFabric != noElement ? trim.pipingFabric : fabricShown(design, pipe.patch);
    if (const Fabric* fabric = design.find<Fabric>(part.fabric))
        part.color = fabric->color;
    bolster::addPipe(along, pipe.closed, radius, to);
    endPart(to);
}

TrimMeshPtr SeamTrims::make(const Design& design, const CoverMesh& cover, const std::stop_token& stop)
{
    if (!prepared(design, cover))
        prepare(design, cover, stop);
    if (stop.stop_requested() || (m_rows.empty() && m_pipes.empty()))
        return nullptr;
    auto mesh = std::make_shared<TrimMesh>();
    for (const Row& row : m_rows)
        skinRow(design, cover, row, *mesh);
    for (const Pipe& pipe : m_pipes)
        skinPipe(design, cover, pipe, *mesh);
    return mesh;
}

} // namespace bolster
