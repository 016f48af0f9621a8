// Takes what a program says that reads assemblies. It is not trusted: whoever has taken it over may send anything.
#pragma once

#include "Assembly.h"

#include <string_view>

namespace bolster {

class AssemblyStream {
public:
    enum class State {
        Unfinished,
        Done,  ///< there is a verdict; if it is Read, all that belongs to it
        Broken ///< nothing that is expected
    };

    /// The bytes as they come.
    State take(std::string_view bytes);
    State state() const { return m_state; }

    AssemblyVerdict verdict() const { return m_verdict; }
    const std::string& text() const { return m_text; } ///< of the verdict
    const std::vector<AssemblyWarning>& warnings() const { return m_warnings; }
    double progress() const { return m_progress; } ///< 0 to 1
    Assembly takeAssembly() { return std::move(m_assembly); }

private:
    bool takeRecord(std::uint32_t kind, std::string_view bytes);
    bool takeFacts(std::string_view bytes);
    bool takePart(std::string_view bytes);
    bool takePoints(std::string_view bytes);
    bool takeTriangles(std::string_view bytes);
    bool takeEdge(std::string_view bytes);
    bool takeWarning(std::string_view bytes);
    bool takeProgress(std::string_view bytes);
    bool takeEnd(std::string_view bytes);

    State m_state = State::Unfinished;
    std::string m_bytes; // of a record that has begun
    bool m_begun = false;
    AssemblyVerdict m_verdict = AssemblyVerdict::Damaged;
    std::string m_text;
    std::vector<AssemblyWarning> m_warnings;
    double m_progress = 0;
    Assembly m_assembly;
    std::uint64_t m_points = 0;
    std::uint64_t m_edgePoints = 0;
    std::uint64_t m_triangles = 0;
};

} // namespace bolster
