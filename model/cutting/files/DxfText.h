// Groups of a DXF: of R12, or of R2000 with its handles and owners. Private to the library.
#pragma once

#include "BSpline.h"

#include <string>
#include <string_view>
#include <vector>

namespace bolster {

/// Makes the text pair by pair. The same calls give entities of R12 (POLYLINE) or of R2000 (LWPOLYLINE, SPLINE).
class DxfText {
public:
    explicit DxfText(bool r2000 = false)
        : m_r2000(r2000)
    {}

    bool isR2000() const { return m_r2000; }

    void pair(int code, std::string_view value);
    void number(int code, double value);
    void point(int code, const Vec2& at);
    /// What belongs to an entity only with R2000 follows: `parts` are its AcDb classes.
    void entity(std::string_view kind, std::string_view layer, std::string_view part = {});
    void begin(std::string_view section);
    void end() { pair(0, "ENDSEC"); }

    void line(std::string_view layer, const Vec2& from, const Vec2& to);
    void dot(std::string_view layer, const Vec2& at);
    void circle(std::string_view layer, const Vec2& at, double radius);
    void polyline(std::string_view layer, const std::vector<Vec2>& points, bool closed);
    void text(std::string_view layer, const Vec2& at, double height, double degrees, std::string_view words);
    /// R2000: exact, a SPLINE from corner to corner, a LINE where that is straight; a polygon is a LWPOLYLINE.
    void curve(std::string_view layer, const BSpline2& curve);

    /// A new handle, hexadecimal.
    std::string handle();
    std::string result() { return std::move(m_text); }

private:
    void spline(std::string_view layer, const BSpline2& open);

    bool m_r2000;
    int m_handles = 0x100; // below: tables
    std::string m_text;
};

/// Everything of a file of R2000 but its entities, which `write` gives. Readers want all of its tables.
struct DxfFrame {
    std::vector<std::string> layers;
    Vec2 size = Vec2::Zero(); ///< of the drawing from 0, mm
};
void beginR2000(DxfText& dxf, const DxfFrame& frame);
void endR2000(DxfText& dxf);

} // namespace bolster
