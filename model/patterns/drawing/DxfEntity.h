// DXF as groups of a code and a value, and as the entities that they make up. Private to the library.
#pragma once

#include "FileBytes.h"
#include "Geometry.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace bolster {

struct DxfEntity {
    std::string kind;
    std::string layer;
    std::string text;                            ///< code 1, behind all of code 3
    std::string name;                            ///< code 2
    std::vector<std::pair<int, double>> numbers; ///< in their order
    std::vector<std::string> comments;           ///< code 999 before it
    std::vector<DxfEntity> vertices;             ///< of a POLYLINE

    bool has(int code) const;
    /// The first of that code.
    double number(int code, double otherwise = 0) const;
    int integer(int code, int otherwise = 0) const;
    Vec2 point(int code) const { return {number(code), number(code + 10)}; }
    /// All of that code.
    std::vector<double> all(int code) const;
    /// All points of that code, as far as they have both coordinates.
    std::vector<Vec2> points(int code) const;
};

struct DxfBlock {
    std::string name;
    Vec2 base = Vec2::Zero();
    std::vector<DxfEntity> entities;
};

struct DxfFile {
    int units = 0;           ///< $INSUNITS
    bool endMissing = false; ///< all is there that is drawn, but not the mark at the end of the file
    std::map<std::string, DxfBlock> blocks;
    std::vector<std::string> blockNames; ///< in the file's order
    std::vector<DxfEntity> entities;
};

/// DXF of any version, ASCII or binary. Throws FileRefused.
DxfFile readDxfFile(const FileBytes& bytes);

} // namespace bolster
