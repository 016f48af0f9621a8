// Numbers, lengths, transforms and paths as attributes of SVG have them. Private to the library.
#pragma once

#include "DrawingPen.h"

#include <functional>
#include <string_view>

namespace bolster {

/// Reads numbers one after the other, whatever is between them.
class SvgNumbers {
public:
    explicit SvgNumbers(std::string_view text)
        : m_text(text)
    {}

    /// False when none follows before a letter or the end.
    bool number(double& value);
    /// 0 or 1, which may stand without a blank behind it.
    bool flag(bool& value);
    /// The next letter, passing blanks; 0 at the end or before a number.
    char letter();
    bool atEnd();

private:
    void skip();

    std::string_view m_text;
};

/// "12.5mm" in user units of 1/96 inch; `absolute` becomes whether it says so in a unit of length.
std::optional<double> svgLength(std::string_view text, bool* absolute = nullptr);
/// Of "translate(3) rotate(90 5 5) matrix(...)"; what cannot be read ends it.
Eigen::Affine2d svgTransform(std::string_view text);
/// Draws the path's lines, each given to `take` with whether it is closed. False where it cannot be read to its
/// end.
bool drawSvgPath(std::string_view path, const Eigen::Affine2d& map,
                 const std::function<void(DrawingPen& pen, bool closed)>& take);

} // namespace bolster
