#include "ElementReader.h"

#include "Kinds.h"

#include <algorithm>
#include <cmath>

namespace bolster::json {

namespace {

template <int Dim>
std::vector<Eigen::Matrix<double, Dim, 1>> pointsIn(Fields& fields)
{
    std::vector<Eigen::Matrix<double, Dim, 1>> points;
    const Value* list = fields.required("points");
    const std::string field = fields.fieldOf("points");
    if (list && !list->isArray())
        fields.report().add(field, {QT_TRANSLATE_NOOP("Message", "must be a list of points in square brackets")});
    else if (list && list->size() > mostCurvePoints)
        fields.report().add(field, {QT_TRANSLATE_NOOP("Message", "a curve has at most %1 points"),
                                    {std::to_string(mostCurvePoints)}});
    else if (list)
        list->eachItem([&](std::size_t i, const Value& item) {
            points.push_back(
                vectorIn<Dim>(item, field + "[" + std::to_string(i) + "]", fields.report(), largestCoordinate));
        });
    return points;
}

// Calls visit(item, its field) for each item of an optional list.
template <class Visit>
void eachOptional(Fields& fields, std::string_view key, Visit visit)
{
    const Value* list = fields.optional(key);
    const std::string field = fields.fieldOf(key);
    if (list && !list->isArray())
        fields.report().add(field, {QT_TRANSLATE_NOOP("Message", "must be a list of numbers in square brackets")});
    if (list && list->isArray())
        list->eachItem(
            [&](std::size_t i, const Value& item) { visit(item, field + "[" + std::to_string(i) + "]"); });
}

std::vector<double> knotsIn(Fields& fields)
{
    std::vector<double> knots;
    eachOptional(fields, "knots", [&](const Value& item, const std::string& field) {
        knots.push_back(numberIn(item, field, fields.report(), largestCoordinate));
    });
    return knots;
}

std::vector<int> cornersIn(Fields& fields, int pointCount)
{
    std::vector<int> corners;
    eachOptional(fields, "corners", [&](const Value& item, const std::string& field) {
        corners.push_back(integerIn(item, field, fields.report(), 0, std::max(pointCount - 1, 0)));
    });
    return corners;
}

// An empty list of knots or corners is a mistake, not a wish for the default.
void refuseEmpty(Fields& fields, std::string_view key)
{
    const Value* list = fields.optional(key);
    if (list && list->isArray() && list->size() == 0)
        fields.report().add(fields.fieldOf(key), {QT_TRANSLATE_NOOP("Message", "the list is empty; leave it out")});
}

/// A curve, empty when something is wrong with it.
template <int Dim>
BSpline<Dim> readCurve(Fields& parent, std::string_view key)
{
    const Value* object = parent.required(key);
    Report& report = parent.report();
    if (!object)
        return {};
    if (!object->isObject()) {
        report.add(parent.fieldOf(key),
                   {QT_TRANSLATE_NOOP("Message", "must be a curve in braces, with degree, closed "
                                                 "and points")});
        return {};
    }
    const std::size_t before = report.count();
    const auto sound = [&] { return report.count() == before; };
    Fields fields(*object, parent.fieldOf(key) + ".", report);
    const Value* degreeValue = fields.required("degree");
    const int degree = degreeValue ? integerIn(*degreeValue, fields.fieldOf("degree"), report, 1, 3) : 1;
    const bool closed = fields.flag("closed");
    const auto points = pointsIn<Dim>(fields);
    const std::vector<double> knots = knotsIn(fields);
    const std::vector<int> corners = cornersIn(fields, static_cast<int>(points.size()));
    refuseEmpty(fields, "knots");
    refuseEmpty(fields, "corners");
    if (fields.has("knots") && fields.has("corners"))
        report.add(fields.fieldOf("corners"), {QT_TRANSLATE_NOOP("Message", "a curve has either corners or knots; "
                                                                            "remove one of them")});
    fields.finish();

    using Curve = BSpline<Dim>;
    const auto require = [&](std::string_view field, const std::optional<Message>& wrong) {
        if (wrong)
            report.add(fields.fieldOf(field), *wrong);
    };
    if (sound())
        require("points", Curve::problem(degree, closed, points));
    if (sound() && !knots.empty())
        require("knots", Curve::problem(degree, closed, points, knots));
    if (sound() && !corners.empty())
        require("corners", Curve::cornerProblem(degree, closed, static_cast<int>(points.size()), corners));
    if (!sound())
        return {};
    return corners.empty() ? Curve(degree, closed, points, knots) : Curve::withCorners(points, corners);
}

std::string lowerCase(std::string color)
{
    for (char& c : color)
        c = c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c;
    return color;
}

/// One direction or a list of them.
std::vector<Vec3> readDirections(Fields& fields, std::string_view key)
{
    const Value* value = fields.required(key);
    const std::string field = fields.fieldOf(key);
    bool isList = false;
    if (value && value->isArray())
        value->eachItem([&](std::size_t, const Value& item) { isList = isList || item.isArray(); });
    std::vector<Vec3> directions;
    if (value && !isList)
        directions.push_back(vectorIn<3>(*value, field, fields.report(), largestCoordinate));
    else if (value)
        value->eachItem([&](std::size_t i, const Value& item) {
            directions.push_back(
                vectorIn<3>(item, field + "[" + std::to_string(i) + "]", fields.report(), largestCoordinate));
        });
    return directions;
}

Quat readTurn(Fields& fields, std::string_view key)
{
    const Eigen::Vector4d wxyz = fields.vector<4>(key, {1, 0, 0, 0});
    Quat turn(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    const double size = wxyz.norm();
    if (!(std::abs(size - 1) <= 1e-3) && fields.has(key))
        fields.report().add(fields.fieldOf(key),
                            {QT_TRANSLATE_NOOP("Message", "must be a quaternion [w, x, y, z] of length 1, "
                                                          "not of length %1"),
                             {numberText(size)}});
    else if (std::abs(size - 1) > 1e-14) // what is normalised already stays bit for bit
        turn.normalize();
    return turn;
}

std::vector<HalfSpace> readHalfSpaces(Fields& fields, std::string_view key, std::size_t most)
{
    std::vector<HalfSpace> halfSpaces;
    const Value* list = fields.required(key);
    const std::string field = fields.fieldOf(key);
    if (list && (!list->isArray() || list->size() > most)) {
        fields.report().add(field, {QT_TRANSLATE_NOOP("Message", "must be a list of at most %1 planes, "
                                                                 "[x, y, z, distance] each"),
                                    {std::to_string(most)}});
        return halfSpaces;
    }
    if (list)
        list->eachItem([&](std::size_t i, const Value& item) {
            const Eigen::Vector4d plane =
                vectorIn<4>(item, field + "[" + std::to_string(i) + "]", fields.report(), largestCoordinate);
            halfSpaces.push_back({plane.head<3>(), plane[3]});
        });
    return halfSpaces;
}

/// Reads the fields of a value, which has the usual ones before.
class FieldReader {
public:
    explicit FieldReader(Fields& fields)
        : m_fields(fields)
    {}

    void field(const Field& f, const Number&, double& value)
    {
        value = isRequired(f) ? m_fields.number(f.key) : m_fields.number(f.key, value);
    }
    void field(const Field& f, const Flag&, bool& value) { value = m_fields.flag(f.key, value); }
    void field(const Field& f, const Text&, std::string& value)
    {
        value = isRequired(f) ? m_fields.text(f.key) : m_fields.text(f.key, value);
    }
    void field(const Field& f, const Color&, std::string& value)
    {
        field(f, Text{}, value);
        value = lowerCase(std::move(value));
    }
    void field(const Field& f, const FileName&, std::string& value) { field(f, Text{}, value); }
    void field(const Field& f, const Names&, std::vector<std::string>& value)
    {
        eachOptional(m_fields, f.key, [&](const Value& item, const std::string& at) {
            if (item.kind() == Kind::String)
                value.push_back(item.string());
            else
                report().add(at, {QT_TRANSLATE_NOOP("Message", "must be a text in quotation marks")});
        });
        refuseEmpty(m_fields, f.key);
    }
    template <class Enum>
    void field(const Field& f, const Words& words, Enum& value)
    {
        value = static_cast<Enum>(m_fields.choice(f.key, words.keys));
    }
    template <class T>
    void field(const Field& f, const Refers<T>&, ElementId& value)
    {
        if (m_fields.has(f.key) || isRequired(f))
            value = m_fields.id(f.key);
    }
    template <class T>
    void field(const Field& f, const Refers<T>&, std::vector<ElementId>& value)
    {
        eachOptional(m_fields, f.key, [&](const Value& item, const std::string& at) {
            value.push_back(ElementId{integerIn(item, at, report(), 1, largestElementId)});
        });
        refuseEmpty(m_fields, f.key);
    }
    void field(const Field& f, const Coordinates&, Vec2& value) { value = m_fields.vector<2>(f.key, value); }
    void field(const Field& f, const Coordinates&, Vec3& value) { value = m_fields.vector<3>(f.key, value); }
    template <class Vector>
    void field(const Field& f, const Direction&, Vector& value)
    {
        field(f, Coordinates{}, value);
    }
    void field(const Field& f, const Turn&, Quat& value) { value = readTurn(m_fields, f.key); }
    template <int Dim>
    void field(const Field& f, const Curve& form, BSpline<Dim>& value)
    {
        if (m_fields.has(f.key) || isRequired(f))
            value = readCurve<Dim>(m_fields, f.key);
        if (form.outline && !value.empty() && !value.closed())
            report().add(m_fields.fieldOf(f.key) + ".closed",
                         {QT_TRANSLATE_NOOP("Message", "an outline must be closed; write true")});
    }
    void field(const Field& f, const CurveRange& form, std::optional<std::pair<double, double>>& value)
    {
        if (!m_fields.has(f.key) && !m_fields.has(form.endKey))
            return;
        const double from = m_fields.number(f.key);
        value = {from, m_fields.number(form.endKey)};
    }
    void field(const Field& f, const Directions& form, Orientation& value)
    {
        if (m_fields.has(f.key) && m_fields.has(form.tangentKey))
            report().add(form.tangentKey,
                         {QT_TRANSLATE_NOOP("Message", "there is either a normal or a tangent; remove "
                                                       "one of them")});
        if (m_fields.has(f.key))
            value.directions = readDirections(m_fields, f.key);
        if (m_fields.has(form.tangentKey)) {
            value.kind = Orientation::Kind::Tangent;
            value.directions = readDirections(m_fields, form.tangentKey);
        }
    }
    void field(const Field& f, const PointNumbers&, std::vector<int>& value)
    {
        eachOptional(m_fields, f.key, [&](const Value& item, const std::string& at) {
            value.push_back(integerIn(item, at, report(), 0, 2 * mostCurvePoints - 1));
        });
        refuseEmpty(m_fields, f.key);
        std::sort(value.begin(), value.end());
        value.erase(std::unique(value.begin(), value.end()), value.end());
    }
    void field(const Field& f, const Planes& form, std::vector<HalfSpace>& value)
    {
        value = readHalfSpaces(m_fields, f.key, form.most);
    }

    template <class T>
    void group(const Field& f, T& value)
    {
        if (const Value* object = objectAt<T>(f))
            readInto(value, *object, m_fields.fieldOf(f.key));
    }
    template <class T>
    void group(const Field& f, std::optional<T>& value)
    {
        if (const Value* object = objectAt<T>(f))
            readInto(value.emplace(), *object, m_fields.fieldOf(f.key));
    }
    template <class Read>
    void within(const Field& f, Read read)
    {
        if (const Value* object = objectAt<void>(f)) {
            Fields inner(*object, m_fields.fieldOf(f.key) + ".", report());
            FieldReader reader(inner);
            read(reader);
            inner.finish();
        }
    }
    template <class T>
    void part(const Field&, T& value)
    {
        Description<T>::of(*this, value);
    }
    template <class T>
    void list(const Field& f, const Entries& form, std::vector<T>& value)
    {
        const Value* list = m_fields.optional(f.key);
        const std::string at = m_fields.fieldOf(f.key);
        if (list && (!list->isArray() || list->size() > form.most))
            report().add(at, wrongList(form));
        else if (list)
            list->eachItem([&](std::size_t i, const Value& item) {
                const std::string entry = at + "[" + std::to_string(i) + "]";
                if (item.isObject())
                    readInto(value.emplace_back(), item, entry);
                else
                    report().add(entry, {form.wrongEntry});
            });
        if (!form.mayBeEmpty)
            refuseEmpty(m_fields, f.key);
    }
    template <class T>
    void usual(T& value)
    {
        value = usualOf(value);
    }

private:
    Report& report() { return m_fields.report(); }

    bool isRequired(const Field& f) const
    {
        const auto isThere = [&](const char* key) { return key && m_fields.has(key); };
        return f.presence == Presence::Required || (f.unless[0] && std::ranges::none_of(f.unless, isThere));
    }

    static Message wrongList(const Entries& form)
    {
        if (form.most == Entries{}.most)
            return {form.wrongList};
        return {form.wrongList, {std::to_string(form.most)}};
    }

    template <class T>
    void readInto(T& value, const Value& object, const std::string& at)
    {
        Fields inner(object, at + ".", report());
        FieldReader(inner).part({}, value);
        inner.finish();
    }

    /// The object under a key, if there is one; else, or if it is none, null.
    template <class T>
    const Value* objectAt(const Field& f)
    {
        const Value* object = isRequired(f) ? m_fields.required(f.key) : m_fields.optional(f.key);
        if (!object || object->isObject())
            return object;
        if constexpr (requires { Description<T>::wrong; })
            report().add(m_fields.fieldOf(f.key), {Description<T>::wrong});
        else
            report().add(m_fields.fieldOf(f.key), {QT_TRANSLATE_NOOP("Message", "must be an object in braces")});
        return nullptr;
    }

    Fields& m_fields;
};

/// "fabric, patch ... and outline_trim"
std::vector<std::string> kindWords()
{
    std::vector<std::string> words;
    eachWrittenKind([&]<class T>() { words.emplace_back(Description<T>::word); });
    return words;
}

std::string textOf(const Value& object, std::string_view wanted)
{
    std::string text;
    object.eachMember([&](const std::string& key, const Value& value) {
        if (key == wanted && text.empty())
            text = value.string();
    });
    return text;
}

} // namespace

Heading headingOf(const Value& element, std::size_t position)
{
    Heading heading;
    if (element.isObject()) {
        Report ignored(ElementId{}, {});
        Fields fields(element, "", ignored);
        if (const Value* id = fields.optional("id")) {
            Report wrong(ElementId{}, {});
            const int number = integerIn(*id, "id", wrong, 1, largestElementId);
            heading.id = wrong.clean() ? ElementId{number} : noElement;
        }
    }
    if (heading.id == noElement)
        heading.label = "elements[" + std::to_string(position) + "]";
    else
        heading.label = elementLabel(textOf(element, "kind"), heading.id, textOf(element, "name"));
    return heading;
}

Settings readSettings(const Value& object, Report& report)
{
    Settings settings;
    if (!object.isObject()) {
        report.add("", {QT_TRANSLATE_NOOP("Message", "must be an object in braces")});
        return settings;
    }
    Fields fields(object, "", report);
    Settings read;
    FieldReader(fields).part({}, read);
    fields.finish();
    return report.clean() ? read : settings;
}

ElementPtr readElement(const Value& object, Report& report)
{
    if (!object.isObject()) {
        report.add("", {QT_TRANSLATE_NOOP("Message", "an element must be an object in braces")});
        return nullptr;
    }
    Fields fields(object, "", report);
    fields.id("id");
    const std::string kind = fields.text("kind");
    ElementPtr element;
    bool known = false;
    eachWrittenKind([&]<class T>() {
        if (kind != Description<T>::word)
            return;
        known = true;
        T value;
        FieldReader(fields).part({}, value);
        fields.finish();
        if (report.clean())
            element = makeElement(std::move(value));
    });
    if (!known && fields.has("kind") && report.clean()) {
        std::vector<std::string> words = kindWords();
        const std::string last = words.back();
        words.pop_back();
        std::string others;
        for (const std::string& word : words)
            others.append(others.empty() ? "" : ", ").append(word);
        report.add("kind", {QT_TRANSLATE_NOOP("Message", "the kind %1 is unknown; there are %2 and %3"),
                            {quoted(kind), others, last}});
    }
    return element;
}

} // namespace bolster::json
