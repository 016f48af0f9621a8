// A cover in its fabrics as files of other programs want it: meshes, materials, pictures. No format yet.
#pragma once

#include "ElementId.h"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bolster {

/// A picture as the bytes of a file.
struct ModelPicture {
    std::string name; ///< of a file, with ".png" or ".jpg"; no two are alike
    std::string bytes;
    bool jpeg = false;
};

struct ModelMaterial {
    std::string name;                              ///< no two are alike
    Eigen::Vector3f color = {1, 1, 1};             ///< linear light; what a colour picture is multiplied with
    std::optional<std::size_t> colorPicture = {};  ///< sRGB
    std::optional<std::size_t> normalPicture = {}; ///< x right, y up in the picture
    std::optional<std::size_t> roughPicture = {};  ///< grey; `roughness` is 1 then
    Eigen::Vector3f mean = {1, 1, 1};              ///< linear light, from far away
    float roughness = 0.62F;                       ///< perceptual
    float metallic = 0;
    float sheen = 0; ///< of fibres, 0 to 1
    /// Which texture coordinates of a mesh are for this material, and what they are multiplied with.
    std::size_t places = 0;
    Eigen::Vector2f repeats = {1, 1};

    friend bool operator==(const ModelMaterial&, const ModelMaterial&) = default;
};

struct ModelMesh {
    using Places = std::vector<Eigen::Vector2f>;

    enum class Kind {
        Patch,
        Trim, ///< stitches and piping
        Seam, ///< the dark line at the bottom of a plain seam
        Frame
    };

    Kind kind = Kind::Patch;
    std::string name;
    std::vector<Eigen::Vector3f> points;  ///< mm, z up
    std::vector<Eigen::Vector3f> normals; ///< unit
    std::vector<Places> places; ///< texture coordinates in tiles, x right, y up; one for each set, maybe none
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< counter-clockwise seen from the outside
    std::vector<std::size_t> materials;                  ///< one for each colourway
};

struct CoverModel {
    std::vector<ModelPicture> pictures;
    std::vector<ModelMaterial> materials;
    std::vector<ModelMesh> meshes;
    std::vector<std::string> colourways; ///< names, at least one; the first is the one that is shown
    Eigen::AlignedBox3f box;             ///< mm
    double front = 0;                    ///< azimuth from which the front is seen (frontAzimuth of MeshShape.h)
};

} // namespace bolster
