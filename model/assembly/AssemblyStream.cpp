#include "AssemblyStream.h"

#include "AssemblyRecord.h"

#include <algorithm>
#include <cstring>

namespace bolster {
namespace {

constexpr std::size_t mostWarnings = 50;

/// From the beginning of the bytes, which it leaves.
template <class Value>
bool taken(std::string_view& bytes, Value& value)
{
    if (bytes.size() < sizeof value)
        return false;
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes.remove_prefix(sizeof value);
    return true;
}

/// All that is left, if it is a whole number of them.
template <class Value>
bool allTaken(std::string_view bytes, std::vector<Value>& values)
{
    if (bytes.size() % sizeof(Value) != 0)
        return false;
    const std::size_t before = values.size();
    values.resize(before + bytes.size() / sizeof(Value));
    if (!bytes.empty())
        std::memcpy(static_cast<void*>(values.data() + before), bytes.data(), bytes.size());
    return true;
}

bool areNear(const std::vector<Vec3>& points, std::size_t from)
{
    for (std::size_t i = from; i < points.size(); ++i)
        if (!(points[i].array().abs() <= farthestAssemblyPoint).all()) // so that NaN is none, too
            return false;
    return true;
}

} // namespace

AssemblyStream::State AssemblyStream::take(std::string_view bytes)
{
    m_bytes += bytes;
    std::string_view left = m_bytes;
    std::uint32_t mark = 0;
    if (m_state == State::Unfinished && !m_begun && left.size() >= sizeof mark) {
        m_begun = taken(left, mark) && mark == assemblyMark;
        m_state = m_begun ? State::Unfinished : State::Broken;
    }
    while (m_state == State::Unfinished && m_begun) {
        std::string_view record = left;
        AssemblyRecordHead head;
        if (!taken(record, head))
            break;
        if (head.size > largestAssemblyRecord)
            m_state = State::Broken;
        else if (record.size() < head.size)
            break;
        else if (!takeRecord(head.kind, record.substr(0, head.size)))
            m_state = State::Broken;
        else
            left = record.substr(head.size);
    }
    m_bytes.erase(0, m_bytes.size() - left.size());
    if (m_state != State::Unfinished)
        m_bytes.clear(); // what follows an end is not looked at
    if (m_state == State::Broken)
        m_assembly = {};
    return m_state;
}

bool AssemblyStream::takeRecord(std::uint32_t kind, std::string_view bytes)
{
    switch (static_cast<AssemblyRecord>(kind)) {
    case AssemblyRecord::Facts:
        return takeFacts(bytes);
    case AssemblyRecord::Part:
        return takePart(bytes);
    case AssemblyRecord::Points:
        return takePoints(bytes);
    case AssemblyRecord::Triangles:
        return takeTriangles(bytes);
    case AssemblyRecord::Edge:
        return takeEdge(bytes);
    case AssemblyRecord::Warning:
        return takeWarning(bytes);
    case AssemblyRecord::Progress:
        return takeProgress(bytes);
    case AssemblyRecord::End:
        return takeEnd(bytes);
    }
    return false;
}

bool AssemblyStream::takeFacts(std::string_view bytes)
{
    double unit = 0;
    std::uint32_t up = 0;
    if (!taken(bytes, unit) || !taken(bytes, up) || !bytes.empty() || !(unit >= 0 && unit <= 1e9) ||
        up > static_cast<std::uint32_t>(UpAxis::X) + 1)
        return false;
    m_assembly.said = {};
    if (unit > 0)
        m_assembly.said.millimetresPerUnit = unit;
    if (up > 0)
        m_assembly.said.up = static_cast<UpAxis>(up - 1);
    return true;
}

bool AssemblyStream::takePart(std::string_view bytes)
{
    std::uint32_t above = 0, color = 0;
    std::vector<Assembly::Part>& parts = m_assembly.parts;
    if (!taken(bytes, above) || !taken(bytes, color) || above > parts.size() || bytes.size() > longestPartName ||
        parts.size() >= mostAssemblyParts || (color != noColor && color > 0xFFFFFF))
        return false;
    Assembly::Part& part = parts.emplace_back();
    part.name = bytes;
    if (above > 0)
        part.parent = above - 1;
    if (color != noColor)
        part.color = color;
    return true;
}

bool AssemblyStream::takePoints(std::string_view bytes)
{
    std::uint32_t part = 0;
    if (!taken(bytes, part) || part >= m_assembly.parts.size())
        return false;
    m_points += bytes.size() / sizeof(Vec3);
    std::vector<Vec3>& points = m_assembly.parts[part].points;
    const std::size_t before = points.size();
    return m_points <= mostAssemblyPoints && allTaken(bytes, points) && areNear(points, before);
}

bool AssemblyStream::takeTriangles(std::string_view bytes)
{
    std::uint32_t number = 0;
    if (!taken(bytes, number) || number >= m_assembly.parts.size())
        return false;
    Assembly::Part& part = m_assembly.parts[number];
    const std::size_t before = part.triangles.size();
    m_triangles += bytes.size() / sizeof part.triangles[0];
    if (m_triangles > mostAssemblyTriangles || !allTaken(bytes, part.triangles))
        return false;
    for (std::size_t i = before; i < part.triangles.size(); ++i)
        for (const std::uint32_t point : part.triangles[i])
            if (point >= part.points.size())
                return false;
    return true;
}

bool AssemblyStream::takeEdge(std::string_view bytes)
{
    std::uint32_t part = 0, kind = 0;
    if (!taken(bytes, part) || !taken(bytes, kind) || part >= m_assembly.parts.size() ||
        kind > static_cast<std::uint32_t>(Assembly::Edge::Kind::Spline))
        return false;
    m_edgePoints += bytes.size() / sizeof(Vec3);
    Assembly::Edge edge{part, static_cast<Assembly::Edge::Kind>(kind), {}};
    if (m_edgePoints > mostAssemblyPoints || !allTaken(bytes, edge.points) || edge.points.size() < 2 ||
        !areNear(edge.points, 0))
        return false;
    m_assembly.edges.push_back(std::move(edge));
    return true;
}

bool AssemblyStream::takeWarning(std::string_view bytes)
{
    std::uint32_t oddity = 0;
    double count = 0;
    if (!taken(bytes, oddity) || !taken(bytes, count) || !(count >= 0 && count <= 1e12) ||
        oddity > static_cast<std::uint32_t>(AssemblyOddity::NoPoint) || bytes.size() > longestPartName)
        return false;
    if (m_warnings.size() < mostWarnings)
        m_warnings.push_back(
            {static_cast<AssemblyOddity>(oddity), static_cast<std::uint64_t>(count), std::string(bytes)});
    return true;
}

bool AssemblyStream::takeProgress(std::string_view bytes)
{
    double done = 0;
    if (!taken(bytes, done) || !bytes.empty() || !(done >= 0 && done <= 1))
        return false;
    m_progress = std::max(m_progress, done);
    return true;
}

bool AssemblyStream::takeEnd(std::string_view bytes)
{
    std::uint32_t verdict = 0;
    if (!taken(bytes, verdict) || verdict > static_cast<std::uint32_t>(AssemblyVerdict::DecimalCommas) ||
        bytes.size() > longestPartName || (verdict == 0 && m_triangles == 0))
        return false;
    m_verdict = static_cast<AssemblyVerdict>(verdict);
    m_text = bytes;
    if (m_verdict != AssemblyVerdict::Read)
        m_assembly = {};
    m_state = State::Done;
    return true;
}

} // namespace bolster
