// The tree of a scene as parts.
#pragma once

#include "SceneFile.h"

#include <assimp/matrix4x4.h>

struct aiScene;

namespace bolster {

inline constexpr double shareOfSceneReading = 0.5; ///< of all that is to be done

Eigen::Matrix4d matrixOf(const aiMatrix4x4& m);

/// `names` are what nodes of these names are to be called instead.
void writeSceneParts(const aiScene& scene, const SceneOrder& order,
                     const std::map<std::string, std::string, std::less<>>& names, AssemblyWriter& writer);

} // namespace bolster
