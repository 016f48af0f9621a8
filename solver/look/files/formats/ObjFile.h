// Models as Wavefront OBJ, with materials and pictures in files beside it.
#pragma once

#include "CoverModel.h"

namespace bolster {

struct NamedFile {
    std::string name; ///< in the same folder
    std::string bytes;
};

struct ObjFiles {
    std::string obj;
    std::vector<NamedFile> beside; ///< an .mtl, and pictures
};

/// Millimetres, z up, the colourway that is shown; a group for each mesh. `stem`: what the names of the files
/// beside it begin with. Blanks in it become "_": names in OBJ end there.
ObjFiles objFiles(const CoverModel& model, const std::string& stem);

} // namespace bolster
