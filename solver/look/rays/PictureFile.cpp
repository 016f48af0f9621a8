#include "PictureFile.h"

#include "PictureTones.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace bolster {

namespace {

/// What a screen shows, from light.
std::vector<float> shownLight(const PreviewImage& image)
{
    std::vector<float> all;
    all.reserve(image.light.size());
    for (std::size_t at = 0; at + 4 <= image.light.size(); at += 4) {
        const float* const p = image.light.data() + at;
        const std::array<float, 4> shown = displayedShares({Vec3f(p[0], p[1], p[2]), p[3]});
        all.insert(all.end(), shown.begin(), shown.end());
    }
    return all;
}

OIIO::ImageSpec specOf(const PreviewImage& image, PictureFormat format, const PictureNotes& notes)
{
    const auto type = format == PictureFormat::Exr    ? OIIO::TypeDesc::HALF
                      : format == PictureFormat::Tiff ? OIIO::TypeDesc::UINT16
                                                      : OIIO::TypeDesc::UINT8;
    OIIO::ImageSpec spec(image.width, image.height, 4, type);
    // A TIFF would get it as an Exif directory, which the library cannot write to memory: it breaks the file.
    if (format != PictureFormat::Tiff)
        spec.attribute("oiio:ColorSpace", format == PictureFormat::Exr ? "Linear" : "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", format == PictureFormat::Exr ? 0 : 1);
    spec.attribute("Software", notes.program);
    spec.attribute("DateTime",
                   "    :  :     :  :  "); // unknown (Exif): else TIFF files would differ from run to run
    if (format != PictureFormat::Png)
        spec.attribute("compression", "zip");
    if (!notes.project.empty())
        spec.attribute("DocumentName", notes.project);
    std::string text;
    for (const auto& [name, value] :
         {std::pair("Project", &notes.project), {"Version", &notes.version}, {"View", &notes.view}})
        if (!value->empty())
            text.append(text.empty() ? "" : "\n").append(name).append(": ").append(*value);
    if (!text.empty())
        spec.attribute("ImageDescription", text);
    return spec;
}

/// Returns what went wrong, or "".
std::string encode(const PreviewImage& image, PictureFormat format, const PictureNotes& notes,
                   OIIO::Filesystem::IOVecOutput& bytes)
{
    const char* const plugin = format == PictureFormat::Exr    ? "openexr"
                               : format == PictureFormat::Tiff ? "tiff"
                                                               : "png";
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(plugin);
    if (!output)
        return OIIO::geterror();
    if (!output->set_ioproxy(&bytes) || !output->open("picture", specOf(image, format, notes)))
        return output->geterror();
    const bool good =
        format == PictureFormat::Png
            ? output->write_image(OIIO::TypeDesc::UINT8, image.rgba.data())
            : output->write_image(OIIO::TypeDesc::FLOAT,
                                  format == PictureFormat::Exr ? image.light.data() : shownLight(image).data());
    return good && output->close() ? std::string() : output->geterror();
}

} // namespace

std::optional<PictureFormat> pictureFormat(std::string_view path)
{
    const std::size_t dot = path.rfind('.');
    std::string ending(dot == std::string_view::npos ? "" : path.substr(dot + 1));
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (ending == "png")
        return PictureFormat::Png;
    if (ending == "tif" || ending == "tiff")
        return PictureFormat::Tiff;
    if (ending == "exr")
        return PictureFormat::Exr;
    return std::nullopt;
}

bool needsLight(PictureFormat format)
{
    return format != PictureFormat::Png;
}

std::string numberedPath(const std::string& path, int number)
{
    const std::filesystem::path whole(path);
    const std::string digits = std::to_string(number);
    const std::string zeros(digits.size() < 3 ? 3 - digits.size() : 0, '0');
    std::filesystem::path name = whole.stem();
    name += "-" + zeros + digits;
    name += whole.extension();
    return (whole.parent_path() / name).string();
}

EncodedPicture encodePicture(const PreviewImage& image, PictureFormat format, const PictureNotes& notes)
{
    if (image.empty() || (needsLight(format) && image.light.size() != image.rgba.size()))
        return {{}, {QT_TRANSLATE_NOOP("Message", "there is no picture to write"), {}}};
    OIIO::Filesystem::IOVecOutput bytes;
    const std::string why = encode(image, format, notes, bytes);
    if (!why.empty() || bytes.buffer().empty())
        return {{}, {QT_TRANSLATE_NOOP("Message", "the picture cannot be encoded (%1)"), {why}}};
    return {std::string(bytes.buffer().begin(), bytes.buffer().end()), {}};
}

} // namespace bolster
