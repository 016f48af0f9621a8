#include "DrawingPen.h"
#include "DrawingReaders.h"
#include "DrawnWords.h"
#include "SvgNumbers.h"
#include "SvgStyles.h"
#include "SvgTransforms.h"
#include "SvgTree.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bolster {

namespace {

using SvgMap = Eigen::Affine2d;

constexpr int deepestUse = 8;
constexpr double svgPixel = 25.4 / 96; // mm

/// What is drawn where it is used, or not at all.
constexpr std::array notDrawn{"defs",   "symbol",         "metadata",       "namedview", "style",
                              "desc",   "clipPath",       "marker",         "mask",      "pattern",
                              "filter", "linearGradient", "radialGradient", "script"};

/// Drawing programs give each shape an id, of its kind and a number: that is no name.
bool isGeneratedId(std::string_view id)
{
    constexpr std::array kinds{"path",  "rect",  "circle",    "ellipse", "line",  "polyline", "polygon",
                               "shape", "curve", "object",    "svg",     "SVGID", "use",      "Path",
                               "Shape", "Line",  "Rectangle", "Polygon", "XMLID", "g",        "layer"};
    id = id.substr(0, id.find_last_not_of("0123456789-_.") + 1);
    return id.empty() || std::ranges::find(kinds, id) != kinds.end();
}

/// What people read in Inkscape's and Illustrator's lists of objects.
std::string givenName(const SvgElement& element)
{
    for (const char* const attribute : {"label", "data-name"})
        if (const std::string& name = element.attribute(attribute); !name.empty())
            return drawnWords(name);
    const std::string& id = element.attribute("id");
    return isGeneratedId(id) ? std::string() : drawnWords(id);
}

/// What is handed down from an element to those in it.
struct SvgState {
    SvgMap map;
    Vec2 viewport = Vec2::Zero(); ///< its size, in user units; 0: not known
    std::string layer;
    std::vector<std::string> about;
    bool visible = true;
    int uses = 0;
};

class SvgDrawer {
public:
    SvgDrawer(const SvgElement& root, const ImportWatch& watch)
        : m_root(root)
        , m_styles(root)
        , m_limits(watch)
    {
        findIds(root);
    }

    Drawing draw()
    {
        m_drawing.parts.emplace_back();
        children(m_root, page());
        if (m_styles.notUnderstood() > 0)
            m_drawing.unknown["rule of a style sheet"] += m_styles.notUnderstood();
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

    /// Programs round both sizes: what is so near to one of the usual scales is meant to be that.
    static std::optional<double> usualScale(const Vec2& pixels)
    {
        for (const double scale : {1.0, 96 / 90.0, 96 / 72.0, 96 / 25.4, 96 / 2.54, 96.0})
            if (((pixels / scale).array() - 1).abs().maxCoeff() < 5e-4)
                return scale;
        return std::nullopt;
    }

    /// Percents are of a window, which says nothing of a pattern; of anything else somebody has meant something.
    void tellUnknownUnit(const std::string& length)
    {
        const std::string_view said = trimmed(length);
        if (said.empty() || said == "auto" || said.ends_with('%') || svgLength(length))
            return;
        m_drawing.notes.push_back(
            {QT_TRANSLATE_NOOP("Message",
                               "the size \"%1\" of the page is in no unit that is known and is left out: check the "
                               "size of the pieces"),
             {length.substr(0, 60)}});
    }

    /// Millimetres where the file says how large it is, else its own numbers; y up.
    SvgState page()
    {
        bool absolute = false;
        const auto width = svgLength(m_root.attribute("width"), &absolute);
        const auto height = svgLength(m_root.attribute("height"), &absolute);
        const auto box = svgViewBox(m_root.attribute("viewBox"));
        if (!box && !trimmed(m_root.attribute("viewBox")).empty())
            m_drawing.notes.push_back(
                {QT_TRANSLATE_NOOP("Message",
                                   "the viewBox \"%1\" is no four numbers and is left out: check the size of "
                                   "the pieces"),
                 {m_root.attribute("viewBox").substr(0, 60)}});
        for (const char* const side : {"width", "height"})
            tellUnknownUnit(m_root.attribute(side));
        SvgState state;
        state.viewport = {width.value_or(0), height.value_or(0)};
        Vec2 pixels(1, 1); // of one user unit
        if (box) {
            state.viewport = box->sizes();
            const Vec2 size(width.value_or(0), height.value_or(0));
            pixels = svgViewport(*box, size, m_root.attribute("preserveAspectRatio")).linear().diagonal();
            if (const auto usual = usualScale(size.cwiseQuotient(box->sizes())))
                pixels = Vec2::Constant(*usual);
            if (size.minCoeff() <= 0) // one of them tells as much
                pixels = Vec2::Constant(size.maxCoeff() > 0 ? size.cwiseQuotient(box->sizes()).maxCoeff() : 1);
        }
        if (absolute)
            m_drawing.unit = 1;
        else
            m_drawing.usualUnit = svgPixel * pixels.x();
        const Vec2 scale = absolute ? Vec2(svgPixel * pixels) : Vec2(pixels / pixels.x());
        state.map = SvgMap::Identity();
        state.map.scale(Vec2(scale.x(), -scale.y()));
        if (box)
            state.map.translate(Vec2(-box->min()));
        return state;
    }

    void children(const SvgElement& element, const SvgState& state)
    {
        for (const SvgElement& child : element.children)
            draw(child, state);
    }

    void draw(const SvgElement& element, const SvgState& outer)
    {
        const std::string& tag = element.tag;
        if (std::ranges::find(notDrawn, tag) != notDrawn.end())
            return;
        if (tag == "title") {
            if (!element.words.empty())
                m_drawing.texts.push_back("Style Name: " + element.words.substr(0, 200));
            return;
        }
        const SvgStyle style = m_styles.of(element);
        if (style.displayed == false) {
            ++m_drawing.unknown[std::string("hidden ").append(tag, 0, 40)];
            return;
        }
        const auto transform = svgTransform(style.transform ? *style.transform : element.attribute("transform"),
                                            style.origin.value_or(""));
        if (!transform) { // wherever it is, it is not where it would be without
            ++m_drawing.unknown[tag.substr(0, 40) + " whose transform cannot be read"];
            return;
        }
        SvgState state = outer;
        state.map = outer.map * *transform;
        state.visible = style.visible.value_or(outer.visible);
        for (const auto& [attribute, key] : {std::pair{"data-piece", "Piece Name: "},
                                             {"data-quantity", "Quantity: "},
                                             {"data-fabric", "Fabric: "},
                                             {"data-nap", "Nap: "},
                                             {"data-grain-tolerance", "Grain Tolerance: "},
                                             {"data-shrinkage", "Shrinkage: "},
                                             {"data-note", "Annotation: "}})
            if (const std::string& value = element.attribute(attribute); !value.empty())
                state.about.push_back(key + drawnWords(value));
        if (tag == "g" || tag == "a" || tag == "switch")
            group(element, std::move(state));
        else if (tag == "svg")
            viewport(element, element, std::move(state));
        else if (tag == "use")
            use(element, std::move(state));
        else if (!state.visible)
            ++m_drawing.unknown[std::string("hidden ").append(tag, 0, 40)];
        else if (tag == "text")
            addText(element, state);
        else if (m_called = givenName(element); !addShape(element, state))
            ++m_drawing.unknown[tag.substr(0, 40)];
    }

    /// A length of an element along an axis: 0, 1, or 2 for neither; 0 without.
    double length(const SvgElement& element, std::string_view name, int axis, const SvgState& state)
    {
        const std::string& text = element.attribute(name);
        const Vec2& size = state.viewport;
        const double whole = axis < 2 ? size[axis] : size.norm() / std::sqrt(2.0);
        const auto found = svgLength(text, nullptr, whole > 0 ? std::optional(whole) : std::nullopt);
        if (!found && !text.empty() && text != "auto")
            ++m_drawing.unknown["length that cannot be read"];
        return found.value_or(0);
    }
    Vec2 lengths(const SvgElement& element, std::string_view x, std::string_view y, const SvgState& state)
    {
        return {length(element, x, 0, state), length(element, y, 1, state)};
    }

    /// What is in `element`, in a viewport of its own, whose size another one may say: that which uses it.
    void viewport(const SvgElement& element, const SvgElement& sized, SvgState state)
    {
        if (element.tag == "svg")
            state.map.translate(lengths(element, "x", "y", state));
        const auto side = [&](std::string_view name, int axis) {
            for (const SvgElement* one : {&sized, &element})
                if (!one->attribute(name).empty() && one->attribute(name) != "auto")
                    return length(*one, name, axis, state);
            return state.viewport[axis];
        };
        const Vec2 size(side("width", 0), side("height", 1));
        const auto box = svgViewBox(element.attribute("viewBox"));
        if (box && size.minCoeff() > 0)
            state.map = state.map * svgViewport(*box, size, element.attribute("preserveAspectRatio"));
        state.viewport = box ? Vec2(box->sizes()) : size;
        group(element, std::move(state));
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
        state.map.translate(lengths(element, "x", "y", state));
        const SvgElement& used = *target->second;
        if (used.tag == "symbol")
            viewport(used, element, std::move(state));
        else if (used.tag == "svg" && &used != &m_root)
            viewport(used, element, std::move(state));
        else
            draw(used, state);
    }

    void addText(const SvgElement& element, const SvgState& state)
    {
        m_limits.count(1);
        const SvgElement* placed = &element;
        if (element.attribute("x").empty() && !element.children.empty())
            placed = &element.children.front();
        const Vec2 at = state.map * lengths(*placed, "x", "y", state);
        const std::string words = drawnWords(trimmed(element.words));
        if (!words.empty() && inReach(at))
            m_drawing.parts.front().texts.push_back({state.layer, at, words});
    }

    void take(DrawingPen& pen, bool closed, const SvgState& state, double circle = 0)
    {
        if (!pen.isInReach()) {
            ++m_drawing.unknown["line too far away"];
            return;
        }
        DrawnLine line = pen.line(state.layer, closed);
        m_limits.count(line.points.size());
        if (line.points.size() < 2)
            return;
        line.circle = circle * std::sqrt(std::abs(state.map.linear().determinant()));
        line.about = state.about;
        line.called = m_called;
        m_drawing.parts.front().lines.push_back(std::move(line));
    }

    bool addShape(const SvgElement& element, const SvgState& state)
    {
        DrawingPen pen(state.map);
        const std::string& tag = element.tag;
        if (tag == "path") {
            if (!drawSvgPath(element.attribute("d"), state.map,
                             [&](DrawingPen& drawn, bool closed) { take(drawn, closed, state); }))
                ++m_drawing.unknown["end of a path"];
        } else if (tag == "line") {
            pen.moveTo(lengths(element, "x1", "y1", state));
            pen.lineTo(lengths(element, "x2", "y2", state));
            take(pen, false, state);
        } else if (tag == "polyline" || tag == "polygon") {
            SvgNumbers numbers(element.attribute("points"));
            for (Vec2 at; numbers.number(at.x()) && numbers.number(at.y());)
                pen.empty() ? pen.moveTo(at) : pen.lineTo(at);
            if (!numbers.atEnd())
                ++m_drawing.unknown[std::string("end of a ").append(tag)];
            take(pen, tag == "polygon", state);
        } else if (tag == "circle" || tag == "ellipse") {
            const bool round = tag == "circle";
            const double rx = length(element, round ? "r" : "rx", round ? 2 : 0, state);
            const double ry = round ? rx : length(element, "ry", 1, state);
            if (rx < 0 || ry < 0) {
                ++m_drawing.unknown[tag + " without a radius"];
                return true;
            }
            pen.arcTo(lengths(element, "cx", "cy", state), {rx, 0}, {0, ry}, 0, 2 * std::numbers::pi);
            take(pen, true, state, rx == ry ? rx : 0);
        } else if (tag == "rect") {
            rectangle(pen, lengths(element, "x", "y", state), lengths(element, "width", "height", state),
                      lengths(element, "rx", "ry", state));
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
    SvgStyles m_styles;
    DrawingLimits m_limits;
    std::string m_called; ///< the shape that is read
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
