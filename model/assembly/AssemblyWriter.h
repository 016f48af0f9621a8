// What a program that reads assemblies says to the one that has started it: a row of records, each checked by
// AssemblyStream.
#pragma once

#include "Assembly.h"
#include "TriangleMesh.h"

#include <functional>
#include <span>
#include <string_view>

namespace bolster {

/// Reading ends here, with nothing.
struct AssemblyRefused {
    AssemblyVerdict verdict = AssemblyVerdict::Damaged;
    std::string text{};
};

class AssemblyWriter {
public:
    using Sink = std::function<void(std::string_view bytes)>;

    explicit AssemblyWriter(Sink sink);

    void facts(const FileFacts& facts);
    /// Throws AssemblyRefused when there are too many.
    std::uint32_t addPart(std::string_view name, std::optional<std::uint32_t> parent,
                          std::optional<std::uint32_t> color = {});
    /// All triangles of a part; its groups mean nothing. Throws AssemblyRefused when there are too many.
    void addMesh(std::uint32_t part, const TriangleMesh& mesh);
    void addEdge(std::uint32_t part, Assembly::Edge::Kind kind, std::span<const Vec3> points);
    void warn(AssemblyOddity oddity, std::uint64_t count, std::string_view text = {});
    void progress(double done);
    void end(AssemblyVerdict verdict, std::string_view text = {});

    std::uint64_t triangleCount() const { return m_triangles; }
    std::size_t partCount() const { return m_parts; }

private:
    void record(std::uint32_t kind, std::span<const std::string_view> pieces);
    void addPoints(std::uint32_t part, std::span<const Vec3> points);

    Sink m_sink;
    std::uint64_t m_triangles = 0;
    std::uint64_t m_points = 0;
    std::uint64_t m_edgePoints = 0;
    std::size_t m_parts = 0;
    double m_progress = 0;
};

} // namespace bolster
