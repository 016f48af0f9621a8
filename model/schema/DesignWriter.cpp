// The canonical text of a design.
#include "DesignJson.h"

#include "JsonText.h"
#include "Kinds.h"

#include <bit>
#include <cmath>

namespace bolster {

namespace {

using json::text;

// Bit for bit, so that -0 is written when the default is 0.
bool same(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

template <class Values, class ToText>
std::string listOf(const Values& values, const ToText& toText)
{
    std::string line;
    for (const auto& value : values)
        line.append(line.empty() ? "" : ", ").append(toText(value));
    return "[" + line + "]";
}

template <class Vector>
std::string listText(const Vector& values)
{
    return listOf(values, text);
}

template <class Vector>
bool sameVector(const Vector& a, const Vector& b)
{
    for (Eigen::Index i = 0; i < a.size(); ++i)
        if (!same(a[i], b[i]))
            return false;
    return true;
}

// One JSON object, key by key.
class Line {
public:
    Line& raw(std::string_view key, std::string_view value)
    {
        m_text.append(m_text.empty() ? "" : ", ").append("\"").append(key).append("\": ").append(value);
        return *this;
    }
    bool empty() const { return m_text.empty(); }
    std::string done() const { return "{" + m_text + "}"; }

private:
    std::string m_text;
};

template <int Dim>
std::string curveText(const BSpline<Dim>& curve)
{
    std::string points;
    for (const auto& point : curve.points())
        points.append(points.empty() ? "" : ", ").append(listText(point));
    Line line;
    line.raw("degree", std::to_string(curve.degree()))
        .raw("closed", curve.closed() ? "true" : "false")
        .raw("points", "[" + points + "]");
    if (curve.hasDefaultKnots())
        return line.done();
    if (const auto corners = curve.cornerIndices())
        return line.raw("corners", listText(*corners)).done();
    return line.raw("knots", listText(curve.knots())).done();
}

/// Writes the fields of a value, beside it the usual one.
class FieldWriter {
public:
    explicit FieldWriter(Line& line)
        : m_line(line)
    {}

    void field(const Field& f, const Number&, double value, double usual)
    {
        put(f, !same(value, usual), [&] { return text(value); });
    }
    void field(const Field& f, const Flag&, bool value, bool usual)
    {
        put(f, value != usual, [&] { return value ? "true" : "false"; });
    }
    void field(const Field& f, const Text&, const std::string& value, const std::string& usual)
    {
        put(f, value != usual, [&] { return json::quoted(value); });
    }
    void field(const Field& f, const Color&, const std::string& value, const std::string& usual)
    {
        field(f, Text{}, value, usual);
    }
    void field(const Field& f, const FileName&, const std::string& value, const std::string& usual)
    {
        field(f, Text{}, value, usual);
    }
    void field(const Field& f, const Names&, const std::vector<std::string>& value, const std::vector<std::string>&)
    {
        put(f, !value.empty(), [&] { return listOf(value, json::quoted); });
    }
    template <class Enum>
    void field(const Field& f, const Words& words, const Enum& value, const Enum& usual)
    {
        put(f, value != usual, [&] { return json::quoted(words.keys[static_cast<std::size_t>(value)]); });
    }
    template <class T>
    void field(const Field& f, const Refers<T>&, const ElementId& value, const ElementId& usual)
    {
        put(f, value != usual, [&] { return idText(value); });
    }
    template <class T>
    void field(const Field& f, const Refers<T>&, const std::vector<ElementId>& value, const std::vector<ElementId>&)
    {
        put(f, !value.empty(), [&] { return listOf(value, idText); });
    }
    template <class Vector>
    void field(const Field& f, const Coordinates&, const Vector& value, const Vector& usual)
    {
        put(f, !sameVector(value, usual), [&] { return listText(value); });
    }
    template <class Vector>
    void field(const Field& f, const Direction&, const Vector& value, const Vector& usual)
    {
        field(f, Coordinates{}, value, usual);
    }
    void field(const Field& f, const Turn&, const Quat& value, const Quat& usual)
    {
        const auto wxyz = [](const Quat& q) { return Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()); };
        field(f, Coordinates{}, wxyz(value), wxyz(usual));
    }
    template <int Dim>
    void field(const Field& f, const Curve&, const BSpline<Dim>& value, const BSpline<Dim>&)
    {
        put(f, !value.empty(), [&] { return curveText(value); });
    }
    using Range = std::optional<std::pair<double, double>>;
    void field(const Field& f, const CurveRange& form, const Range& value, const Range&)
    {
        if (value)
            m_line.raw(f.key, text(value->first)).raw(form.endKey, text(value->second));
    }
    void field(const Field& f, const Directions& form, const Orientation& value, const Orientation&)
    {
        const auto& directions = value.directions;
        if (!directions.empty())
            m_line.raw(value.kind == Orientation::Kind::Normal ? f.key : form.tangentKey,
                       directions.size() == 1 ? listText(directions.front()) : listOf(directions, listText<Vec3>));
    }
    void field(const Field& f, const PointNumbers&, const std::vector<int>& value, const std::vector<int>&)
    {
        put(f, !value.empty(), [&] { return listOf(value, [](int point) { return std::to_string(point); }); });
    }
    void field(const Field& f, const Planes&, const std::vector<HalfSpace>& value, const std::vector<HalfSpace>&)
    {
        put(f, !value.empty(), [&] {
            return listOf(value, [](const HalfSpace& h) {
                return listText(Eigen::Vector4d(h.normal.x(), h.normal.y(), h.normal.z(), h.distance));
            });
        });
    }

    template <class T>
    void group(const Field& f, const T& value, const T& usual)
    {
        within(f, [&](FieldWriter& inner) { inner.part({}, value, usual); });
    }
    template <class T>
    void group(const Field& f, const std::optional<T>& value, const std::optional<T>&)
    {
        if (value)
            m_line.raw(f.key, objectText(*value));
    }
    template <class Write>
    void within(const Field& f, Write write)
    {
        Line inner;
        FieldWriter writer(inner);
        write(writer);
        put(f, !inner.empty(), [&] { return inner.done(); });
    }
    template <class T>
    void part(const Field&, const T& value, T usual)
    {
        Description<T>::of(*this, value, usual);
    }
    template <class T>
    void list(const Field& f, const Entries&, const std::vector<T>& value, const std::vector<T>&)
    {
        put(f, !value.empty(), [&] { return listOf(value, objectText<T>); });
    }
    template <class T>
    void usual(const T& value, T& usual)
    {
        usual = usualOf(value);
    }

private:
    template <class T>
    static std::string objectText(const T& value)
    {
        Line line;
        FieldWriter(line).part({}, value, T{});
        return line.done();
    }
    static std::string idText(ElementId id) { return std::to_string(number(id)); }
    template <class ToText>
    void put(const Field& f, bool unusual, const ToText& toText)
    {
        if (unusual || f.presence != Presence::Unusual)
            m_line.raw(f.key, toText());
    }

    Line& m_line;
};

} // namespace

std::string writeElement(ElementId id, const Element& element)
{
    if (const auto* quarantined = std::get_if<Quarantined>(&element))
        return quarantined->text;
    Line line;
    if (id != settingsId)
        line.raw("id", std::to_string(number(id))).raw("kind", json::quoted(kindName(element)));
    FieldWriter writer(line);
    std::visit([&]<class T>(const T& value) { writer.part({}, value, T{}); }, element);
    return line.done();
}

namespace {

/// As it stands in the list of elements. The text of a quarantined one comes from anybody: what is no JSON there
/// would make all of the design unreadable, so it is written as a text in quotes, which is quarantined again.
std::string listedElement(ElementId id, const Element& element)
{
    const std::string text = writeElement(id, element);
    if (!std::holds_alternative<Quarantined>(element))
        return text;
    Message wrong;
    const bool fits = json::Document::parse(text, wrong) && json::Document::parse("[[" + text + "]]", wrong);
    return fits ? text : json::quoted(text);
}

} // namespace

std::string writeDesign(const Design& design)
{
    std::string elements;
    for (const auto& [id, element] : design.elements())
        elements.append(elements.empty() ? "\n  " : ",\n  ").append(listedElement(id, *element));
    return "{\"format\": \"bolster-design\", \"version\": 1, \"unit\": \"mm\",\n \"settings\": " +
           writeElement(settingsId, *design.element(settingsId)) + ",\n \"elements\": [" + elements + "]}\n";
}

} // namespace bolster
