#include "LengthExpression.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr int mostBrackets = 50; // and signs: each is a call

/// A number or a length: the power of the unit is 0 or 1.
struct Quantity {
    double value = 0;
    int power = 0;
};
using Parsed = std::optional<Quantity>;

struct Unit {
    QLatin1String name;
    double millimetres;
};
// Longer names before their beginnings.
constexpr Unit units[] = {
    {QLatin1String("mm"), 1},    {QLatin1String("cm"), 10},   {QLatin1String("inch"), 25.4},
    {QLatin1String("in"), 25.4}, {QLatin1String("\""), 25.4}, {QLatin1String("ft"), 304.8},
    {QLatin1String("m"), 1000},
};

class Parser {
public:
    Parser(const QString& text, const QLocale& locale, bool withUnits)
        : m_text(text)
        , m_point(locale.decimalPoint().at(0))
        , m_group(locale.groupSeparator().at(0))
        , m_withUnits(withUnits)
    {}

    std::optional<double> parse()
    {
        const Parsed result = sum();
        skipBlanks();
        if (!result || m_at != m_text.size() || !std::isfinite(result->value))
            return std::nullopt;
        return result->value;
    }

private:
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
            left = Quantity{left->value + (minus ? -right->value : right->value),
                            std::max(left->power, right->power)}; // plain numbers beside lengths are mm
        }
        return left;
    }

    Parsed product()
    {
        Parsed left = withUnit(factor());
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
        skipBlanks();
        if (!quantity || !m_withUnits)
            return quantity;
        for (const Unit& unit : units) {
            if (!QStringView(m_text).mid(m_at).startsWith(unit.name, Qt::CaseInsensitive))
                continue;
            m_at += unit.name.size();
            if (quantity->power != 0)
                return std::nullopt;
            return Quantity{quantity->value * unit.millimetres, 1};
        }
        return quantity;
    }

    Parsed number()
    {
        skipBlanks();
        const qsizetype start = m_at;
        while (m_at < m_text.size() &&
               (m_text[m_at].isDigit() || m_text[m_at] == u'.' || m_text[m_at] == u',' || m_text[m_at] == m_point))
            ++m_at;
        const QString digits = plain(m_text.mid(start, m_at - start));
        bool good = false;
        const double value = QString(digits + exponent()).toDouble(&good);
        return good ? Parsed(Quantity{value}) : std::nullopt;
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
