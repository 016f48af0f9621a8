// What the numbers of a drawing are when nobody says.
#include "DesignCheck.h"
#include "DrawnWords.h"
#include "FoundPieces.h"

#include <algorithm>
#include <stdexcept>

namespace bolster {

namespace {

constexpr double inchUnit = 25.4; // mm

bool saysEnglish(const Drawing& drawing)
{
    bool english = false;
    for (const std::string& words : drawing.texts)
        if (const auto [key, value] = keyAndValue(words); key == "units")
            english = lowered(value) == "english";
    return english;
}

bool isSound(const Contour& outline)
{
    try {
        return !outlineProblem(BSpline2(1, true, outline.places()));
    } catch (const std::invalid_argument&) { // too many points, or too far away
        return false;
    }
}

/// In the drawing's numbers: the largest piece that can become a patch; where there is none, all that is drawn
/// together.
double largestDrawn(const Drawing& drawing)
{
    double largest = 0;
    for (const FoundPiece& piece : findPieces(drawing, {}).pieces)
        if (const double size = piece.cut.box().sizes().maxCoeff(); size > largest && isSound(piece.cut))
            largest = size;
    if (largest > 0)
        return largest;
    for (const DrawnPart& part : drawing.parts) {
        Box2 box;
        for (const DrawnLine& line : part.lines)
            for (const DrawnPoint& point : line.points)
                box.extend(point.at);
        if (!box.isEmpty())
            largest = std::max(largest, box.sizes().maxCoeff());
    }
    return largest;
}

} // namespace

double guessedUnit(const Drawing& drawing)
{
    if (drawing.unit)
        return *drawing.unit;
    if (saysEnglish(drawing))
        return inchUnit;
    if (drawing.usualUnit && *drawing.usualUnit > 1e-4 && *drawing.usualUnit < 1e4)
        return *drawing.usualUnit;
    // Metric is millimetres for some programs, centimetres for others, and drawings of buildings are in metres.
    // Nobody sews a pattern of 12 cm, few one of 12 m.
    const double largest = largestDrawn(drawing);
    return largest <= 0 ? 1 : largest < 4 ? 1000 : largest < 120 ? 10 : 1;
}

} // namespace bolster
