#include "LengthExpression.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bolster {

namespace {

constexpr int mostBrackets = 50; // and signs: each is a call

/// A number or a length: the power of the unit is 0 or 1.
struct Quantity {
    double value = 0;
    int power = 0;
};
using Parsed = std::optional<Quantity>;

constexpr double feet = 304.8; // mm

struct Unit {
    QString name;
    double millimetres;
};
// Longer names before their beginnings.
const Unit units[] = {
    {QStringLiteral("mm"), 1},        {QStringLiteral("cm"), 10},       {QStringLiteral("inches"), 25.4},
    {QStringLiteral("inch"), 25.4},   {QStringLiteral("in"), 25.4},     {QStringLiteral("\""), 25.4},
    {QStringLiteral("\u2033"), 25.4}, {QStringLiteral("\u201d"), 25.4}, {QStringLiteral("''"), 25.4},
    {QStringLiteral("feet"), feet},   {QStringLiteral("foot"), feet},   {QStringLiteral("ft"), feet},
    {QStringLiteral("'"), feet},      {QStringLiteral("\u2032"), feet}, {QStringLiteral("\u2019"), feet},
    {QStringLiteral("m"), 1000},
};

class Parser {
public:
    Parser(const QString& text, const QLocale& locale, bool withUnits)
        : m_text(withPlainFractions(text))
        , m_point(locale.decimalPoint().at(0))
        , m_group(locale.groupSeparator().at(0))
        , m_withUnits(withUnits)
    {}

    std::optional<double> parse()
    {
        const Parsed result = sum();
        skipBlanks();
        if (!result || m_at != m_text.size())
            return std::nullopt;
        const double value = m_withUnits ? asLength(*result).value : result->value;
        return std::isfinite(value) ? std::optional(value) : std::nullopt;
    }

private:
    /// "12\u00bd" is "12 1/2".
    static QString withPlainFractions(QString text)
    {
        static const std::pair<QChar, QString> fractions[] = {
            {u'\u00bc', QStringLiteral(" 1/4")}, {u'\u00bd', QStringLiteral(" 1/2")},
            {u'\u00be', QStringLiteral(" 3/4")}, {u'\u215b', QStringLiteral(" 1/8")},
            {u'\u215c', QStringLiteral(" 3/8")}, {u'\u215d', QStringLiteral(" 5/8")},
            {u'\u215e', QStringLiteral(" 7/8")},
        };
        for (const auto& [sign, plain] : fractions)
            text.replace(sign, plain);
        return text;
    }

    /// Plain numbers are in the unit that lengths are shown in.
    static Quantity asLength(const Quantity& quantity)
    {
        return quantity.power == 1 ? quantity : Quantity{quantity.value * millimetresPerUnit(), 1};
    }

    Parsed sum()
    {
        Parsed left = product();
        while (left) {
            const bool minus = !take(u'+');
            if (minus && !take(u'-') && !take(u'\u2212'))
                return left;
            const Parsed right = product();
            if (!right)
                return right;
            const bool lengths = left->power != right->power;
            const Quantity a = lengths ? asLength(*left) : *left, b = lengths ? asLength(*right) : *right;
            left = Quantity{a.value + (minus ? -b.value : b.value), a.power};
        }
        return left;
    }

    Parsed product()
    {
        Parsed left = withSmallerUnits(withUnit(factor()));
        while (left) {
            const bool divided = !take(u'*') && !take(u'\u00d7');
            if (divided && !take(u'/'))
                return left;
            const Parsed right = factor();
            if (!right || (divided && right->value == 0))
                return std::nullopt;
            left = withUnit(Quantity{divided ? left->value / right->value : left->value * right->value,
                                     left->power + (divided ? -right->power : right->power)});
            if (left && left->power != 0 && left->power != 1)
                return std::nullopt; // an area is no length
        }
        return left;
    }

    Parsed factor()
    {
        if (take(u'-') || take(u'\u2212')) {
            const Parsed inner = ++m_brackets < mostBrackets ? factor() : std::nullopt;
            return inner ? Parsed(Quantity{-inner->value, inner->power}) : inner;
        }
        if (take(u'+'))
            return ++m_brackets < mostBrackets ? factor() : std::nullopt;
        if (!take(u'('))
            return number();
        const Parsed inner = ++m_brackets < mostBrackets ? sum() : std::nullopt;
        return take(u')') ? inner : std::nullopt;
    }

    Parsed withUnit(Parsed quantity)
    {
        if (!quantity || !m_withUnits)
            return quantity;
        const Unit* unit = takeUnit();
        if (!unit)
            return quantity;
        if (quantity->power != 0)
            return std::nullopt;
        return Quantity{quantity->value * unit->millimetres, 1};
    }

    const Unit* takeUnit()
    {
        skipBlanks();
        m_unit = nullptr;
        for (const Unit& unit : units)
            if (QStringView(m_text).mid(m_at).startsWith(unit.name, Qt::CaseInsensitive)) {
                m_at += unit.name.size();
                return m_unit = &unit;
            }
        return nullptr;
    }

    /// "1' 2 3/8\"": what follows a length with a unit, in a smaller one, belongs to it.
    Parsed withSmallerUnits(Parsed length)
    {
        while (length && length->power == 1 && m_unit && digitFollows()) {
            const double larger = m_unit->millimetres;
            const bool afterFeet = larger == feet;
            const Parsed more = fractionOrNumber();
            if (!more)
                return std::nullopt;
            const Unit* unit = takeUnit();
            if (unit ? unit->millimetres >= larger : !afterFeet)
                return std::nullopt;
            const double by = more->value * (unit ? unit->millimetres : feet / 12);
            length->value += std::signbit(length->value) ? -by : by;
        }
        return length;
    }

    /// "1/2", where a quotient of the whole would make no sense.
    Parsed fractionOrNumber()
    {
        static const QRegularExpression pattern(QStringLiteral("(\\d{1,4})\\s*/\\s*([1-9]\\d{0,3})(?![\\d.,])"));
        const auto found = pattern.match(m_text, m_at, QRegularExpression::NormalMatch,
                                         QRegularExpression::AnchorAtOffsetMatchOption);
        if (!found.hasMatch())
            return number();
        m_at += found.capturedLength();
        return Quantity{found.captured(1).toDouble() / found.captured(2).toDouble()};
    }

    bool digitFollows()
    {
        skipBlanks();
        return m_at < m_text.size() && m_text[m_at].isDigit();
    }

    Parsed number()
    {
        skipBlanks();
        m_unit = nullptr; // whatever there was belongs to what lies before
        const qsizetype start = m_at;
        if (const Parsed mixed = wholeAndFraction())
            return mixed;
        while (m_at < m_text.size() &&
               (m_text[m_at].isDigit() || m_text[m_at] == u'.' || m_text[m_at] == u',' || m_text[m_at] == m_point))
            ++m_at;
        const QString digits = plain(m_text.mid(start, m_at - start));
        bool good = false;
        const double value = QString(digits + exponent()).toDouble(&good);
        return good ? Parsed(Quantity{value}) : std::nullopt;
    }

    /// "12 3/8", as on a tape measure.
    Parsed wholeAndFraction()
    {
        static const QRegularExpression pattern(
            QStringLiteral("(\\d{1,7})\\s+(\\d{1,4})\\s*/\\s*([1-9]\\d{0,3})(?![\\d.,])"));
        const auto found = pattern.match(m_text, m_at, QRegularExpression::NormalMatch,
                                         QRegularExpression::AnchorAtOffsetMatchOption);
        if (!found.hasMatch())
            return std::nullopt;
        m_at += found.capturedLength();
        return Quantity{found.captured(1).toDouble() + found.captured(2).toDouble() / found.captured(3).toDouble()};
    }

    /// "e3", "E-2" right behind the digits, or nothing.
    QString exponent()
    {
        static const QRegularExpression pattern(QStringLiteral("[eE][+-]?\\d{1,3}"));
        const auto found = pattern.match(m_text, m_at, QRegularExpression::NormalMatch,
                                         QRegularExpression::AnchorAtOffsetMatchOption);
        m_at += found.capturedLength();
        return found.captured();
    }

    /// With "." as the decimal sign and without grouped digits; not a number if it is ambiguous.
    QString plain(QString written) const
    {
        const QChar other = m_point == u',' ? u'.' : u',';
        if (other == m_group && grouped(written, other))
            written.remove(other);
        if (written.count(other) + written.count(m_point) > 1)
            return {};
        return written.replace(other, u'.').replace(m_point, u'.');
    }

    /// "1,500" and "12,345.6": groups of three behind one to three digits, the first of which is no zero.
    bool grouped(const QString& written, QChar separator) const
    {
        const QStringList groups = written.section(m_point, 0, 0).split(separator);
        if (groups.size() < 2 || groups.front().isEmpty() || groups.front().size() > 3 ||
            groups.front().startsWith(u'0'))
            return false;
        return std::all_of(groups.begin() + 1, groups.end(),
                           [](const QString& group) { return group.size() == 3; });
    }

    bool take(QChar wanted)
    {
        skipBlanks();
        if (m_at >= m_text.size() || m_text[m_at] != wanted)
            return false;
        ++m_at;
        return true;
    }

    void skipBlanks()
    {
        while (m_at < m_text.size() && m_text[m_at].isSpace())
            ++m_at;
    }

    QString m_text;
    QChar m_point;
    QChar m_group;
    bool m_withUnits;
    const Unit* m_unit = nullptr; ///< that was taken last, right before where we are
    qsizetype m_at = 0;
    int m_brackets = 0;
};

} // namespace

std::optional<double> parseLength(const QString& text, const QLocale& locale)
{
    return Parser(text, locale, true).parse();
}

std::optional<double> parseNumber(const QString& text, const QLocale& locale)
{
    return Parser(text, locale, false).parse();
}

} // namespace bolster
