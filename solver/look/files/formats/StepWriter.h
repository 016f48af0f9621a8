// The text of STEP files: entities with numbers that refer to each other, and what each product needs.
#pragma once

#include "Geometry.h"

#include <string>

namespace bolster {

/// After ISO 10303-21 (the text) and the schema AUTOMOTIVE_DESIGN (AP214); millimetres. The same calls give the
/// same text.
class StepWriter {
public:
    /// With its keyword and arguments, "POINT(...)"; its number.
    int add(const std::string& entity);
    int addPoint(const Vec3& point);
    /// Of the representation: units, and how exact places are.
    int addContext();
    /// The design's axes: what representations begin with.
    int addAxes();
    void addProduct(const std::string& name, int representation);
    /// All of the file.
    std::string file(const std::string& description, const std::string& name) const;

    /// "#12"
    static std::string ref(int entity) { return "#" + std::to_string(entity); }
    static std::string real(double value);
    /// In quotes; letters beyond ASCII as \X2\ ... \X0\.
    static std::string text(const std::string& words);
    /// "(1,2,3)"
    template <class Values, class Text>
    static std::string list(const Values& values, const Text& text)
    {
        std::string all = "(";
        for (const auto& value : values)
            all += (all.size() > 1 ? "," : "") + text(value);
        return all + ")";
    }

private:
    int m_last = 0;
    std::string m_text;
};

} // namespace bolster
