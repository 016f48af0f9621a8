#include "FileGuess.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

constexpr double smallestFurniture = 300; // mm: a stool
constexpr double smallestPlausible = 1, largestPlausible = 100'000;

bool isPlausibleSize(double size)
{
    return size >= smallestPlausible && size <= largestPlausible;
}

} // namespace

double millimetresPer(FileUnit unit)
{
    switch (unit) {
    case FileUnit::Millimetre:
        return 1;
    case FileUnit::Centimetre:
        return 10;
    case FileUnit::Metre:
        return 1000;
    case FileUnit::Inch:
        return 25.4;
    case FileUnit::Foot:
        return 304.8;
    case FileUnit::Custom:
        break;
    }
    return 0;
}

FileUnit unitOf(double millimetresPerUnit)
{
    constexpr double roundingOfFloats = 1e-6; // COLLADA and FBX are read with them
    for (const FileUnit unit :
         {FileUnit::Millimetre, FileUnit::Centimetre, FileUnit::Metre, FileUnit::Inch, FileUnit::Foot})
        if (std::abs(millimetresPerUnit / millimetresPer(unit) - 1) < roundingOfFloats)
            return unit;
    return FileUnit::Custom;
}

FileUnit guessUnit(const Box3& fileBox, double largest)
{
    if (fileBox.isEmpty())
        return FileUnit::Custom;
    const double fileSize = fileBox.sizes().maxCoeff();
    FileUnit nearest = FileUnit::Custom;
    double least = std::numeric_limits<double>::infinity();
    // The common units first: inches overlap with both centimetres and decimetres.
    for (const FileUnit unit : {FileUnit::Millimetre, FileUnit::Centimetre, FileUnit::Metre, FileUnit::Inch}) {
        const double size = fileSize * millimetresPer(unit);
        if (!isPlausibleSize(size))
            continue;
        const double off = std::max({size / largest, smallestFurniture / size, 1.0});
        if (off < least) {
            least = off;
            nearest = unit;
        }
    }
    return nearest;
}

std::optional<FileUnit> unitOf(const QString& fileEnding)
{
    for (const char* const metres : {"e57", "las", "ptx"})
        if (fileEnding.compare(QLatin1String(metres), Qt::CaseInsensitive) == 0)
            return FileUnit::Metre;
    return std::nullopt;
}

FileUnit proposedUnit(const FileFacts& said, const QString& fileEnding, const Box3& fileBox, double largest)
{
    return said.millimetresPerUnit ? unitOf(*said.millimetresPerUnit)
                                   : unitOf(fileEnding).value_or(guessUnit(fileBox, largest));
}

Placement saidPlacement(const FileFacts& said, const QString& fileEnding)
{
    Placement placement;
    placement.scale =
        said.millimetresPerUnit.value_or(millimetresPer(unitOf(fileEnding).value_or(FileUnit::Millimetre)));
    placement.rotation = rotationFor(said.up.value_or(UpAxis::Z));
    return placement;
}

double guessFactor(const Box3& fileBox)
{
    const double size = fileBox.isEmpty() ? 0 : fileBox.sizes().maxCoeff();
    if (!(size > 0))
        return 1;
    return std::pow(10.0, std::ceil(std::log10(smallestFurniture / size)));
}

bool isPlausible(const Box3& placed)
{
    return !placed.isEmpty() && isPlausibleSize(placed.sizes().maxCoeff());
}

UpAxis guessUpAxis(const QString& fileEnding)
{
    // OBJ comes mostly from programs for pictures, where y points up; the others from CAD and scanners.
    return fileEnding.compare(QLatin1String("obj"), Qt::CaseInsensitive) == 0 ? UpAxis::Y : UpAxis::Z;
}

Box3 placedBox(const std::vector<Vec3>& points, const Placement& placement)
{
    Box3 box;
    for (const Vec3& point : points)
        box.extend(placement.placed(point));
    return box;
}

} // namespace bolster
