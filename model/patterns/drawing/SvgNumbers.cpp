#include "SvgNumbers.h"

#include "DrawnWords.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

namespace bolster {

void SvgNumbers::skip()
{
    const std::size_t next = m_text.find_first_not_of(" \t\r\n,");
    m_text.remove_prefix(std::min(next, m_text.size()));
}

bool SvgNumbers::atEnd()
{
    skip();
    return m_text.empty();
}

bool SvgNumbers::number(double& value)
{
    skip();
    std::string_view text = m_text;
    if (text.starts_with('+'))
        text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value) || std::abs(value) > 1e12)
        return false;
    m_text.remove_prefix(static_cast<std::size_t>(end - m_text.data()));
    return true;
}

bool SvgNumbers::flag(bool& value)
{
    skip();
    if (m_text.empty() || (m_text[0] != '0' && m_text[0] != '1'))
        return false;
    value = m_text[0] == '1';
    m_text.remove_prefix(1);
    return true;
}

char SvgNumbers::letter()
{
    skip();
    if (m_text.empty() || !std::isalpha(static_cast<unsigned char>(m_text[0])))
        return 0;
    const char found = m_text[0];
    m_text.remove_prefix(1);
    return found;
}

std::string_view SvgNumbers::unit()
{
    std::size_t count = 0;
    while (count < m_text.size() &&
           (std::isalpha(static_cast<unsigned char>(m_text[count])) || m_text[count] == '%'))
        ++count;
    const std::string_view found = m_text.substr(0, count);
    m_text.remove_prefix(count);
    return found;
}

std::optional<double> svgUnit(std::string_view unit)
{
    constexpr double inch = 96;
    static constexpr std::array<std::pair<std::string_view, double>, 8> units{{{"", 1},
                                                                               {"px", 1},
                                                                               {"mm", inch / 25.4},
                                                                               {"cm", inch / 2.54},
                                                                               {"in", inch},
                                                                               {"pt", inch / 72},
                                                                               {"pc", inch / 6},
                                                                               {"q", inch / 101.6}}};
    for (const auto& [name, size] : units)
        if (unit == name)
            return size;
    return std::nullopt;
}

std::optional<double> svgLength(std::string_view text, bool* absolute, std::optional<double> whole)
{
    SvgNumbers numbers(text);
    double value = 0;
    if (!numbers.number(value))
        return std::nullopt;
    const std::string unit = lowered(numbers.unit());
    if (!numbers.atEnd())
        return std::nullopt;
    if (unit == "%")
        return whole ? std::optional(value / 100 * *whole) : std::nullopt;
    const auto size = svgUnit(unit);
    if (!size)
        return std::nullopt;
    if (absolute && !unit.empty() && unit != "px")
        *absolute = true;
    return value * *size;
}

namespace {

class SvgPathPen {
public:
    using Take = std::function<void(DrawingPen& pen, bool closed)>;

    SvgPathPen(std::string_view path, const Eigen::Affine2d& map, const Take& take)
        : m_numbers(path)
        , m_pen(map)
        , m_take(take)
    {}

    bool draw()
    {
        while (!m_numbers.atEnd()) {
            if (const char letter = m_numbers.letter())
                m_command = letter;
            else if (m_command == 0 || m_command == 'Z' || m_command == 'z')
                return finish(false);
            if (!step())
                return finish(false);
        }
        return finish(true);
    }

private:
    bool finish(bool whole)
    {
        end(false);
        return whole;
    }
    void end(bool closed)
    {
        if (!m_pen.empty())
            m_take(m_pen, closed);
    }

    /// Coordinates of points, relative ones made absolute.
    bool points(std::array<Vec2, 3>& found, std::size_t count)
    {
        const bool relative = std::islower(static_cast<unsigned char>(m_command)) != 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (!m_numbers.number(found[i].x()) || !m_numbers.number(found[i].y()))
                return false;
            if (relative)
                found[i] += m_at;
        }
        return true;
    }

    bool step()
    {
        const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(m_command)));
        const bool relative = kind != m_command;
        if (kind == 'Z') {
            end(true);
            m_at = m_start;
            m_last = 0;
            return true;
        }
        if (kind != 'M' && m_pen.empty())
            m_pen.moveTo(m_at);
        std::array<Vec2, 3> p;
        bool sound = true;
        if (kind == 'M') {
            sound = points(p, 1);
            if (sound)
                moveTo(p[0]);
            m_command = relative ? 'l' : 'L';
        } else if (kind == 'L' || kind == 'T' || kind == 'H' || kind == 'V') {
            sound = kind == 'H' || kind == 'V' ? along(p[0], kind == 'H', relative) : points(p, 1);
            if (sound)
                kind == 'T' ? quadratic(reflected('Q'), p[0]) : lineTo(p[0]);
        } else if (kind == 'C') {
            if ((sound = points(p, 3)))
                cubic(p[0], p[1], p[2]);
        } else if (kind == 'S') {
            if ((sound = points(p, 2)))
                cubic(reflected('C'), p[0], p[1]);
        } else if (kind == 'Q') {
            if ((sound = points(p, 2)))
                quadratic(p[0], p[1]);
        } else if (kind == 'A') {
            sound = arc();
        } else {
            sound = false;
        }
        m_last = kind == 'S' ? 'C' : kind == 'T' ? 'Q' : kind;
        return sound;
    }

    void moveTo(const Vec2& at)
    {
        end(false);
        m_pen.moveTo(at);
        m_at = m_start = at;
    }
    void lineTo(const Vec2& at)
    {
        m_pen.lineTo(at);
        m_at = at;
    }
    bool along(Vec2& at, bool x, bool relative)
    {
        at = m_at;
        double value = 0;
        if (!m_numbers.number(value))
            return false;
        (x ? at.x() : at.y()) = relative ? (x ? m_at.x() : m_at.y()) + value : value;
        return true;
    }
    Vec2 reflected(char kind) const { return m_last == kind ? Vec2(2 * m_at - m_control) : m_at; }
    void cubic(const Vec2& b, const Vec2& c, const Vec2& d)
    {
        m_pen.cubicTo(b, c, d);
        m_control = c;
        m_at = d;
    }
    void quadratic(const Vec2& control, const Vec2& end)
    {
        m_pen.cubicTo((m_at + 2 * control) / 3, (end + 2 * control) / 3, end);
        m_control = control;
        m_at = end;
    }

    /// SVG 1.1, appendix F.6.
    bool arc()
    {
        double rx = 0, ry = 0, degrees = 0;
        bool large = false, sweep = false;
        std::array<Vec2, 3> p;
        if (!m_numbers.number(rx) || !m_numbers.number(ry) || !m_numbers.number(degrees) ||
            !m_numbers.flag(large) || !m_numbers.flag(sweep) || !points(p, 1))
            return false;
        const Vec2 end = p[0];
        rx = std::abs(rx);
        ry = std::abs(ry);
        if (rx < 1e-12 || ry < 1e-12 || (end - m_at).norm() < 1e-12) {
            lineTo(end);
            return true;
        }
        const Eigen::Rotation2Dd turn(degrees * std::numbers::pi / 180);
        const Vec2 half = turn.inverse() * Vec2((m_at - end) / 2);
        const double grow =
            std::sqrt(std::max(1.0, half.x() * half.x() / (rx * rx) + half.y() * half.y() / (ry * ry)));
        rx *= grow;
        ry *= grow;
        const Vec2 unit(half.x() / rx,
                        half.y() / ry); // on the unit circle around the centre: start is centre + unit
        const double off =
            std::sqrt(std::max(0.0, 1 / std::max(unit.squaredNorm(), 1e-300) - 1)) * (large == sweep ? -1 : 1);
        const Vec2 middle = off * Vec2(unit.y(), -unit.x());
        const Vec2 centre = turn * Vec2(rx * middle.x(), ry * middle.y()) + (m_at + end) / 2;
        const Vec2 from = unit - middle, to = -unit - middle;
        double angle = std::atan2(cross(from, to), from.dot(to));
        if (sweep && angle < 0)
            angle += 2 * std::numbers::pi;
        if (!sweep && angle > 0)
            angle -= 2 * std::numbers::pi;
        m_pen.arcTo(centre, turn * Vec2(rx, 0), turn * Vec2(0, ry), std::atan2(from.y(), from.x()), angle);
        m_at = end;
        return true;
    }

    SvgNumbers m_numbers;
    DrawingPen m_pen;
    const Take& m_take;
    char m_command = 0;
    char m_last = 0;
    Vec2 m_at = Vec2::Zero();
    Vec2 m_start = Vec2::Zero();
    Vec2 m_control = Vec2::Zero();
};

} // namespace

bool drawSvgPath(std::string_view path, const Eigen::Affine2d& map,
                 const std::function<void(DrawingPen& pen, bool closed)>& take)
{
    return SvgPathPen(path, map, take).draw();
}

} // namespace bolster
