// Wireframe, curve sets and B-splines of AP214.
#include "StepFile.h"

#include "StepWriter.h"

#include <utility>

namespace bolster {

namespace {

int addCurve(StepWriter& writer, const StepCurve& named)
{
    const BSpline3 curve =
        named.curve.closed() ? named.curve.part(named.curve.domainStart(), named.curve.domainEnd()) : named.curve;
    std::vector<int> points;
    for (const Vec3& p : curve.points())
        points.push_back(writer.addPoint(p));
    if (named.curve.closed())
        points.back() = points.front(); // the same to the last digit
    std::vector<std::pair<double, int>> knots;
    for (const double knot : curve.knots())
        if (!knots.empty() && knots.back().first == knot)
            ++knots.back().second;
        else
            knots.emplace_back(knot, 1);
    return writer.add(
        "B_SPLINE_CURVE_WITH_KNOTS(" + StepWriter::text(named.name) + "," + std::to_string(curve.degree()) + "," +
        StepWriter::list(points, StepWriter::ref) + ",.UNSPECIFIED.," + (named.curve.closed() ? ".T." : ".F.") +
        ",.F.," + StepWriter::list(knots, [](const auto& knot) { return std::to_string(knot.second); }) + "," +
        StepWriter::list(knots, [](const auto& knot) { return StepWriter::real(knot.first); }) + ",.UNSPECIFIED.)");
}

} // namespace

std::string stepFile(const std::string& product, const std::vector<StepCurves>& sets)
{
    StepWriter writer;
    const int context = writer.addContext();
    std::vector<int> items = {writer.addAxes()};
    for (const StepCurves& set : sets) {
        std::vector<int> curves;
        for (const StepCurve& curve : set.curves)
            curves.push_back(addCurve(writer, curve));
        if (!curves.empty())
            items.push_back(writer.add("GEOMETRIC_CURVE_SET(" + StepWriter::text(set.name) + "," +
                                       StepWriter::list(curves, StepWriter::ref) + ")"));
    }
    writer.addProduct(product,
                      writer.add("GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION(''," +
                                 StepWriter::list(items, StepWriter::ref) + "," + StepWriter::ref(context) + ")"));
    return writer.file("curves of a cover", product);
}

} // namespace bolster
