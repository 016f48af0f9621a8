#include "Theme.h"

#include "Icons.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleOption>

#include <utility>

namespace bolster {

namespace {

struct Shades {
    QRgb window, base, alternate, button, text, muted, hint, highlight, highlighted, link, line;
};

// What can be read of it is measured by tests/app/ContrastTest; what is switched off (`muted`) need not be read.
constexpr Shades light{0xfff2f3f5, 0xffffffff, 0xfff7f8fa, 0xfff7f8f9, 0xff1d2127, 0xff8b929c,
                       0xff646b75, 0xff2a6fb5, 0xffffffff, 0xff1f63a8, 0xffd3d7dd};
constexpr Shades dark{0xff26292e, 0xff1d2024, 0xff23262b, 0xff31353b, 0xffe4e7eb, 0xff7d848e,
                      0xff9aa1ab, 0xff5a9fe6, 0xff10151b, 0xff7ab5f0, 0xff3c4148};
constexpr Shades contrast{0xff000000, 0xff000000, 0xff101010, 0xff1a1a1a, 0xffffffff, 0xffb8b8b8,
                          0xffb8b8b8, 0xffffd60a, 0xff000000, 0xff7fd4ff, 0xffffffff};

QPalette paletteOf(const Shades& shades)
{
    QPalette p;
    const auto set = [&p](QPalette::ColorRole role, QRgb color) { p.setColor(role, QColor::fromRgba(color)); };
    set(QPalette::Window, shades.window);
    set(QPalette::Base, shades.base);
    set(QPalette::AlternateBase, shades.alternate);
    set(QPalette::Button, shades.button);
    set(QPalette::ToolTipBase, shades.base);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                                           QPalette::ToolTipText, QPalette::BrightText}) {
        set(role, shades.text);
        p.setColor(QPalette::Disabled, role, QColor::fromRgba(shades.muted));
    }
    set(QPalette::PlaceholderText, shades.hint);
    set(QPalette::Highlight, shades.highlight);
    set(QPalette::HighlightedText, shades.highlighted);
    p.setColor(QPalette::Disabled, QPalette::Highlight, QColor::fromRgba(shades.line));
    set(QPalette::Link, shades.link);
    const QColor line = QColor::fromRgba(shades.line);
    p.setColor(QPalette::Mid, line);
    p.setColor(QPalette::Midlight, QColor::fromRgba(shades.button));
    p.setColor(QPalette::Light, QColor::fromRgba(shades.base));
    p.setColor(QPalette::Dark, line.darker(135));
    p.setColor(QPalette::Shadow, line.darker(200));
    return p;
}

QString mixedName(QRgb a, QRgb b, int percentOfB)
{
    const auto mix = [percentOfB](int x, int y) { return x + (y - x) * percentOfB / 100; };
    return QColor(mix(qRed(a), qRed(b)), mix(qGreen(a), qGreen(b)), mix(qBlue(a), qBlue(b))).name();
}

/// Fusion draws most of it well; these are its old-fashioned spots.
QString styleOf(const Shades& shades)
{
    QString style = QStringLiteral(R"(
QMainWindow::separator { background: palette(window); width: 5px; height: 5px; }
QMainWindow::separator:hover { background: $tint; }
QToolBar { border: none; border-bottom: 1px solid $line; padding: 4px 6px; spacing: 3px; }
QToolBar::separator { background: $line; width: 1px; margin: 6px 6px; }
QToolBar QToolButton { border: none; border-radius: 5px; padding: 5px; }
QToolBar QToolButton:hover { background: $hover; }
QToolBar QToolButton:pressed { background: $line; }
QToolBar QToolButton:checked { background: $tint; }
QToolBar QToolButton:checked:hover { background: $tintHover; }
QStatusBar { border-top: 1px solid $line; }
QStatusBar::item { border: none; }
QToolTip { border: 1px solid $line; padding: 4px; background: palette(base); color: palette(text); }
QScrollBar { background: transparent; border: none; }
QScrollBar:vertical { width: 11px; }
QScrollBar:horizontal { height: 11px; }
QScrollBar::handle { background: $handle; border-radius: 3px; margin: 2px 3px; }
QScrollBar::handle:vertical { min-height: 28px; }
QScrollBar::handle:horizontal { min-width: 28px; margin: 3px 2px; }
QScrollBar::handle:hover { background: $handleHover; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
)");
    const std::pair<const char*, QString> colors[] = {
        {"$handleHover", mixedName(shades.window, shades.text, 45)},
        {"$handle", mixedName(shades.window, shades.text, 24)},
        {"$tintHover", mixedName(shades.window, shades.highlight, 34)},
        {"$tint", mixedName(shades.window, shades.highlight, 22)},
        {"$hover", mixedName(shades.window, shades.text, 8)},
        {"$line", mixedName(shades.window, shades.text, &shades == &contrast ? 70 : 14)},
    };
    for (const auto& [name, color] : colors)
        style.replace(QLatin1String(name), color);
    return style;
}

/// What no style sheet can say.
class ThemeStyle : public QProxyStyle {
public:
    ThemeStyle()
        : QProxyStyle(QStringLiteral("Fusion"))
    {}

    /// Fusion's border is darker than the window: in a dark one nobody sees where to click.
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override
    {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        if (element == PE_IndicatorCheckBox)
            drawBorder(*option, *painter, 0.45F);
        else if (element == PE_FrameLineEdit || element == PE_PanelButtonCommand)
            drawBorder(*option, *painter, strengthIn(option->palette));
    }

    /// The same of fields.
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override
    {
        QProxyStyle::drawComplexControl(control, option, painter, widget);
        if (control == CC_SpinBox || control == CC_ComboBox)
            drawBorder(*option, *painter, strengthIn(option->palette));
    }

    /// Fusion's pictures on the buttons of dialogs are black.
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* data) const override
    {
        return hint == SH_DialogButtonBox_ButtonsHaveIcons ? 0 : QProxyStyle::styleHint(hint, option, widget, data);
    }

    /// Of the button behind which a tool bar keeps what it has no room for, Fusion makes a dot.
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override
    {
        return metric == PM_ToolBarExtensionExtent ? 28 : QProxyStyle::pixelMetric(metric, option, widget);
    }

    QIcon standardIcon(StandardPixmap pixmap, const QStyleOption* option, const QWidget* widget) const override
    {
        return pixmap == SP_ToolBarHorizontalExtensionButton ? icon(QStringLiteral("more"))
                                                             : QProxyStyle::standardIcon(pixmap, option, widget);
    }

private:
    /// 0 in a light window.
    static float strengthIn(const QPalette& palette)
    {
        const int lightness = palette.color(QPalette::Window).lightness();
        return lightness > 128 ? 0 : lightness < 16 ? 0.8F : 0.22F;
    }

    static void drawBorder(const QStyleOption& option, QPainter& painter, float strength)
    {
        if (!(strength > 0))
            return;
        QColor border = option.palette.color(QPalette::WindowText);
        border.setAlphaF(option.state & State_Enabled ? strength : 0.45F * strength);
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(border);
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), 2, 2);
        painter.restore();
    }
};

} // namespace

QPalette lightPalette()
{
    return paletteOf(light);
}

void applyTheme(QApplication& application, Theme theme)
{
    static const QPalette system = QApplication::palette();
    static bool styled = false;
    if (!std::exchange(styled, true))
        QApplication::setStyle(new ThemeStyle);
    const bool darkSystem = system.color(QPalette::Window).lightness() < 128;
    const bool isDark = theme == Theme::Dark || (theme == Theme::System && darkSystem);
    const Shades& shades = theme == Theme::HighContrast ? contrast : isDark ? dark : light;
    if (const QPalette colors = paletteOf(shades); colors != QApplication::palette())
        QApplication::setPalette(colors);
    if (const QString style = styleOf(shades); style != application.styleSheet())
        application.setStyleSheet(style);
}

} // namespace bolster
