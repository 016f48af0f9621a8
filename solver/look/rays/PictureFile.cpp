#include "PictureFile.h"

#include "Imaging.h"
#include "PictureTones.h"

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

EncodeOrder orderFor(const PreviewImage& image, PictureFormat format, const PictureNotes& notes)
{
    EncodeOrder order;
    order.width = image.width;
    order.height = image.height;
    order.format = format == PictureFormat::Exr ? "openexr" : format == PictureFormat::Tiff ? "tiff" : "png";
    order.depth = format == PictureFormat::Exr    ? EncodeOrder::Depth::Halves
                  : format == PictureFormat::Tiff ? EncodeOrder::Depth::Shorts
                                                  : EncodeOrder::Depth::Bytes;
    // A TIFF would get it as an Exif directory, which the library cannot write to memory: it breaks the file.
    if (format != PictureFormat::Tiff)
        order.words.emplace_back("oiio:ColorSpace", format == PictureFormat::Exr ? "Linear" : "sRGB");
    order.numbers.emplace_back("oiio:UnassociatedAlpha", format == PictureFormat::Exr ? 0 : 1);
    order.words.emplace_back("Software", notes.program);
    order.words.emplace_back("DateTime",
                             "    :  :     :  :  "); // unknown (Exif): else TIFF files would differ from run to run
    if (format != PictureFormat::Png)
        order.words.emplace_back("compression", "zip");
    if (!notes.project.empty())
        order.words.emplace_back("DocumentName", notes.project);
    std::string text;
    for (const auto& [name, value] :
         {std::pair("Project", &notes.project), {"Version", &notes.version}, {"View", &notes.view}})
        if (!value->empty())
            text.append(text.empty() ? "" : "\n").append(name).append(": ").append(*value);
    if (!text.empty())
        order.words.emplace_back("ImageDescription", text);
    return order;
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
    EncodeOrder order = orderFor(image, format, notes);
    std::vector<float> shown;
    if (format == PictureFormat::Png) {
        order.bytes = image.rgba.data();
    } else if (format == PictureFormat::Exr) {
        order.floats = image.light.data();
    } else {
        shown = shownLight(image);
        order.floats = shown.data();
    }
    EncodedPicture encoded;
    std::string why;
    encoded.bytes = imaging().encode(order, why);
    if (encoded.bytes.empty())
        encoded.problem = {QT_TRANSLATE_NOOP("Message", "the picture cannot be encoded (%1)"), {why}};
    return encoded;
}

} // namespace bolster
