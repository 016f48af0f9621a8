#include "MouseStyle.h"

#include <QCoreApplication>
#include <QStringList>
#include <QWheelEvent>

#include <algorithm>
#include <bit>

namespace bolster {

namespace {

struct MouseWords {
    Q_DECLARE_TR_FUNCTIONS(MouseStyle)
};

using Bindings = std::vector<MouseBinding>;

/// For who has no middle button.
Bindings withAlt(Bindings bindings)
{
    bindings.insert(bindings.end(), {{ViewMove::Turn, Qt::LeftButton, Qt::AltModifier},
                                     {ViewMove::Pan, Qt::LeftButton, Qt::AltModifier | Qt::ShiftModifier},
                                     {ViewMove::Zoom, Qt::LeftButton, Qt::AltModifier | Qt::ControlModifier}});
    return bindings;
}

const Bindings& bindingsOf(const MousePreset& preset, MouseView view)
{
    return view == MouseView::Cover ? preset.cover : preset.pattern;
}

QString textOf(const MouseBinding& binding)
{
    QString keys;
    for (const auto& [key, name] :
         {std::pair(Qt::ControlModifier, MouseWords::tr("Ctrl")), std::pair(Qt::AltModifier, MouseWords::tr("Alt")),
          std::pair(Qt::ShiftModifier, MouseWords::tr("Shift"))})
        if (binding.keys & key)
            keys += name + u'+';
    return keys + (binding.button == Qt::MiddleButton  ? MouseWords::tr("middle button")
                   : binding.button == Qt::RightButton ? MouseWords::tr("right button")
                                                       : MouseWords::tr("drag"));
}

QStringList textsOf(MouseView view, ViewMove move)
{
    const MousePreset& preset = *MouseStyles::now().preset;
    QStringList texts;
    if (preset.scrollPans && move == ViewMove::Pan)
        texts << MouseWords::tr("two fingers");
    if (move == ViewMove::Zoom)
        texts << (preset.scrollPans ? MouseWords::tr("pinch or Ctrl+wheel") : MouseWords::tr("wheel"));
    for (const MouseBinding& binding : bindingsOf(preset, view))
        if (binding.move == move)
            texts << textOf(binding);
    return texts;
}

} // namespace

const std::vector<MousePreset>& mousePresets()
{
    constexpr auto left = Qt::LeftButton, middle = Qt::MiddleButton, right = Qt::RightButton;
    constexpr auto shift = Qt::ShiftModifier, ctrl = Qt::ControlModifier, alt = Qt::AltModifier;
    constexpr auto turns = ViewMove::Turn, pans = ViewMove::Pan, zooms = ViewMove::Zoom;
    static const std::vector<MousePreset> presets{
        {"bolster",
         QT_TRANSLATE_NOOP("MouseStyle", "Bolster"),
         {{turns, middle},
          {turns, right},
          {turns, left, alt},
          {pans, middle, shift},
          {pans, right, shift},
          {pans, left, alt | shift}},
         {{pans, middle}}},
        {"cad",
         QT_TRANSLATE_NOOP("MouseStyle", "CAD (like SolidWorks)"),
         withAlt({{turns, middle}, {pans, middle, ctrl}, {zooms, middle, shift}}),
         {{pans, middle}, {zooms, middle, shift}}},
        {"blender",
         QT_TRANSLATE_NOOP("MouseStyle", "Blender"),
         withAlt({{turns, middle}, {pans, middle, shift}, {zooms, middle, ctrl}}),
         {{pans, middle}, {zooms, middle, ctrl}}},
        {"clo",
         QT_TRANSLATE_NOOP("MouseStyle", "CLO, Marvelous Designer"),
         withAlt({{turns, right}, {pans, middle}}),
         {{pans, middle}}},
        {"touchpad",
         QT_TRANSLATE_NOOP("MouseStyle", "Touchpad"),
         withAlt({{turns, middle}, {turns, right}, {pans, middle, shift}, {pans, right, shift}}),
         {{pans, middle}},
         true},
    };
    return presets;
}

MouseStyles& MouseStyles::instance()
{
    static MouseStyles styles;
    return styles;
}

void MouseStyles::set(const MouseStyle& style)
{
    if (style == m_now)
        return;
    m_now = style;
    emit changed();
}

ViewMove moveOf(const MousePreset& preset, MouseView view, Qt::MouseButton button, Qt::KeyboardModifiers keys)
{
    ViewMove move = ViewMove::None;
    int most = -1;
    for (const MouseBinding& binding : bindingsOf(preset, view)) {
        const bool fits = binding.button == button && (keys & binding.keys) == binding.keys;
        if (const int count = std::popcount(static_cast<unsigned>(binding.keys.toInt())); fits && count > most) {
            most = count;
            move = binding.move;
        }
    }
    return move;
}

ViewMove moveOf(MouseView view, Qt::MouseButton button, Qt::KeyboardModifiers keys)
{
    return moveOf(*MouseStyles::now().preset, view, button, keys);
}

WheelMove moveOf(const QWheelEvent& event)
{
    constexpr double pixelsPerNotch = 60, anglePerNotch = 120;
    const MouseStyle& style = MouseStyles::now();
    if (style.preset->scrollPans && !(event.modifiers() & Qt::ControlModifier))
        return {0, event.pixelDelta().isNull() ? pixelsPerNotch / anglePerNotch * QPointF(event.angleDelta())
                                               : QPointF(event.pixelDelta())};
    return {(style.invertZoom ? -1 : 1) * event.angleDelta().y() / anglePerNotch, {}};
}

double zoomOfDrag(double down)
{
    constexpr double pixelsPerNotch = 25;
    return (MouseStyles::now().invertZoom ? down : -down) / pixelsPerNotch;
}

QString mouseText(MouseView view, ViewMove move)
{
    return textsOf(view, move).value(0);
}

QString allMouseTexts(MouseView view, ViewMove move)
{
    return textsOf(view, move).join(QStringLiteral(", "));
}

} // namespace bolster
