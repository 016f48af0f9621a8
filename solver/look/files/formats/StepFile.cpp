// After ISO 10303-21 (the text) and the schema AUTOMOTIVE_DESIGN (AP214): product, wireframe, curve sets,
// B-splines.
#include "StepFile.h"

#include "RawNumbers.h"

#include <cmath>
#include <cstdint>
#include <utility>

namespace bolster {

namespace {

/// Reals have a point, whatever they are.
std::string real(double value)
{
    std::string text;
    appendNumber(text, value);
    if (const std::size_t exponent = text.find('e'); exponent != std::string::npos)
        return text.substr(0, exponent) + (text.find('.') == std::string::npos ? "." : "") + "E" +
               text.substr(exponent + 1);
    return text.find('.') == std::string::npos ? text + "." : text;
}

/// The code point of the letter at `at`, which goes behind it. What is no UTF-8 is a question mark.
std::uint32_t nextLetter(const std::string& text, std::size_t& at)
{
    const auto first = static_cast<unsigned char>(text[at++]);
    if (first < 0x80)
        return first;
    const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
    std::uint32_t letter = more == 0 ? '?' : first & (0x3FU >> more);
    for (int i = 0; i < more && at < text.size(); ++i)
        letter = letter << 6 | (static_cast<unsigned char>(text[at++]) & 0x3FU);
    return letter;
}

/// In quotes; letters beyond ASCII as \X2\ ... \X0\, four or eight hexadecimal digits.
std::string stepText(const std::string& text)
{
    static constexpr char digits[] = "0123456789ABCDEF";
    std::string quoted = "'";
    for (std::size_t at = 0; at < text.size();) {
        const std::uint32_t letter = nextLetter(text, at);
        if (letter == '\'' || letter == '\\') {
            quoted.append(2, static_cast<char>(letter));
        } else if (letter >= ' ' && letter < 0x7F) {
            quoted += static_cast<char>(letter);
        } else if (letter > 0x7F) {
            const bool wide = letter > 0xFFFF;
            quoted += wide ? "\\X4\\" : "\\X2\\";
            for (int shift = wide ? 28 : 12; shift >= 0; shift -= 4)
                quoted += digits[letter >> shift & 15U];
            quoted += "\\X0\\";
        }
    }
    return quoted + "'";
}

class StepWriter {
public:
    int add(const std::string& entity)
    {
        m_text += "#" + std::to_string(++m_last) + "=" + entity + ";\n";
        return m_last;
    }
    int addPoint(const Vec3& p)
    {
        return add("CARTESIAN_POINT('',(" + real(p.x()) + "," + real(p.y()) + "," + real(p.z()) + "))");
    }
    int addCurve(const StepCurve& curve);
    int addContext();
    void addProduct(const std::string& name, int representation);
    const std::string& text() const { return m_text; }

private:
    int m_last = 0;
    std::string m_text;
};

std::string ref(int entity)
{
    return "#" + std::to_string(entity);
}

template <class Values, class Text>
std::string stepList(const Values& values, const Text& text)
{
    std::string list = "(";
    for (const auto& value : values)
        list += (list.size() > 1 ? "," : "") + text(value);
    return list + ")";
}

int StepWriter::addCurve(const StepCurve& named)
{
    const BSpline3 curve =
        named.curve.closed() ? named.curve.part(named.curve.domainStart(), named.curve.domainEnd()) : named.curve;
    std::vector<int> points;
    for (const Vec3& p : curve.points())
        points.push_back(addPoint(p));
    if (named.curve.closed())
        points.back() = points.front(); // the same to the last digit
    std::vector<std::pair<double, int>> knots;
    for (const double knot : curve.knots())
        if (!knots.empty() && knots.back().first == knot)
            ++knots.back().second;
        else
            knots.emplace_back(knot, 1);
    return add("B_SPLINE_CURVE_WITH_KNOTS(" + stepText(named.name) + "," + std::to_string(curve.degree()) + "," +
               stepList(points, ref) + ",.UNSPECIFIED.," + (named.curve.closed() ? ".T." : ".F.") + ",.F.," +
               stepList(knots, [](const auto& knot) { return std::to_string(knot.second); }) + "," +
               stepList(knots, [](const auto& knot) { return real(knot.first); }) + ",.UNSPECIFIED.)");
}

/// Millimetres, radians, and how exact places are.
int StepWriter::addContext()
{
    const int length = add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
    const int angle = add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    const int solid = add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    const int exact = add("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-03)," + ref(length) +
                          ",'distance_accuracy_value','')");
    return add("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((" + ref(exact) +
               "))GLOBAL_UNIT_ASSIGNED_CONTEXT((" + ref(length) + "," + ref(angle) + "," + ref(solid) +
               "))REPRESENTATION_CONTEXT('',''))");
}

void StepWriter::addProduct(const std::string& name, int representation)
{
    const int application = add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
    add("APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000," + ref(application) +
        ")");
    const int context = add("PRODUCT_CONTEXT(''," + ref(application) + ",'mechanical')");
    const int product = add("PRODUCT(" + stepText(name) + "," + stepText(name) + ",'',(" + ref(context) + "))");
    add("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(" + ref(product) + "))");
    const int formation = add("PRODUCT_DEFINITION_FORMATION('',''," + ref(product) + ")");
    const int stage = add("PRODUCT_DEFINITION_CONTEXT('part definition'," + ref(application) + ",'design')");
    const int definition = add("PRODUCT_DEFINITION('design',''," + ref(formation) + "," + ref(stage) + ")");
    const int shape = add("PRODUCT_DEFINITION_SHAPE('',''," + ref(definition) + ")");
    add("SHAPE_DEFINITION_REPRESENTATION(" + ref(shape) + "," + ref(representation) + ")");
}

} // namespace

std::string stepFile(const std::string& product, const std::vector<StepCurves>& sets)
{
    StepWriter writer;
    const int context = writer.addContext();
    const int origin = writer.addPoint(Vec3::Zero());
    const int up = writer.add("DIRECTION('',(0.,0.,1.))"), right = writer.add("DIRECTION('',(1.,0.,0.))");
    std::vector<int> items = {
        writer.add("AXIS2_PLACEMENT_3D(''," + ref(origin) + "," + ref(up) + "," + ref(right) + ")")};
    for (const StepCurves& set : sets) {
        std::vector<int> curves;
        for (const StepCurve& curve : set.curves)
            curves.push_back(writer.addCurve(curve));
        if (!curves.empty())
            items.push_back(
                writer.add("GEOMETRIC_CURVE_SET(" + stepText(set.name) + "," + stepList(curves, ref) + ")"));
    }
    writer.addProduct(product, writer.add("GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION(''," +
                                          stepList(items, ref) + "," + ref(context) + ")"));
    return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('curves of a cover'),'2;1');\nFILE_NAME(" +
           stepText(product) +
           ",'2000-01-01T00:00:00',(''),(''),'Bolster','Bolster','');\n"
           "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n" +
           writer.text() + "ENDSEC;\nEND-ISO-10303-21;\n";
}

} // namespace bolster
