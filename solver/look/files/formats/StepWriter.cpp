#include "StepWriter.h"

#include "RawNumbers.h"

#include <cstdint>

namespace bolster {

namespace {

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

} // namespace

int StepWriter::add(const std::string& entity)
{
    m_text += "#" + std::to_string(++m_last) + "=" + entity + ";\n";
    return m_last;
}

int StepWriter::addPoint(const Vec3& point)
{
    return add("CARTESIAN_POINT(''," + list(point, real) + ")");
}

/// Reals have a point, whatever they are.
std::string StepWriter::real(double value)
{
    std::string text;
    appendNumber(text, value);
    if (const std::size_t exponent = text.find('e'); exponent != std::string::npos)
        return text.substr(0, exponent) + (text.find('.') == std::string::npos ? "." : "") + "E" +
               text.substr(exponent + 1);
    return text.find('.') == std::string::npos ? text + "." : text;
}

/// \X2\ has four hexadecimal digits a letter, \X4\ eight.
std::string StepWriter::text(const std::string& words)
{
    static constexpr char digits[] = "0123456789ABCDEF";
    std::string quoted = "'";
    for (std::size_t at = 0; at < words.size();) {
        const std::uint32_t letter = nextLetter(words, at);
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

int StepWriter::addAxes()
{
    const int origin = addPoint(Vec3::Zero());
    const int up = add("DIRECTION('',(0.,0.,1.))"), right = add("DIRECTION('',(1.,0.,0.))");
    return add("AXIS2_PLACEMENT_3D(''," + ref(origin) + "," + ref(up) + "," + ref(right) + ")");
}

void StepWriter::addProduct(const std::string& name, int representation)
{
    const int application = add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
    add("APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000," + ref(application) +
        ")");
    const int context = add("PRODUCT_CONTEXT(''," + ref(application) + ",'mechanical')");
    const int product = add("PRODUCT(" + text(name) + "," + text(name) + ",'',(" + ref(context) + "))");
    add("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(" + ref(product) + "))");
    const int formation = add("PRODUCT_DEFINITION_FORMATION('',''," + ref(product) + ")");
    const int stage = add("PRODUCT_DEFINITION_CONTEXT('part definition'," + ref(application) + ",'design')");
    const int definition = add("PRODUCT_DEFINITION('design',''," + ref(formation) + "," + ref(stage) + ")");
    const int shape = add("PRODUCT_DEFINITION_SHAPE('',''," + ref(definition) + ")");
    add("SHAPE_DEFINITION_REPRESENTATION(" + ref(shape) + "," + ref(representation) + ")");
}

std::string StepWriter::file(const std::string& description, const std::string& name) const
{
    return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((" + text(description) + "),'2;1');\nFILE_NAME(" + text(name) +
           ",'2000-01-01T00:00:00',(''),(''),'Bolster','Bolster','');\n"
           "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n" +
           m_text + "ENDSEC;\nEND-ISO-10303-21;\n";
}

} // namespace bolster
