#include "FieldTables.h"

#include "JsonText.h"
#include "Kinds.h"

#include <cmath>
#include <map>
#include <optional>
#include <vector>

namespace bolster {

namespace {

std::string tableLine(const std::string& key, const std::string& usual, const std::string& values,
                      const std::string& meaning)
{
    std::string line = "|";
    for (const std::string* cell : {&key, &usual, &values, &meaning})
        line.append(cell->empty() ? "" : " ").append(*cell).append(" |");
    return line.append("\n");
}

std::string tableCode(const std::string& text)
{
    return std::string("`").append(text).append("`");
}

const char* unitWord(Unit unit)
{
    switch (unit) {
    case Unit::Millimetres:
        return "mm";
    case Unit::Degrees:
        return "degrees";
    case Unit::Percent:
        return "%";
    case Unit::MillimetresPerUnit:
        return "mm per unit";
    case Unit::None:
        break;
    }
    return "";
}

/// "10,000" for people; small and broken numbers as they are.
std::string grouped(double number)
{
    if (std::abs(number) < 10000 || number != std::round(number))
        return json::text(number);
    std::string digits = std::to_string(static_cast<long long>(number));
    for (auto place = static_cast<std::ptrdiff_t>(digits.size()) - 3; place > (number < 0); place -= 3)
        digits.insert(digits.begin() + place, ',');
    return digits;
}

/// "mm, 0.1 to 100"; coordinates have the limits that all have.
std::string rangeText(double least, double most, Unit unit)
{
    std::string text = unitWord(unit);
    if (least > -1e7 || most < 1e7)
        text += (text.empty() ? "" : ", ") + grouped(least) + " to " + grouped(most);
    return text.empty() ? "number" : text;
}

template <class Vector>
std::string tableList(const Vector& values)
{
    std::string all;
    for (const double value : values)
        all.append(all.empty() ? "" : ", ").append(json::text(value));
    return std::string("[").append(all).append("]");
}

/// "`"box"`, `"sphere"` or `"mesh"`"
std::string tableChoice(std::span<const char* const> keys)
{
    std::string all;
    for (std::size_t i = 0; i < keys.size(); ++i)
        all.append(i == 0 ? "" : i + 1 < keys.size() ? ", " : " or ").append(tableCode(json::quoted(keys[i])));
    return all;
}

template <class T>
std::string tableId()
{
    if constexpr (requires { Description<T>::word; })
        return std::string("id of a ") + Description<T>::word;
    else
        return "id";
}

/// Makes a line of each field, from the usual values. Parts that no section of the document is about are
/// described here, with the key of the part before theirs.
class TableWalker {
public:
    explicit TableWalker(std::string prefix = {})
        : m_prefix(std::move(prefix))
    {}

    const std::string& lines() const { return m_lines; }

    void field(const Field& f, const Number& form, const double& usual)
    {
        put(f, json::text(usual), rangeText(form.least, form.most, form.unit));
    }
    void field(const Field& f, const Flag&, const bool& usual)
    {
        put(f, usual ? "true" : "false", "`true` or `false`");
    }
    void field(const Field& f, const Text&, const std::string&) { put(f, "", "text"); }
    void field(const Field& f, const Color&, const std::string& usual)
    {
        put(f, usual.empty() ? "" : tableCode(json::quoted(usual)), "`#rrggbb`");
    }
    void field(const Field& f, const FileName&, const std::string&) { put(f, "none", "name of a file"); }
    void field(const Field& f, const Names&, const std::vector<std::string>&) { put(f, "none", "list of names"); }
    template <class Enum>
    void field(const Field& f, const Words& words, const Enum& usual)
    {
        put(f, tableCode(json::quoted(words.keys[static_cast<std::size_t>(usual)])), tableChoice(words.keys));
    }
    template <class T>
    void field(const Field& f, const Refers<T>&, const ElementId&)
    {
        put(f, "none", tableId<T>());
    }
    template <class T>
    void field(const Field& f, const Refers<T>&, const std::vector<ElementId>&)
    {
        put(f, "none", "list, each the " + tableId<T>());
    }
    template <class Vector>
    void field(const Field& f, const Coordinates& form, const Vector& usual)
    {
        put(f, tableList(usual), rangeText(form.least, form.most, form.unit));
    }
    template <class Vector>
    void field(const Field& f, const Direction&, const Vector& usual)
    {
        put(f, tableList(usual), std::to_string(usual.size()) + " numbers");
    }
    void field(const Field& f, const Turn&, const Quat&) { put(f, "[1, 0, 0, 0]", "4 numbers"); }
    template <int Dim>
    void field(const Field& f, const Curve&, const BSpline<Dim>&)
    {
        put(f, "none", Dim == 2 ? "2D [curve](#curves)" : "3D [curve](#curves)");
    }
    template <class Value>
    void field(const Field& f, const CurveRange& form, const Value&)
    {
        put(f, "whole curve", "numbers", form.endKey);
    }
    void field(const Field& f, const Directions& form, const Orientation&)
    {
        put(f, "none", "[x, y, z], or a list of such", form.tangentKey);
    }
    void field(const Field& f, const PointNumbers&, const std::vector<int>&) { put(f, "none", "list of numbers"); }
    void field(const Field& f, const Planes& form, const std::vector<HalfSpace>&)
    {
        put(f, "", "list of at most " + std::to_string(form.most));
    }

    template <class T>
    void group(const Field& f, const T& usual)
    {
        if constexpr (requires { Description<T>::section; }) {
            put(f, "", Description<T>::section);
        } else {
            TableWalker inner(m_prefix + f.key + ".");
            inner.part({}, usual);
            nest(f, inner);
        }
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
        TableWalker inner(m_prefix + f.key + ".");
        walk(inner);
        nest(f, inner);
    }
    template <class T>
    void list(const Field& f, const Entries&, const std::vector<T>&)
    {
        TableWalker inner(m_prefix + f.key + "[].");
        inner.part({}, T{});
        put(f, "none", "list");
        m_lines += inner.lines();
    }
    /// From here on the usual values depend on another field.
    template <class T>
    void usual(const T&)
    {
        m_sameForAll = false;
    }

private:
    void nest(const Field& f, const TableWalker& inner)
    {
        if (*f.meaning)
            put(f, "", "object");
        m_lines += inner.lines();
    }
    void put(const Field& f, const std::string& usual, const std::string& values, const char* secondKey = "")
    {
        std::string keys = tableCode(m_prefix + f.key);
        if (*secondKey)
            keys += ", " + tableCode(m_prefix + secondKey);
        m_lines += tableLine(keys,
                             f.presence == Presence::Required ? "\u2013"
                             : m_sameForAll                   ? usual
                                                              : "by kind",
                             values, f.meaning);
    }

    std::string m_prefix;
    std::string m_lines;
    bool m_sameForAll = true;
};

template <class T>
std::string tableOf()
{
    TableWalker walker;
    walker.part({}, T{});
    return "| key | default | values | meaning |\n|---|---|---|---|\n" + walker.lines();
}

std::map<std::string, std::string> allTables()
{
    std::map<std::string, std::string> tables{{"settings", tableOf<Settings>()},
                                              {"look", tableOf<FabricLook>()},
                                              {"trim", tableOf<SeamTrim>()},
                                              {"stretch", tableOf<Stretch>()},
                                              {"twin", tableOf<Twin>()},
                                              {"symmetry", tableOf<Symmetry>()},
                                              {"allowance", tableOf<CutAllowance>()},
                                              {"notch_shape", tableOf<NotchShape>()},
                                              {"automatic_notches", tableOf<AutomaticNotches>()},
                                              {"piece_cutting", tableOf<PieceCutting>()},
                                              {"fabric_cutting", tableOf<FabricCutting>()},
                                              {"design_cutting", tableOf<DesignCutting>()}};
    eachWrittenKind([&]<class T>() { tables[Description<T>::word] = tableOf<T>(); });
    return tables;
}

} // namespace

std::string withFieldTables(const std::string& document)
{
    const std::string end = "<!-- end -->";
    std::string text = document;
    for (const auto& [name, table] : allTables()) {
        const std::string start = "<!-- fields of " + name + " -->\n";
        const std::size_t from = text.find(start);
        const std::size_t to = from == std::string::npos ? from : text.find(end, from);
        if (to != std::string::npos)
            text =
                text.substr(0, from + start.size()).append("\n").append(table).append("\n").append(text.substr(to));
    }
    return text;
}

} // namespace bolster
