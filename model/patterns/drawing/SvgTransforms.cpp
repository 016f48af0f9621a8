#include "SvgTransforms.h"

#include "DrawnWords.h"
#include "SvgNumbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace bolster {

namespace {

constexpr const char* svgBlanks = " \t\r\n,";

double asRadians(double degrees)
{
    return degrees * std::numbers::pi / 180;
}

/// Degrees or user units of a number with whatever is behind it.
std::optional<double> inUserUnits(double value, std::string_view unit)
{
    static constexpr std::array<std::pair<std::string_view, double>, 4> angles{
        {{"deg", 1}, {"grad", 0.9}, {"turn", 360}, {"rad", 180 / std::numbers::pi}}};
    const std::string word = lowered(unit);
    for (const auto& [name, degrees] : angles)
        if (word == name)
            return value * degrees;
    const auto size = svgUnit(word);
    return size ? std::optional(value * *size) : std::nullopt;
}

std::optional<std::vector<double>> svgArguments(std::string_view text)
{
    std::vector<double> values;
    SvgNumbers numbers(text);
    while (!numbers.atEnd()) {
        double value = 0;
        if (values.size() == 6 || !numbers.number(value))
            return std::nullopt;
        const auto converted = inUserUnits(value, numbers.unit());
        if (!converted)
            return std::nullopt;
        values.push_back(*converted);
    }
    return values;
}

std::optional<Eigen::Affine2d> oneTransform(const std::string& name, const std::vector<double>& v)
{
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    const std::size_t n = v.size();
    if (name == "matrix" && n == 6) {
        map.linear() << v[0], v[2], v[1], v[3];
        map.translation() << v[4], v[5];
    } else if (name == "translate" && (n == 1 || n == 2)) {
        map.translate(Vec2(v[0], n > 1 ? v[1] : 0));
    } else if (name == "scale" && (n == 1 || n == 2)) {
        map.scale(Vec2(v[0], n > 1 ? v[1] : v[0]));
    } else if (name == "rotate" && (n == 1 || n == 3)) {
        const Vec2 centre = n > 1 ? Vec2(v[1], v[2]) : Vec2(0, 0);
        map.translate(centre).rotate(asRadians(v[0])).translate(Vec2(-centre));
    } else if (name == "skew" && (n == 1 || n == 2)) {
        map.linear() << 1, std::tan(asRadians(v[0])), n > 1 ? std::tan(asRadians(v[1])) : 0, 1;
    } else if (name == "skewx" && n == 1) {
        map.linear() << 1, std::tan(asRadians(v[0])), 0, 1;
    } else if (name == "skewy" && n == 1) {
        map.linear() << 1, 0, std::tan(asRadians(v[0])), 1;
    } else if ((name == "translatex" || name == "translatey") && n == 1) {
        map.translate(name.back() == 'x' ? Vec2(v[0], 0) : Vec2(0, v[0]));
    } else if ((name == "scalex" || name == "scaley") && n == 1) {
        map.scale(name.back() == 'x' ? Vec2(v[0], 1) : Vec2(1, v[0]));
    } else {
        return std::nullopt;
    }
    return map;
}

/// 0, 0.5 or 1 of "xMidYMax" along an axis.
double alignmentOf(const std::string& aspect, char axis)
{
    const std::size_t at = aspect.find(axis);
    const std::string word = at == std::string::npos ? "mid" : aspect.substr(at + 1, 3);
    return word == "min" ? 0 : word == "max" ? 1 : 0.5;
}

} // namespace

std::optional<Eigen::Affine2d> svgTransform(std::string_view text)
{
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    const auto skip = [&] { text.remove_prefix(std::min(text.find_first_not_of(svgBlanks), text.size())); };
    for (skip(); !text.empty() && text != "none"; skip()) {
        const std::size_t open = text.find('('), close = text.find(')');
        if (open == std::string_view::npos || close == std::string_view::npos || close < open)
            return std::nullopt;
        const auto values = svgArguments(text.substr(open + 1, close - open - 1));
        const std::string name = lowered(text.substr(0, std::min(open, text.find_first_of(" \t\r\n"))));
        const auto one = values ? oneTransform(name, *values) : std::nullopt;
        if (!one)
            return std::nullopt;
        map = map * *one;
        text.remove_prefix(close + 1);
    }
    return map;
}

std::optional<Eigen::Affine2d> svgTransform(std::string_view text, std::string_view origin)
{
    auto map = svgTransform(text);
    if (!map || trimmed(origin).empty())
        return map;
    const auto place = svgArguments(origin);
    if (!place || place->size() < 2)
        return std::nullopt;
    const Vec2 at(place->at(0), place->at(1));
    map->pretranslate(at);
    map->translate(Vec2(-at));
    return map;
}

std::optional<Box2> svgViewBox(std::string_view text)
{
    SvgNumbers numbers(text);
    std::array<double, 4> box{};
    for (double& value : box)
        if (!numbers.number(value))
            return std::nullopt;
    if (!(box[2] > 0) || !(box[3] > 0))
        return std::nullopt;
    return Box2(Vec2(box[0], box[1]), Vec2(box[0] + box[2], box[1] + box[3]));
}

Eigen::Affine2d svgViewport(const Box2& box, const Vec2& size, std::string_view aspect)
{
    const std::string words = lowered(aspect);
    Vec2 scale = size.cwiseQuotient(box.sizes());
    Vec2 offset = Vec2::Zero();
    if (words.find("none") == std::string::npos) {
        const bool slice = words.find("slice") != std::string::npos;
        scale = Vec2::Constant(slice ? scale.maxCoeff() : scale.minCoeff());
        const Vec2 free = size - scale.cwiseProduct(box.sizes());
        offset = free.cwiseProduct(Vec2(alignmentOf(words, 'x'), alignmentOf(words, 'y')));
    }
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    map.translate(offset).scale(scale).translate(Vec2(-box.min()));
    return map;
}

} // namespace bolster
