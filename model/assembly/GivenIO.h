// For Assimp: the files that this process has been given, and no others.
#pragma once

#include "SceneFile.h"

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>

namespace bolster {

class GivenIO : public Assimp::IOSystem {
public:
    /// `main` is the file itself, as `name`.
    GivenIO(std::string name, std::string_view main, const SceneOrder& order);

    bool Exists(const char* file) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* file, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

    /// The first one that was wanted and is not there, or "".
    const std::string& missing() const { return m_missing; }
    /// One beside the file itself that was read, or "".
    const std::string& beside() const { return m_beside; }

private:
    const std::string_view* find(std::string_view file) const;

    std::string m_name;
    std::string_view m_main;
    const SceneOrder& m_order;
    std::string m_missing;
    std::string m_beside;
};

} // namespace bolster
