// Numbers with units for people: in the language of the system, or as the user wants them.
#pragma once

#include <QLocale>
#include <QObject>
#include <QString>

#include <initializer_list>

namespace bolster {

enum class LengthUnit { Millimetres, Centimetres, Inches };
enum class DecimalSign { OfLanguage, Comma, Point };

struct NumberStyle {
    LengthUnit length = LengthUnit::Millimetres;
    int fraction = 16; ///< inches are shown in halves, quarters ... up to this part; 0: with decimals
    DecimalSign decimal = DecimalSign::OfLanguage;

    friend bool operator==(const NumberStyle&, const NumberStyle&) = default;
};

/// How lengths and numbers are shown and typed in the whole program. Designs stay in mm whatever it is.
class NumberStyles : public QObject {
    Q_OBJECT

public:
    static NumberStyles& instance();
    static const NumberStyle& now() { return instance().m_now; }
    void set(const NumberStyle& style);

signals:
    /// What shows lengths has to show them anew.
    void changed();

private:
    NumberStyle m_now;
};

/// What numbers are written and read with: the language's signs, or others.
QLocale numberLocale();

/// Of the unit that lengths are shown in: 1, 10 or 25.4.
double millimetresPerUnit();
/// "mm", as in "x, y in mm".
QString lengthUnitName();
/// " mm"; as behind a number.
QString lengthSuffix();
/// How many decimals more than in mm say as much.
int moreDecimals();
/// What marks the unit of a length in descriptions and maps, whatever is shown.
inline const QString millimetreSuffix = QStringLiteral(" mm");

/// "12.5", or "12 3/8": without the unit. At most so many decimals as in mm; without trailing zeros.
QString lengthFigure(double millimetres, int decimals = 1);
/// "12.5" with all its decimals, never as a fraction: for legends, and for what changes all the time.
QString steadyLengthFigure(double millimetres, int decimals = 1);
QString steadyLengthText(double millimetres, int decimals = 1);
/// How far an arrow key moves things, and with Shift: mm, a round number of the unit that is shown.
double nudgeLength(bool far);
/// "12.5 mm", at most `decimals` behind the point and no trailing zeros.
QString lengthText(double millimetres, int decimals = 1);
/// Of what is metres long: "4.71 m", or "15.5 ft" with inches.
QString longLengthText(double millimetres);
/// "1.25 m2", or "13.5 ft2" with inches; as many decimals as square metres have.
QString areaText(double squareMillimetres, int decimals = 2);
/// "250 x 120 mm" with a proper multiplication sign.
QString sizeText(double width, double height);
/// The same of any number of sides.
QString sizesText(std::initializer_list<double> sides, int decimals = 0);
/// "12 3/8": inches in parts of at most 1/`fraction`, as near as that is.
QString inchFractionText(double inches, int fraction);
QString angleText(double degrees);
/// A ratio of 0.012 is "1.2 %".
QString percentText(double ratio);
QString decimalText(double value, int decimals, bool trailingZeros);

} // namespace bolster
