// Files of modelling programs (glTF, FBX, COLLADA, 3MF) as assemblies, by Assimp. Nothing of it is seen here.
#pragma once

#include "AssemblyWriter.h"

#include <map>
#include <string>
#include <string_view>

namespace bolster {

struct SceneOrder {
    std::string ending;                                          ///< of the file, lower case, without the dot
    std::map<std::string, std::string_view, std::less<>> beside; ///< bytes of the files beside it, by name
};

/// Throws AssemblyRefused.
void readScene(std::string_view bytes, const SceneOrder& order, AssemblyWriter& writer);

} // namespace bolster
