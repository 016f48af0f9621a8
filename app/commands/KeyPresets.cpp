#include "KeyPresets.h"

#include <QCoreApplication>

namespace bolster {

const std::vector<KeyPreset>& keyPresets()
{
    const auto k = [](auto keys) { return QKeySequence(keys); };
    static const std::vector<KeyPreset> presets{
        {"bolster", QT_TRANSLATE_NOOP("KeyPresets", "Bolster"), {}},
        {"blender",
         QT_TRANSLATE_NOOP("KeyPresets", "Blender"),
         {
             {"edit.select-all", k(Qt::Key_A)},
             {"edit.select-nothing", k(Qt::CTRL | Qt::Key_A)},
             {"layer.scans", k(Qt::CTRL | Qt::SHIFT | Qt::Key_A)},
             {"edit.duplicate", k(Qt::SHIFT | Qt::Key_D)},
             {"tool.dart", k(Qt::CTRL | Qt::Key_D)},
             {"edit.delete", k(Qt::Key_X)},
             {"view.hide", k(Qt::Key_H)},
             {"tool.handle-curve", k(Qt::SHIFT | Qt::Key_H)},
             {"view.isolate", k(Qt::Key_Slash)},
             {"view.fit-selection", k(Qt::Key_Period)},
             {"view.from-right", k(Qt::Key_3)},
             {"view.from-left", k(Qt::Key_4)},
             {"view.perspective", k(Qt::Key_5)},
             {"view.from-top", k(Qt::Key_7)},
             {"view.from-bottom", k(Qt::Key_8)},
             {"help.find-command", k(Qt::Key_F3)},
         }},
        {"clo",
         QT_TRANSLATE_NOOP("KeyPresets", "CLO, Marvelous Designer"),
         {
             {"tool.select", k(Qt::Key_A)},
             {"layer.scans", k(Qt::CTRL | Qt::ALT | Qt::Key_N)},
             {"tool.outline", k(Qt::Key_H)},
             {"tool.handle-curve", k(Qt::Key_J)},
             {"tool.rectangle", k(Qt::Key_S)},
             {"layer.seams", k(Qt::CTRL | Qt::ALT | Qt::Key_B)},
             {"tool.ellipse", k(Qt::Key_E)},
             {"tool.dart", k(Qt::Key_D)},
             {"map.deviation", k(Qt::CTRL | Qt::ALT | Qt::Key_D)},
             {"tool.sew", k(Qt::Key_N)},
             {"tool.fancy-seam", k(Qt::Key_Y)},
             {"view.from-front", k(Qt::Key_2)},
             {"view.from-back", k(Qt::Key_8)},
             {"view.from-left", k(Qt::Key_4)},
             {"view.from-right", k(Qt::Key_6)},
             {"view.from-top", k(Qt::Key_5)},
             {"view.from-bottom", k(Qt::Key_0)},
             {"view.from-three-quarter", k(Qt::Key_1)},
         }},
    };
    return presets;
}

const KeyPreset& keyPreset(const QString& id)
{
    for (const KeyPreset& preset : keyPresets())
        if (id == QLatin1String(preset.id))
            return preset;
    return keyPresets().front();
}

} // namespace bolster
