#include "DesignSchema.h"

#include "JsonText.h"
#include "Kinds.h"

namespace bolster {

namespace {

using Lines = std::vector<std::string>;

std::string joined(const Lines& lines, const std::string& between)
{
    std::string text;
    for (const std::string& line : lines)
        text.append(text.empty() ? "" : between).append(line);
    return text;
}

std::string quotedList(const Lines& words)
{
    Lines all;
    for (const std::string& word : words)
        all.push_back(json::quoted(word));
    return "[" + joined(all, ", ") + "]";
}

using json::text;

std::string limits(double least, double most, bool least0 = false)
{
    return std::string(R"("type": "number")") + (least0 ? R"(, "exclusiveMinimum": )" : R"(, "minimum": )") +
           text(least) + R"(, "maximum": )" + text(most);
}

const char* unitText(Unit unit)
{
    switch (unit) {
    case Unit::Millimetres:
        return "mm";
    case Unit::Degrees:
        return "degrees";
    case Unit::Percent:
        return "%";
    case Unit::MillimetresPerUnit:
    case Unit::None:
        break;
    }
    return "";
}

const std::string idType = R"("$ref": "#/$defs/id")";
const std::string coordinateType = R"("$ref": "#/$defs/coordinate")";

/// Gathers what stands in an object, from its usual values.
class SchemaWalker {
public:
    void field(const Field& f, const Number& form, const double& usual)
    {
        const bool anywhere = form.least == -noLimit;
        put(f, anywhere ? coordinateType : limits(form.least, form.most, !form.checked), text(usual), form.unit);
    }
    void field(const Field& f, const Flag&, const bool& usual)
    {
        put(f, R"("type": "boolean")", usual ? "true" : "false");
    }
    void field(const Field& f, const Text&, const std::string&) { put(f, R"("type": "string")"); }
    void field(const Field& f, const Color&, const std::string& usual)
    {
        put(f, R"("$ref": "#/$defs/color")", usual.empty() ? "" : json::quoted(usual));
    }
    void field(const Field& f, const FileName&, const std::string&) { put(f, R"("$ref": "#/$defs/file")"); }
    void field(const Field& f, const Names&, const Lines&)
    {
        put(f, R"("type": "array", "minItems": 1, "items": {"type": "string"})");
    }
    template <class Enum>
    void field(const Field& f, const Words& words, const Enum& usual)
    {
        put(f, R"("enum": )" + quotedList(Lines(words.keys.begin(), words.keys.end())),
            json::quoted(words.keys[static_cast<std::size_t>(usual)]));
    }
    template <class T>
    void field(const Field& f, const Refers<T>&, const ElementId&)
    {
        put(f, idType);
    }
    template <class T>
    void field(const Field& f, const Refers<T>&, const std::vector<ElementId>&)
    {
        put(f, R"("type": "array", "minItems": 1, "items": {)" + idType + "}");
    }
    template <class Vector>
    void field(const Field& f, const Coordinates& form, const Vector& usual)
    {
        const std::string item = form.least == -largestCoordinate ? coordinateType : limits(form.least, form.most);
        put(f, tuple(usual.size(), item), listText(usual), form.unit);
    }
    template <class Vector>
    void field(const Field& f, const Direction&, const Vector& usual)
    {
        put(f, tuple(usual.size(), R"("type": "number")"), listText(usual));
    }
    void field(const Field& f, const Turn&, const Quat&)
    {
        put(f, tuple(4, R"("type": "number", "minimum": -1.001, "maximum": 1.001)"), "[1, 0, 0, 0]");
    }
    template <int Dim>
    void field(const Field& f, const Curve& form, const BSpline<Dim>&)
    {
        put(f, std::string(R"("$ref": "#/$defs/)") +
                   (form.outline ? "outline"
                    : Dim == 2   ? "plane_curve"
                                 : "curve") +
                   '"');
    }
    template <class Value>
    void field(const Field& f, const CurveRange& form, const Value&)
    {
        put(f, coordinateType);
        add(form.endKey, "{" + coordinateType + "}");
        m_rules.push_back(R"("dependentRequired": {")" + std::string(f.key) + R"(": [")" + form.endKey +
                          R"("], ")" + form.endKey + R"(": [")" + f.key + R"("]})");
    }
    void field(const Field& f, const Directions& form, const Orientation&)
    {
        put(f, R"("$ref": "#/$defs/directions")");
        add(form.tangentKey,
            R"({"$ref": "#/$defs/directions", "description": "likewise, a direction that lies in the )"
            R"(tangent plane"})");
        m_rules.push_back(R"("not": {"required": )" + quotedList({f.key, form.tangentKey}) + "}");
    }
    void field(const Field& f, const PointNumbers&, const std::vector<int>&)
    {
        put(f, R"("type": "array", "minItems": 1, "items": {"type": "integer", "minimum": 0, "maximum": )" +
                   std::to_string(2 * mostCurvePoints - 1) + "}");
    }
    void field(const Field& f, const Planes& form, const std::vector<HalfSpace>&)
    {
        put(f, R"("type": "array", "maxItems": )" + std::to_string(form.most) + R"(, "items": {)" +
                   tuple(4, coordinateType) + "}");
    }

    template <class T>
    void group(const Field& f, const T& usual)
    {
        SchemaWalker inner;
        inner.part({}, usual);
        put(f, inner.members());
    }
    template <class T>
    void group(const Field& f, const std::optional<T>&)
    {
        group(f, T{});
    }
    template <class T>
    void part(const Field&, const T& usual)
    {
        Description<T>::of(*this, usual);
    }
    template <class Walk>
    void within(const Field& f, Walk walk)
    {
        SchemaWalker inner;
        walk(inner);
        put(f, inner.members());
    }
    template <class T>
    void list(const Field& f, const Entries& form, const std::vector<T>&)
    {
        SchemaWalker inner;
        inner.part({}, T{});
        std::string type = R"("type": "array")";
        if (!form.mayBeEmpty)
            type += R"(, "minItems": 1)";
        if (form.most != Entries{}.most)
            type += R"(, "maxItems": )" + std::to_string(form.most);
        put(f, type + R"(, "items": {)" + inner.members() + "}");
    }
    /// From here on the usual values depend on another field.
    template <class T>
    void usual(const T&)
    {
        m_sameForAll = false;
    }

    /// A key that every element has.
    void heading(const std::string& key, const std::string& schema)
    {
        add(key, schema);
        m_required.push_back(key);
    }
    std::string members() const
    {
        std::string all = R"("type": "object", )";
        if (!m_required.empty())
            all += R"("required": )" + quotedList(m_required) + ", ";
        for (const std::string& rule : m_rules)
            all += rule + ", ";
        return all + R"("additionalProperties": false, "properties": {)" + joined(m_properties, ",") + "}";
    }

private:
    template <class Vector>
    static std::string listText(const Vector& values)
    {
        Lines all;
        for (const double value : values)
            all.push_back(text(value));
        return "[" + joined(all, ", ") + "]";
    }
    static std::string tuple(Eigen::Index count, const std::string& item)
    {
        return R"("type": "array", "minItems": )" + std::to_string(count) + R"(, "maxItems": )" +
               std::to_string(count) + R"(, "items": {)" + item + "}";
    }
    void add(const std::string& key, const std::string& schema)
    {
        m_properties.push_back("\n        " + json::quoted(key) + ": " + schema);
    }
    void put(const Field& f, std::string schema, const std::string& usual = {}, Unit unit = Unit::None)
    {
        if (!usual.empty() && f.presence != Presence::Required && m_sameForAll)
            schema += R"(, "default": )" + usual;
        Lines said;
        for (const char* what : {f.meaning, unitText(unit)})
            if (*what)
                said.emplace_back(what);
        if (!said.empty())
            schema += R"(, "description": )" + json::quoted(joined(said, ", "));
        add(f.key, "{" + schema + "}");
        if (f.presence == Presence::Required)
            m_required.emplace_back(f.key);
        if (!f.unless[0])
            return;
        Lines either = {R"({"required": [")" + std::string(f.key) + R"("]})"};
        for (const char* key : f.unless)
            either.push_back(R"({"required": [")" + std::string(key) + R"("]})");
        m_rules.push_back(R"("anyOf": [)" + joined(either, ", ") + "]");
    }

    Lines m_properties;
    Lines m_required;
    Lines m_rules;
    bool m_sameForAll = true;
};

template <class T>
std::string schemaOf()
{
    SchemaWalker walker;
    if constexpr (isWritten<T>) {
        walker.heading("id", "{" + idType + "}");
        walker.heading("kind", R"({"const": )" + json::quoted(Description<T>::word) + "}");
    }
    walker.part({}, T{});
    return "{" + walker.members() + "}";
}

std::string curveSchema(const char* point, const char* closed)
{
    return std::string(
               R"({"type": "object", "required": ["degree", "closed", "points"], "additionalProperties": false,
      "properties": {
        "degree": {"enum": [1, 2, 3]},
        "closed": )") +
           closed + R"(,
        "points": {"type": "array", "minItems": 2, "maxItems": )" +
           std::to_string(mostCurvePoints) + R"(, "items": {"$ref": "#/$defs/)" + point + R"("}},
        "knots": {"type": "array", "minItems": 4, "items": {"$ref": "#/$defs/coordinate"}},
        "corners": {"type": "array", "minItems": 1, "items": {"type": "integer", "minimum": 0}}},
      "not": {"required": ["knots", "corners"]},
      "dependentSchemas": {"corners": {"properties": {"degree": {"const": 3}, "closed": {"const": true}}}},
      "allOf": [
        {"if": {"properties": {"closed": {"const": true}}}, "then": {"properties": {"points": {"minItems": 3}}}},
        {"if": {"properties": {"degree": {"const": 3}, "closed": {"const": false}}},
         "then": {"properties": {"points": {"minItems": 4}}}},
        {"if": {"properties": {"degree": {"const": 2}, "closed": {"const": false}}},
         "then": {"properties": {"points": {"minItems": 3}}}}]})";
}

/// What the fields of several kinds are made of.
std::string parts()
{
    return R"(    "id": {"type": "integer", "minimum": 1, "maximum": )" + std::to_string(largestElementId) + R"(},
    "coordinate": {)" +
           limits(-largestCoordinate, largestCoordinate) + R"(},
    "color": {"type": "string", "pattern": "^#[0-9a-fA-F]{6}$"},
    "file": {"type": "string", "pattern": "^(?!/|.:)(?!(.*/)?\\.\\.(/|$))[^\\\\\\u0000-\\u001f]+$"},
    "point2": {"type": "array", "minItems": 2, "maxItems": 2, "items": {"$ref": "#/$defs/coordinate"}},
    "point3": {"type": "array", "minItems": 3, "maxItems": 3, "items": {"$ref": "#/$defs/coordinate"}},
    "directions": {"oneOf": [
      {"$ref": "#/$defs/point3"},
      {"type": "array", "minItems": 1, "maxItems": 10000, "items": {"$ref": "#/$defs/point3"}}]},
    "outline": )" +
           curveSchema("point2", R"({"const": true})") + R"(,
    "plane_curve": )" +
           curveSchema("point2", R"({"type": "boolean"})") + R"(,
    "curve": )" +
           curveSchema("point3", R"({"type": "boolean"})");
}

} // namespace

std::string designSchema()
{
    Lines words, choices, kinds{parts()};
    eachWrittenKind([&]<class T>() {
        const std::string word = Description<T>::word;
        words.push_back(word);
        choices.push_back(R"(          {"if": {"properties": {"kind": {"const": ")" + word +
                          R"("}}, "required": ["kind"]}, "then": {"$ref": "#/$defs/)" + word + R"("}})");
        kinds.push_back("    " + json::quoted(word) + ": " + schemaOf<T>());
    });
    return R"({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "Bolster design, version 1",
  "description": "docs/design-json.md says what everything means; references and shapes are checked by the program.",
  "type": "object",
  "required": ["format", "version", "elements"],
  "additionalProperties": false,
  "properties": {
    "format": {"const": "bolster-design"},
    "version": {"const": 1},
    "unit": {"const": "mm", "default": "mm"},
    "settings": )" +
           schemaOf<Settings>() + R"(,
    "elements": {
      "type": "array",
      "items": {
        "type": "object",
        "required": ["id", "kind"],
        "properties": {"kind": {"enum": )" +
           quotedList(words) + R"(}},
        "allOf": [
)" + joined(choices, ",\n") +
           R"(]
      }
    }
  },
  "$defs": {
)" + joined(kinds, ",\n") +
           R"(
  }
}
)";
}

} // namespace bolster
