#include "FileFormats.h"

#include <QFileInfo>

namespace bolster {
namespace {

constexpr FileFormat formats[] = {
    {FileUse::Design, "Bolster project", "bolster"},
    {FileUse::Design, "Bolster design", "json"},

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

    {FileUse::Scan, "PLY", "ply"},
    {FileUse::Scan, "XYZ", "xyz"},
    {FileUse::Scan, "PCD", "pcd"},

    {FileUse::Pattern, "DXF", "dxf"},
    {FileUse::Pattern, "SVG", "svg"},

    {FileUse::Picture, "PNG", "png"},
    {FileUse::Picture, "JPEG", "jpg"},
    {FileUse::Picture, "JPEG", "jpeg"},
    {FileUse::Picture, "TIFF", "tif"},
    {FileUse::Picture, "TIFF", "tiff"},
    {FileUse::Picture, "OpenEXR", "exr"},
};

} // namespace

std::span<const FileFormat> readFormats()
{
    return formats;
}

QStringList endingsOf(FileUse use)
{
    QStringList endings;
    for (const FileFormat& format : formats)
        if (format.use == use)
            endings.append(QLatin1String(format.ending));
    return endings;
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
    for (const FileFormat& format : formats)
        if (const QLatin1String name(format.name); format.use == use && !names.contains(name))
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
