// Numbers, lengths and paths as attributes of SVG have them. Private to the library.
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
    /// Letters, or a percent sign, directly behind what was read.
    std::string_view unit();
    bool atEnd();

private:
    void skip();

    std::string_view m_text;
};

/// User units (1/96 inch) of "mm", "px", "" ...; nothing for what has no fixed size.
std::optional<double> svgUnit(std::string_view unit);
/// "12.5mm" in user units; `absolute` becomes true where it says so in a unit of length. Percents are of `whole`.
std::optional<double> svgLength(std::string_view text, bool* absolute = nullptr, std::optional<double> whole = {});
/// Draws the path's lines, each given to `take` with whether it is closed. False where it cannot be read to its
/// end.
bool drawSvgPath(std::string_view path, const Eigen::Affine2d& map,
                 const std::function<void(DrawingPen& pen, bool closed)>& take);

} // namespace bolster
