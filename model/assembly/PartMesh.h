// The mesh of one part while its file is read: corners at one place become one point, polygons are split.
#pragma once

#include "AssemblyWriter.h"
#include "MeshBuilder.h"

namespace bolster {

class PartMesh {
public:
    static constexpr std::int64_t notFinite = -1;

    /// The number of the point there, or notFinite. Throws AssemblyRefused, with the part's name, for one that is
    /// too far away.
    std::int64_t addPoint(const Vec3& point, std::string_view part);
    /// Leaves out those with corners that are not finite, and counts them.
    void addFace(std::span<const std::int64_t> corners);

    std::uint64_t leftOut() const { return m_leftOut; }
    bool empty() const { return m_faces == 0; }
    /// Nothing when there is no triangle. Throws AssemblyRefused when it is too much.
    void send(AssemblyWriter& writer, std::uint32_t part);

private:
    MeshBuilder m_mesh;
    std::uint64_t m_faces = 0;
    std::uint64_t m_leftOut = 0;
};

/// What programs that read assemblies do: `read` writes what it finds, and this says how it ended. Returns the exit
/// code.
int writeAssembly(const AssemblyWriter::Sink& sink, const std::function<void(AssemblyWriter&)>& read);

} // namespace bolster
