#include "DrawingPen.h"
#include "DrawingReaders.h"
#include "DrawnWords.h"
#include "DxfEntity.h"
#include "RationalSpline.h"

#include <cmath>
#include <set>

namespace bolster {

namespace {

using DxfMap = Eigen::Affine2d;

constexpr int deepestInsert = 8;
constexpr int mostCopies = 10'000; // of a block by one INSERT

double radians(double degrees)
{
    return degrees * std::numbers::pi / 180;
}

/// Entities that are drawn on a plane seen from below have x the other way round.
DxfMap seenFrom(const DxfEntity& entity)
{
    DxfMap map = DxfMap::Identity();
    if (entity.number(230, 1) < 0)
        map.linear() << -1, 0, 0, 1;
    return map;
}

std::string plainText(const std::string& text)
{
    // MTEXT: \P ends a line, other words behind a backslash end with a semicolon, braces group.
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '{' || text[i] == '}')
            continue;
        if (text[i] != '\\' || i + 1 == text.size()) {
            result += text[i];
            continue;
        }
        const char word = text[++i];
        if (word == 'P' || word == '~')
            result += word == 'P' ? '\n' : ' ';
        else if (std::string_view("ACfFHQTWp").find(word) != std::string_view::npos)
            i = std::min(text.find(';', i), text.size());
        else if (word == '\\' || word == '{' || word == '}')
            result += word;
    }
    return result;
}

class DxfDrawer {
public:
    DxfDrawer(const DxfFile& file, const ImportWatch& watch)
        : m_file(file)
        , m_limits(watch)
    {}

    Drawing draw()
    {
        drawEntities();
        drawUnused();
        m_drawing.unit = unit();
        if (m_file.endMissing)
            m_drawing.notes.push_back(
                {QT_TRANSLATE_NOOP(
                     "Message",
                     "the mark at the end of the file (EOF) is missing: look whether everything is there"),
                 {}});
        return std::move(m_drawing);
    }

private:
    /// Pieces that nobody put onto the sheet. What lies in another one of them is drawn with that.
    void drawUnused()
    {
        std::set<std::string> inOthers;
        for (const auto& [name, block] : m_file.blocks)
            for (const DxfEntity& entity : block.entities)
                if (entity.kind == "INSERT" && !m_inserted.contains(name))
                    inOthers.insert(entity.name);
        for (const bool outermost : {true, false})
            for (const std::string& name : m_file.blockNames)
                if (!m_inserted.contains(name) && !(outermost && inOthers.contains(name)) &&
                    !name.starts_with('*') && !name.starts_with('$'))
                    addPart(name, [&](DrawnPart& part) { addBlock(part, name, DxfMap::Identity(), "0", 0); });
    }

    /// AAMA and ASTM say "metric", which is millimetres for some; of our own files we know.
    bool isOurs() const
    {
        return std::ranges::any_of(m_drawing.texts, [](const std::string& words) {
            const auto [key, value] = keyAndValue(words);
            return key == "author" && value == "Bolster";
        });
    }

    std::optional<double> unit() const
    {
        switch (m_file.units) {
        case 1:
            return 25.4;
        case 2:
            return 304.8;
        case 4:
            return 1;
        case 5:
            return 10;
        case 6:
            return 1000;
        default:
            return isOurs() ? std::optional(1.0) : std::nullopt;
        }
    }

    void drawEntities()
    {
        DrawnPart loose;
        for (const DxfEntity& entity : m_file.entities) {
            const auto block = entity.kind == "INSERT" ? m_file.blocks.find(entity.name) : m_file.blocks.end();
            if (block != m_file.blocks.end() && hasLines(block->second))
                addPart(entity.name, [&](DrawnPart& part) { add(part, entity, DxfMap::Identity(), "0", 0); });
            else
                add(loose, entity, DxfMap::Identity(), "0", 0);
        }
        if (!loose.lines.empty() || !loose.dots.empty())
            m_drawing.parts.insert(m_drawing.parts.begin(), std::move(loose));
        else
            for (DrawnText& text : loose.texts)
                m_drawing.texts.push_back(std::move(text.words));
        if (!m_drawing.parts.empty() && m_drawing.parts.front().name.empty())
            for (const DrawnText& text : m_drawing.parts.front().texts)
                m_drawing.texts.push_back(text.words);
    }

    static bool hasLines(const DxfBlock& block)
    {
        return std::ranges::any_of(block.entities, [](const DxfEntity& entity) { return entity.kind != "TEXT"; });
    }

    template <class Fill>
    void addPart(const std::string& name, const Fill& fill)
    {
        DrawnPart part;
        part.name = name;
        fill(part);
        if (!part.empty())
            m_drawing.parts.push_back(std::move(part));
    }

    void addBlock(DrawnPart& part, const std::string& name, const DxfMap& map, const std::string& layer, int depth)
    {
        const auto block = m_file.blocks.find(name);
        if (block == m_file.blocks.end()) {
            ++m_drawing.unknown[std::string("INSERT ").append(name, 0, 80)];
            return;
        }
        m_inserted.insert(name);
        for (const DxfEntity& entity : block->second.entities)
            add(part, entity, map, layer, depth);
    }

    void insert(DrawnPart& part, const DxfEntity& entity, const DxfMap& outer, const std::string& layer, int depth)
    {
        if (depth >= deepestInsert) {
            ++m_drawing.unknown["INSERT in INSERT"];
            return;
        }
        const auto block = m_file.blocks.find(entity.name);
        const Vec2 base = block == m_file.blocks.end() ? Vec2(0, 0) : block->second.base;
        const int columns = std::max(1, entity.integer(70, 1)), rows = std::max(1, entity.integer(71, 1));
        if (static_cast<std::int64_t>(columns) * rows > mostCopies)
            refuseFile({},
                       QT_TRANSLATE_NOOP("Message",
                                         "%1: \"%2\" is inserted more often than a pattern needs (over %3 times)"),
                       {excerpt(entity.name), std::to_string(mostCopies)});
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column) {
                m_limits.count(1);
                DxfMap map = outer * seenFrom(entity);
                map.translate(entity.point(10));
                map.rotate(radians(entity.number(50)));
                map.translate(Vec2(column * entity.number(44), row * entity.number(45)));
                map.scale(Vec2(entity.number(41, 1), entity.number(42, 1)));
                map.translate(Vec2(-base));
                addBlock(part, entity.name, map, layer, depth + 1);
            }
    }

    void add(DrawnPart& part, const DxfEntity& entity, const DxfMap& outer, const std::string& outerLayer,
             int depth)
    {
        if (entity.integer(67) == 1) { // on paper
            ++m_drawing.unknown[entity.kind.substr(0, 40) + " (paper)"];
            return;
        }
        if (entity.integer(60) == 1) {
            ++m_drawing.unknown[std::string("hidden ").append(entity.kind, 0, 40)];
            return;
        }
        const std::string& layer = entity.layer == "0" || entity.layer.empty() ? outerLayer : entity.layer;
        const std::string& kind = entity.kind;
        if (kind == "INSERT") {
            insert(part, entity, outer, layer, depth);
            return;
        }
        const DxfMap map = outer * seenFrom(entity);
        if (kind == "TEXT" || kind == "MTEXT" || kind == "ATTRIB")
            addText(part, entity, map, layer);
        else if (kind == "POINT")
            addDot(part, entity, map, layer);
        else if (!addLine(part, entity, map, layer) && kind != "ATTDEF" && kind != "VIEWPORT")
            ++m_drawing.unknown[kind.substr(0, 40)];
    }

    void addText(DrawnPart& part, const DxfEntity& entity, const DxfMap& map, const std::string& layer)
    {
        m_limits.count(1);
        const std::string text = entity.kind == "MTEXT" ? plainText(entity.text) : entity.text;
        for (std::size_t at = 0; at <= text.size();) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            if (const std::string_view line = trimmed(std::string_view(text).substr(at, end - at));
                !line.empty() && inReach(map * entity.point(10)))
                part.texts.push_back({layer, map * entity.point(10), std::string(line)});
            at = end + 1;
        }
    }

    void addDot(DrawnPart& part, const DxfEntity& entity, const DxfMap& map, const std::string& layer)
    {
        m_limits.count(1);
        if (!inReach(map * entity.point(10))) {
            ++m_drawing.unknown["POINT too far away"];
            return;
        }
        DrawnDot dot{layer, map * entity.point(10), entity.number(30), entity.number(39), {}};
        if (entity.has(50)) {
            const double angle = radians(entity.number(50));
            const Vec2 way = map.linear() * Vec2(std::cos(angle), std::sin(angle));
            dot.angle = std::atan2(way.y(), way.x()) * 180 / std::numbers::pi;
        }
        part.dots.push_back(std::move(dot));
    }

    bool addLine(DrawnPart& part, const DxfEntity& entity, const DxfMap& map, const std::string& layer)
    {
        DrawingPen pen(map);
        bool closed = false;
        double circle = 0;
        if (entity.kind == "LINE") {
            pen.moveTo(entity.point(10));
            pen.lineTo(entity.point(11));
        } else if (entity.kind == "ARC" || entity.kind == "CIRCLE") {
            if (entity.number(40) <= 0) {
                ++m_drawing.unknown[entity.kind + " without a radius"];
                return true;
            }
            closed = entity.kind == "CIRCLE";
            arc(pen, entity, closed);
            circle = closed ? entity.number(40) * std::sqrt(std::abs(map.linear().determinant())) : 0;
        } else if (entity.kind == "ELLIPSE") {
            closed = ellipse(pen, entity);
        } else if (entity.kind == "LWPOLYLINE") {
            closed = (entity.integer(70) & 1) != 0;
            lightPolyline(pen, entity, closed);
        } else if (entity.kind == "POLYLINE") {
            const int flags = entity.integer(70);
            if ((flags & (16 | 64)) != 0)
                return false; // a mesh
            closed = (flags & 1) != 0;
            polyline(pen, entity, closed, (flags & (2 | 4)) != 0);
        } else if (entity.kind == "SPLINE") {
            closed = spline(pen, entity);
        } else {
            return false;
        }
        if (!pen.isInReach()) {
            ++m_drawing.unknown[entity.kind + " too far away"];
            return true;
        }
        DrawnLine line = pen.line(layer, closed);
        m_limits.count(line.points.size());
        if (line.points.size() < 2)
            return true; // nothing to be seen
        line.circle = circle;
        line.about = entity.comments;
        part.lines.push_back(std::move(line));
        return true;
    }

    static void arc(DrawingPen& pen, const DxfEntity& entity, bool whole)
    {
        const double radius = entity.number(40);
        const double from = whole ? 0 : radians(entity.number(50)), to = radians(entity.number(51));
        double sweep = std::fmod(to - from, 2 * std::numbers::pi);
        if (sweep <= 0)
            sweep += 2 * std::numbers::pi;
        pen.arcTo(entity.point(10), {radius, 0}, {0, radius}, from, whole ? 2 * std::numbers::pi : sweep);
    }

    static bool ellipse(DrawingPen& pen, const DxfEntity& entity)
    {
        const Vec2 major = entity.point(11);
        const double ratio = entity.number(40, 1), from = entity.number(41),
                     to = entity.number(42, 2 * std::numbers::pi);
        double sweep = std::fmod(to - from, 2 * std::numbers::pi);
        const bool whole = std::abs(sweep) < 1e-6 || std::abs(sweep) > 2 * std::numbers::pi - 1e-6;
        if (sweep <= 0 || whole)
            sweep = whole ? 2 * std::numbers::pi : sweep + 2 * std::numbers::pi;
        pen.arcTo(entity.point(10), major, ratio * Vec2(-major.y(), major.x()), from, sweep);
        return whole;
    }

    /// A bulge belongs to the vertex before it.
    static void bulged(DrawingPen& pen, const std::vector<std::pair<Vec2, double>>& vertices, bool closed)
    {
        if (vertices.empty())
            return;
        pen.moveTo(vertices.front().first);
        for (std::size_t i = 1; i < vertices.size(); ++i)
            pen.bulgeTo(vertices[i].first, vertices[i - 1].second);
        if (closed && vertices.back().second != 0)
            pen.bulgeTo(vertices.front().first, vertices.back().second);
    }

    static void lightPolyline(DrawingPen& pen, const DxfEntity& entity, bool closed)
    {
        std::vector<std::pair<Vec2, double>> vertices;
        for (const auto& [code, value] : entity.numbers)
            if (code == 10)
                vertices.emplace_back(Vec2(value, 0), 0);
            else if (code == 20 && !vertices.empty())
                vertices.back().first.y() = value;
            else if (code == 42 && !vertices.empty())
                vertices.back().second = value;
        bulged(pen, vertices, closed);
    }

    static void polyline(DrawingPen& pen, const DxfEntity& entity, bool closed, bool smooth)
    {
        std::vector<std::pair<Vec2, double>> vertices;
        std::vector<Vec2> points;
        for (const DxfEntity& vertex : entity.vertices)
            if ((vertex.integer(70) & 16) == 0) { // not of the frame that shapes a spline
                vertices.emplace_back(vertex.point(10), vertex.number(42));
                points.push_back(vertex.point(10));
            }
        if (!smooth) {
            bulged(pen, vertices, closed);
            return;
        }
        if (closed && !points.empty())
            points.push_back(points.front());
        pen.smoothTo(points);
    }

    bool spline(DrawingPen& pen, const DxfEntity& entity)
    {
        const int flags = entity.integer(70);
        RationalSpline curve{entity.integer(71, 3), entity.points(10), entity.all(40), entity.all(41)};
        if (curve.isSound())
            curve.draw(pen);
        else if (const std::vector<Vec2> fitted = entity.points(11); fitted.size() > 1)
            pen.smoothTo(fitted);
        else
            ++m_drawing.unknown["SPLINE without knots"];
        return (flags & 1) != 0;
    }

    const DxfFile& m_file;
    DrawingLimits m_limits;
    Drawing m_drawing;
    std::set<std::string> m_inserted;
};

} // namespace

Drawing readDxf(const FileBytes& bytes)
{
    const DxfFile file = readDxfFile(bytes);
    return DxfDrawer(file, bytes.watch()).draw();
}

} // namespace bolster
