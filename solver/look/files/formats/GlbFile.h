// Models as binary glTF 2.0: what browsers, phones and most 3D programs read.
#pragma once

#include "CoverModel.h"

namespace bolster {

/// Metres, y up, the front to +z, standing on y = 0 around the origin; pictures inside. Colourways are the
/// variants of KHR_materials_variants where there is more than one. The same model gives the same bytes.
/// `small`: normals in 16 bits, for readers that know KHR_mesh_quantization.
std::string glbFile(const CoverModel& model, bool small = false);

/// From the design's axes (mm, z up) to those of glTF and USD: y up, metres; directions keep their length.
Eigen::Vector3f yUp(const Eigen::Vector3f& p);
Eigen::Vector3f metresYUp(const Eigen::Vector3f& p);
/// What puts a model on the floor around the origin, metres, y up; turned by `model.front` about y first.
Eigen::Vector3f standing(const CoverModel& model);

} // namespace bolster
