// Small files of modelling programs, written by hand.
#pragma once

#include <string>
#include <vector>

namespace bolster::test {

/// The nodes of a glTF scene, as JSON; mesh 0 is a cube from -1 to 1 with normals that point outwards.
struct GltfScene {
    std::string nodes = R"([{"name": "Cube", "mesh": 0}])";
    std::string roots = "[0]";
    std::string uri{}; ///< of the buffer; none: it is in the file (GLB)
    std::vector<float> points = cubePoints();

    static std::vector<float> cubePoints();
};

std::string gltfBuffer(const GltfScene& scene);
std::string gltfText(const GltfScene& scene);
std::string glbBytes(const GltfScene& scene);

/// A cube "Box" from 0 to 10 in a group "Group"; `factor` is the unit in centimetres, `up` 1 for y and 2 for z.
std::string fbxText(double factor, int up);

/// A cube "Box" from 0 to 10. `nodes` is what the scene holds instead of it; `library` holds nodes.
std::string colladaText(const std::string& unit, const std::string& up, const std::string& nodes = {},
                        const std::string& library = {});

} // namespace bolster::test
