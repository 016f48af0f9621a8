#include "DrawingPen.h"
#include "DrawingReaders.h"
#include "DrawnWords.h"
#include "SvgNumbers.h"
#include "SvgTree.h"

#include <array>
#include <cmath>

namespace bolster {

namespace {

using SvgMap = Eigen::Affine2d;

constexpr int deepestUse = 8;

/// What is handed down from an element to those in it.
struct SvgState {
    SvgMap map;
    std::string layer;
    std::vector<std::string> about;
    int uses = 0;
};

class SvgDrawer {
public:
    SvgDrawer(const SvgElement& root, const ImportWatch& watch)
        : m_root(root)
        , m_limits(watch)
    {
        findIds(root);
    }

    Drawing draw()
    {
        m_drawing.parts.emplace_back();
        children(m_root, {page(), "", {}, 0});
        if (m_drawing.parts.front().empty())
            m_drawing.parts.clear();
        return std::move(m_drawing);
    }

private:
    void findIds(const SvgElement& element)
    {
        if (const std::string& id = element.attribute("id"); !id.empty())
            m_ids.emplace(id, &element);
        for (const SvgElement& child : element.children)
            findIds(child);
    }

    /// From user units to millimetres if the file says how large it is, y up.
    SvgMap page()
    {
        constexpr double pixel = 25.4 / 96;
        bool absolute = false;
        const auto width = svgLength(m_root.attribute("width"), &absolute);
        const auto height = svgLength(m_root.attribute("height"), &absolute);
        Vec2 scale(pixel, pixel);
        Vec2 origin = Vec2::Zero();
        SvgNumbers numbers(m_root.attribute("viewBox"));
        std::array<double, 4> box{};
        const bool hasBox = numbers.number(box[0]) && numbers.number(box[1]) && numbers.number(box[2]) &&
                            numbers.number(box[3]) && box[2] > 0 && box[3] > 0;
        if (hasBox) {
            origin = {box[0], box[1]};
            if (width && height && *width > 0 && *height > 0) {
                // As preserveAspectRatio has it when nothing is said: all of the box is seen, nothing is distorted.
                const double factor = std::min(*width / box[2], *height / box[3]) * pixel;
                scale = {factor, factor};
                if (m_root.attribute("preserveAspectRatio") == "none")
                    scale = pixel * Vec2(*width / box[2], *height / box[3]);
            }
        }
        if (absolute)
            m_drawing.unit = 1;
        SvgMap map = SvgMap::Identity();
        map.scale(Vec2(scale.x(), -scale.y()));
        map.translate(Vec2(-origin));
        return map;
    }

    void children(const SvgElement& element, const SvgState& state)
    {
        for (const SvgElement& child : element.children)
            draw(child, state);
    }

    void draw(const SvgElement& element, const SvgState& outer)
    {
        const std::string& tag = element.tag;
        if (tag == "defs" || tag == "symbol" || tag == "metadata" || tag == "namedview" || tag == "style" ||
            tag == "desc" || tag == "clipPath")
            return; // drawn where they are used, if at all
        if (tag == "title") {
            if (!element.words.empty())
                m_drawing.texts.push_back("Style Name: " + element.words.substr(0, 200));
            return;
        }
        if (isHidden(element)) {
            ++m_drawing.unknown["hidden " + tag.substr(0, 40)];
            return;
        }
        SvgState state = outer;
        state.map = outer.map * svgTransform(element.attribute("transform"));
        for (const auto& [attribute, key] : {std::pair{"data-piece", "Piece Name: "},
                                             {"data-quantity", "Quantity: "},
                                             {"data-fabric", "Fabric: "},
                                             {"data-note", "Annotation: "}})
            if (const std::string& value = element.attribute(attribute); !value.empty())
                state.about.push_back(key + drawnWords(value));
        if (tag == "g" || tag == "svg" || tag == "a" || tag == "switch")
            group(element, std::move(state));
        else if (tag == "use")
            use(element, std::move(state));
        else if (tag == "text")
            addText(element, state);
        else if (!addShape(element, state))
            ++m_drawing.unknown[tag.substr(0, 40)];
    }

    static bool isHidden(const SvgElement& element)
    {
        const std::string& style = element.attribute("style");
        return element.attribute("display") == "none" || element.attribute("visibility") == "hidden" ||
               style.find("display:none") != std::string::npos || style.find("display: none") != std::string::npos;
    }

    /// A layer is called by its label, or by its id.
    void group(const SvgElement& element, SvgState state)
    {
        const std::string& label = element.attribute("label");
        const std::string& name = label.empty() ? element.attribute("id") : label;
        if (!name.empty())
            state.layer = drawnWords(name);
        children(element, state);
    }

    void use(const SvgElement& element, SvgState state)
    {
        const std::string& link = element.attribute("href");
        const auto target = link.starts_with('#') ? m_ids.find(link.substr(1)) : m_ids.end();
        if (target == m_ids.end() || state.uses >= deepestUse) {
            ++m_drawing.unknown[target == m_ids.end() ? "use of what is not in the file" : "use in use"];
            return;
        }
        m_limits.count(100); // each of them costs something, even when it draws nothing
        ++state.uses;
        state.map.translate(
            Vec2(svgLength(element.attribute("x")).value_or(0), svgLength(element.attribute("y")).value_or(0)));
        if (target->second->tag == "symbol")
            children(*target->second, state);
        else
            draw(*target->second, state);
    }

    void addText(const SvgElement& element, const SvgState& state)
    {
        m_limits.count(1);
        const SvgElement* placed = &element;
        if (element.attribute("x").empty() && !element.children.empty())
            placed = &element.children.front();
        const Vec2 at(svgLength(placed->attribute("x")).value_or(0), svgLength(placed->attribute("y")).value_or(0));
        const std::string words = drawnWords(trimmed(element.words));
        if (!words.empty())
            m_drawing.parts.front().texts.push_back({state.layer, state.map * at, words});
    }

    void take(DrawingPen& pen, bool closed, const SvgState& state, double circle = 0)
    {
        DrawnLine line = pen.line(state.layer, closed);
        m_limits.count(line.points.size());
        if (line.points.size() < 2)
            return;
        line.circle = circle * std::sqrt(std::abs(state.map.linear().determinant()));
        line.about = state.about;
        m_drawing.parts.front().lines.push_back(std::move(line));
    }

    bool addShape(const SvgElement& element, const SvgState& state)
    {
        const auto length = [&](std::string_view name) { return svgLength(element.attribute(name)).value_or(0); };
        DrawingPen pen(state.map);
        const std::string& tag = element.tag;
        if (tag == "path") {
            if (!drawSvgPath(element.attribute("d"), state.map,
                             [&](DrawingPen& drawn, bool closed) { take(drawn, closed, state); }))
                ++m_drawing.unknown["end of a path"];
        } else if (tag == "line") {
            pen.moveTo({length("x1"), length("y1")});
            pen.lineTo({length("x2"), length("y2")});
            take(pen, false, state);
        } else if (tag == "polyline" || tag == "polygon") {
            SvgNumbers numbers(element.attribute("points"));
            for (Vec2 at; numbers.number(at.x()) && numbers.number(at.y());)
                pen.empty() ? pen.moveTo(at) : pen.lineTo(at);
            take(pen, tag == "polygon", state);
        } else if (tag == "circle" || tag == "ellipse") {
            const double rx = length(tag == "circle" ? "r" : "rx"), ry = length(tag == "circle" ? "r" : "ry");
            pen.arcTo({length("cx"), length("cy")}, {rx, 0}, {0, ry}, 0, 2 * std::numbers::pi);
            take(pen, true, state, rx == ry ? rx : 0);
        } else if (tag == "rect") {
            rectangle(pen, {length("x"), length("y")}, {length("width"), length("height")},
                      {length("rx"), length("ry")});
            take(pen, true, state);
        } else {
            return false;
        }
        return true;
    }

    static void rectangle(DrawingPen& pen, const Vec2& at, const Vec2& size, Vec2 round)
    {
        if (round.x() <= 0 || round.y() <= 0)
            round = Vec2::Constant(std::max({0.0, round.x(), round.y()}));
        round = round.cwiseMin(size / 2);
        if (!(round.minCoeff() > 0)) {
            pen.moveTo(at);
            for (const Vec2& corner : {Vec2(size.x(), 0), size, Vec2(0, size.y())})
                pen.lineTo(at + corner);
            return;
        }
        const Vec2 inner = size - 2 * round;
        const std::array<Vec2, 4> centres{Vec2(inner.x(), 0), inner, Vec2(0, inner.y()), Vec2(0, 0)};
        for (int k = 0; k < 4; ++k) {
            const Vec2 centre = at + round + centres[static_cast<std::size_t>(k)];
            const double from = (k - 1) * std::numbers::pi / 2;
            const Vec2 start(centre.x() + round.x() * std::cos(from), centre.y() + round.y() * std::sin(from));
            pen.empty() ? pen.moveTo(start) : pen.lineTo(start);
            pen.smoothHere();
            pen.arcTo(centre, {round.x(), 0}, {0, round.y()}, from, std::numbers::pi / 2);
            pen.smoothHere();
        }
    }

    const SvgElement& m_root;
    DrawingLimits m_limits;
    Drawing m_drawing;
    std::map<std::string, const SvgElement*, std::less<>> m_ids;
};

} // namespace

Drawing readSvg(const FileBytes& bytes)
{
    const SvgElement root = readSvgTree(bytes);
    return SvgDrawer(root, bytes.watch()).draw();
}

} // namespace bolster
