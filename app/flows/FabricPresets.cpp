#include "FabricPresets.h"

#include <QCoreApplication>

namespace bolster {

namespace {

using Kind = FabricLook::Kind;

struct Preset {
    const char* name;
    Kind kind;
    const char* color;
    const char* secondColor; ///< "": derived
    double roughness;
    double scale;
};

constexpr Preset presets[] = {
    {QT_TRANSLATE_NOOP("FabricPresets", "Leather, cognac"), Kind::GrainedLeather, "#95532a", "", 0.46, 2.8},
    {QT_TRANSLATE_NOOP("FabricPresets", "Leather, black"), Kind::GrainedLeather, "#232221", "#0e0d0d", 0.42, 2.4},
    {QT_TRANSLATE_NOOP("FabricPresets", "Leather, cream"), Kind::GrainedLeather, "#ddd0b8", "#a3937a", 0.48, 2.8},
    {QT_TRANSLATE_NOOP("FabricPresets", "Smooth leather, dark brown"), Kind::SmoothLeather, "#4a2c1c", "", 0.36,
     1.5},
    {QT_TRANSLATE_NOOP("FabricPresets", "Smooth leather, red"), Kind::SmoothLeather, "#7d1f1a", "", 0.34, 1.5},
    {QT_TRANSLATE_NOOP("FabricPresets", "Weave, grey"), Kind::Woven, "#6f7378", "#9a9da1", 0.88, 3},
    {QT_TRANSLATE_NOOP("FabricPresets", "Weave, blue"), Kind::Woven, "#2c4766", "#5b7694", 0.88, 3},
    {QT_TRANSLATE_NOOP("FabricPresets", "Weave, sand"), Kind::Woven, "#b7a283", "#d8c9ae", 0.9, 4},
    {QT_TRANSLATE_NOOP("FabricPresets", "Velvet, green"), Kind::Velvet, "#1f5a41", "", 0.9, 5},
    {QT_TRANSLATE_NOOP("FabricPresets", "Velvet, petrol"), Kind::Velvet, "#17505c", "", 0.9, 5},
    {QT_TRANSLATE_NOOP("FabricPresets", "Checker, 20 mm"), Kind::Checker, "#7a4a2b", "", 0.7, 20},
    {QT_TRANSLATE_NOOP("FabricPresets", "Plain"), Kind::Plain, "#8d8f92", "", 0.7, 10},
};

/// Leather gives way alike in all directions; woven threads hardly do, but shear.
void setLimits(Fabric& fabric)
{
    if (fabric.look.kind == Kind::Woven)
        fabric.limits = {4, 5, 15};
    else if (fabric.look.kind == Kind::Velvet)
        fabric.limits = {6, 8, 12};
}

} // namespace

std::vector<Fabric> fabricPresets()
{
    std::vector<Fabric> fabrics;
    for (const Preset& preset : presets) {
        Fabric fabric;
        fabric.name = QCoreApplication::translate("FabricPresets", preset.name).toStdString();
        fabric.color = preset.color;
        fabric.look = usualLook(preset.kind);
        fabric.look.secondColor = preset.secondColor;
        fabric.look.roughness = preset.roughness;
        fabric.look.scale = preset.scale;
        setLimits(fabric);
        fabrics.push_back(std::move(fabric));
    }
    return fabrics;
}

QStringList fabricPresetKeys()
{
    QStringList keys;
    for (const Preset& preset : presets)
        keys << QString::fromLatin1(preset.name);
    return keys;
}

std::optional<Fabric> fabricPreset(const QString& key)
{
    const qsizetype at = fabricPresetKeys().indexOf(key);
    return at < 0 ? std::nullopt : std::optional(fabricPresets()[static_cast<std::size_t>(at)]);
}

} // namespace bolster
