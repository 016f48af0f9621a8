// What a file from a CAD or modelling program holds: a tree of parts with their meshes.
#pragma once

#include "Geometry.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bolster {

enum class UpAxis { Z, Y, X };

/// Turns the axes of a file to Bolster's, where z points up.
Quat rotationFor(UpAxis up);

/// What a file says of its numbers; many say nothing.
struct FileFacts {
    std::optional<double> millimetresPerUnit;
    std::optional<UpAxis> up;

    friend bool operator==(const FileFacts&, const FileFacts&) = default;
};

struct Assembly {
    struct Part {
        std::string name;
        std::optional<std::uint32_t> parent; ///< comes before its parts
        std::optional<std::uint32_t> color;  ///< 0xRRGGBB
        std::vector<Vec3> points;            ///< file units, in the axes of the file: where the tree has put them
        std::vector<std::array<std::uint32_t, 3>>
            triangles; ///< counter-clockwise from outside; often there are none
    };
    /// An edge of a CAD face.
    struct Edge {
        enum class Kind { Other, Line, Circle, Ellipse, Spline };

        std::uint32_t part = 0;
        Kind kind = Kind::Other;
        std::vector<Vec3> points; ///< at most 0.02 mm beside the curve
    };

    FileFacts said;
    std::vector<Part> parts;
    std::vector<Edge> edges; ///< if they were asked for
};

/// The tree without its meshes.
struct PartOutline {
    std::string name;
    std::optional<std::uint32_t> parent;  ///< comes before its parts
    std::uint64_t triangles = 0;          ///< its own
    std::optional<std::uint32_t> color{}; ///< 0xRRGGBB, for who chooses among them
};

std::vector<PartOutline> outlinesOf(const Assembly& assembly);

inline constexpr std::uint64_t mostAssemblyTriangles = 10'000'000;
inline constexpr std::uint64_t mostAssemblyPoints = 20'000'000; ///< of meshes, and of edges
inline constexpr std::size_t mostAssemblyParts = 100'000;
inline constexpr std::size_t longestPartName = 200;  ///< bytes
inline constexpr double farthestAssemblyPoint = 1e7; ///< file units

/// How reading ended.
enum class AssemblyVerdict : std::uint32_t {
    Read,
    Damaged,
    NoFaces,
    TooLarge, ///< triangles or points
    TooManyParts,
    TooFar,      ///< a part is beyond farthestAssemblyPoint; the text names it
    FileMissing, ///< one that belongs to it; the text names it
    TooMuchMemory,
    DecimalCommas,
};

/// What is odd of a file that is read nevertheless.
enum class AssemblyOddity : std::uint32_t {
    NotFinite,     ///< triangles left out whose corners are no numbers; how many
    NoSize,        ///< parts left out that are scaled to nothing; the text names the first
    NotMeshed,     ///< CAD faces that could not be made triangles of; how many
    TooDeep,       ///< parts deeper than the tree may be, left out
    FileElsewhere, ///< a file that it refers to and that is not read; the text names it
    FileBeside,    ///< a file of its own folder that was read with it; the text names it
    NoPoint,       ///< triangles left out that name points which are not there; how many, 0: unknown
};

struct AssemblyWarning {
    AssemblyOddity oddity = AssemblyOddity::NotFinite;
    std::uint64_t count = 0;
    std::string text;
};

} // namespace bolster
