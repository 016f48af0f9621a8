#include "FileFormats.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace bolster {
namespace {

constexpr FileFormat knownFormats[] = {
    {FileUse::Design, "Bolster project", "bolster", false, "application/x-bolster-project"},
    {FileUse::Design, "Bolster design", "json", false, "application/x-bolster-design"},

    {FileUse::Frame, "OBJ", "obj"},
    {FileUse::Frame, "PLY", "ply"},
    {FileUse::Frame, "STL", "stl"},
    {FileUse::Frame, "OFF", "off"},
    {FileUse::Frame, "STEP", "step"},
    {FileUse::Frame, "STEP", "stp"},
    {FileUse::Frame, "IGES", "iges"},
    {FileUse::Frame, "IGES", "igs"},
    {FileUse::Frame, "glTF", "gltf"},
    {FileUse::Frame, "glTF", "glb"},
    {FileUse::Frame, "FBX", "fbx"},
    {FileUse::Frame, "COLLADA", "dae"},
    {FileUse::Frame, "3MF", "3mf"},

    {FileUse::Scan, "E57", "e57"},
    {FileUse::Scan, "LAS", "las"},
    {FileUse::Scan, "LAZ", "laz", true},
    {FileUse::Scan, "PTX", "ptx"},
    {FileUse::Scan, "PTS", "pts"},
    {FileUse::Scan, "PLY", "ply"},
    {FileUse::Scan, "XYZ", "xyz"},
    {FileUse::Scan, "PCD", "pcd"},
    {FileUse::Scan, "OBJ", "obj"},
    {FileUse::Scan, "STL", "stl"},
    {FileUse::Scan, "OFF", "off"},

    {FileUse::Pattern, "DXF", "dxf"},
    {FileUse::Pattern, "SVG", "svg"},

    {FileUse::Picture, "PNG", "png"},
    {FileUse::Picture, "JPEG", "jpg"},
    {FileUse::Picture, "JPEG", "jpeg"},
    {FileUse::Picture, "TIFF", "tif"},
    {FileUse::Picture, "TIFF", "tiff"},
    {FileUse::Picture, "OpenEXR", "exr"},

    {FileUse::CoverOut, QT_TRANSLATE_NOOP("FileFormats", "Page for the customer"), "html"},
    {FileUse::CoverOut, "glTF", "glb"},
    {FileUse::CoverOut, QT_TRANSLATE_NOOP("FileFormats", "USDZ, for phones"), "usdz"},
    {FileUse::CoverOut, QT_TRANSLATE_NOOP("FileFormats", "OBJ with materials"), "obj"},
    {FileUse::CoverOut, QT_TRANSLATE_NOOP("FileFormats", "STL, with a thickness"), "stl"},
    {FileUse::CoverOut, QT_TRANSLATE_NOOP("FileFormats", "3MF, with a thickness"), "3mf"},
    {FileUse::CoverOut, QT_TRANSLATE_NOOP("FileFormats", "STEP, curves alone"), "step"},

    {FileUse::FoamOut, "STL", "stl"},
    {FileUse::FoamOut, "3MF", "3mf"},
    {FileUse::FoamOut, QT_TRANSLATE_NOOP("FileFormats", "STEP, of flat faces"), "step"},

    {FileUse::SurfaceOut, "OBJ", "obj"},
    {FileUse::SurfaceOut, "PLY", "ply"},

    {FileUse::FrameOut, "OBJ", "obj"},
    {FileUse::FrameOut, "PLY", "ply"},
    {FileUse::FrameOut, "STL", "stl"},

    {FileUse::PatternOut, "PDF", "pdf"},
    {FileUse::PatternOut, "DXF", "dxf"},
    {FileUse::PatternOut, "SVG", "svg"},
    {FileUse::PatternOut, "HPGL", "plt"},
};

} // namespace

std::span<const FileFormat> fileFormats()
{
    return knownFormats;
}

QString formatName(const FileFormat& format)
{
    return QCoreApplication::translate("FileFormats", format.name);
}

QStringList endingsOf(FileUse use)
{
    QStringList endings;
    for (const FileFormat& format : knownFormats)
        if (format.use == use)
            endings.append(QLatin1String(format.ending));
    return endings;
}

QString filtersOf(FileUse use)
{
    QStringList filters;
    for (const FileFormat& format : knownFormats)
        if (format.use == use)
            filters.append(QStringLiteral("%1 (*.%2)").arg(formatName(format), QLatin1String(format.ending)));
    return filters.join(QStringLiteral(";;"));
}

QString patternsOf(FileUse use)
{
    QStringList patterns;
    for (const QString& ending : endingsOf(use))
        for (const QString& written : {ending, ending.toUpper()}) // some dialogs tell them apart
            patterns.append(QStringLiteral("*.") + written);
    return patterns.join(u' ');
}

std::string namesOf(FileUse use)
{
    QStringList names;
    for (const FileFormat& format : knownFormats)
        if (const QLatin1String name(format.name); format.use == use && !format.refused && !names.contains(name))
            names.append(name);
    return names.join(QStringLiteral(", ")).toStdString();
}

bool isFileOf(FileUse use, const QString& file)
{
    return endingsOf(use).contains(endingOf(file));
}

QString endingOf(const QString& file)
{
    return QFileInfo(file).suffix().toLower();
}

} // namespace bolster
