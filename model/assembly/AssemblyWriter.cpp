#include "AssemblyWriter.h"

#include "AssemblyRecord.h"

#include <algorithm>

namespace bolster {
namespace {

constexpr std::size_t pointsAtOnce = 32'000; // 768 KB
constexpr std::size_t trianglesAtOnce = 64'000;
static_assert(pointsAtOnce * sizeof(Vec3) + 8 <= largestAssemblyRecord);

template <class Value>
std::string_view rawBytes(const Value& value)
{
    return {reinterpret_cast<const char*>(&value), sizeof value};
}

template <class Value>
std::string_view rowBytes(std::span<const Value> values)
{
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

std::string_view shortened(std::string_view text)
{
    return text.substr(0, longestPartName);
}

} // namespace

AssemblyWriter::AssemblyWriter(Sink sink)
    : m_sink(std::move(sink))
{
    m_sink(rawBytes(assemblyMark));
}

void AssemblyWriter::record(std::uint32_t kind, std::span<const std::string_view> pieces)
{
    AssemblyRecordHead head{kind, 0};
    for (const std::string_view piece : pieces)
        head.size += static_cast<std::uint32_t>(piece.size());
    std::string bytes(rawBytes(head));
    for (const std::string_view piece : pieces)
        bytes += piece;
    m_sink(bytes);
}

void AssemblyWriter::facts(const FileFacts& facts)
{
    const double unit = facts.millimetresPerUnit.value_or(0);
    const std::uint32_t up = facts.up ? static_cast<std::uint32_t>(*facts.up) + 1 : 0;
    const std::string_view pieces[] = {rawBytes(unit), rawBytes(up)};
    record(static_cast<std::uint32_t>(AssemblyRecord::Facts), pieces);
}

std::uint32_t AssemblyWriter::addPart(std::string_view name, std::optional<std::uint32_t> parent,
                                      std::optional<std::uint32_t> color)
{
    if (m_parts >= mostAssemblyParts)
        throw AssemblyRefused{AssemblyVerdict::TooManyParts};
    const std::uint32_t above = parent ? *parent + 1 : 0;
    const std::uint32_t shown = color.value_or(noColor);
    const std::string_view pieces[] = {rawBytes(above), rawBytes(shown), shortened(name)};
    record(static_cast<std::uint32_t>(AssemblyRecord::Part), pieces);
    return static_cast<std::uint32_t>(m_parts++);
}

void AssemblyWriter::addPoints(std::uint32_t part, std::span<const Vec3> points)
{
    m_points += points.size();
    if (m_points > mostAssemblyPoints)
        throw AssemblyRefused{AssemblyVerdict::TooLarge};
    while (!points.empty()) {
        const auto some = points.first(std::min(points.size(), pointsAtOnce));
        const std::string_view pieces[] = {rawBytes(part), rowBytes(some)};
        record(static_cast<std::uint32_t>(AssemblyRecord::Points), pieces);
        points = points.subspan(some.size());
    }
}

void AssemblyWriter::addMesh(std::uint32_t part, const TriangleMesh& mesh)
{
    m_triangles += mesh.triangles.size();
    if (m_triangles > mostAssemblyTriangles)
        throw AssemblyRefused{AssemblyVerdict::TooLarge};
    addPoints(part, mesh.points);
    std::span<const std::array<std::uint32_t, 3>> triangles = mesh.triangles;
    while (!triangles.empty()) {
        const auto some = triangles.first(std::min(triangles.size(), trianglesAtOnce));
        const std::string_view pieces[] = {rawBytes(part), rowBytes(some)};
        record(static_cast<std::uint32_t>(AssemblyRecord::Triangles), pieces);
        triangles = triangles.subspan(some.size());
    }
}

void AssemblyWriter::addEdge(std::uint32_t part, Assembly::Edge::Kind kind, std::span<const Vec3> points)
{
    if (points.size() < 2 || points.size() > pointsAtOnce)
        return;
    m_edgePoints += points.size();
    if (m_edgePoints > mostAssemblyPoints)
        throw AssemblyRefused{AssemblyVerdict::TooLarge};
    const auto number = static_cast<std::uint32_t>(kind);
    const std::string_view pieces[] = {rawBytes(part), rawBytes(number), rowBytes(points)};
    record(static_cast<std::uint32_t>(AssemblyRecord::Edge), pieces);
}

void AssemblyWriter::warn(AssemblyOddity oddity, std::uint64_t count, std::string_view text)
{
    const auto number = static_cast<std::uint32_t>(oddity);
    const auto times = static_cast<double>(count);
    const std::string_view pieces[] = {rawBytes(number), rawBytes(times), shortened(text)};
    record(static_cast<std::uint32_t>(AssemblyRecord::Warning), pieces);
}

/// In steps of a hundredth: whoever listens has more to do.
void AssemblyWriter::progress(double done)
{
    if (!(done >= m_progress + 0.01 && done <= 1))
        return;
    m_progress = done;
    const std::string_view pieces[] = {rawBytes(done)};
    record(static_cast<std::uint32_t>(AssemblyRecord::Progress), pieces);
}

void AssemblyWriter::end(AssemblyVerdict verdict, std::string_view text)
{
    const auto number = static_cast<std::uint32_t>(verdict);
    const std::string_view pieces[] = {rawBytes(number), shortened(text)};
    record(static_cast<std::uint32_t>(AssemblyRecord::End), pieces);
}

} // namespace bolster
