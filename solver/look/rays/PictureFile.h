// Pictures as files, through OpenImageIO.
#pragma once

#include "Message.h"
#include "PreviewRenderer.h"

#include <string_view>

namespace bolster {

enum class PictureFormat {
    Png,  ///< 8 bits, sRGB
    Tiff, ///< 16 bits, sRGB
    Exr   ///< 16-bit floats, linear light
};

/// By the ending of the file's name: png, tif, tiff, exr.
std::optional<PictureFormat> pictureFormat(std::string_view path);
/// Whether PreviewOptions::light is needed.
bool needsLight(PictureFormat format);

/// "chair.png" and 1 become "chair-001.png".
std::string numberedPath(const std::string& path, int number);

/// What is written beside the pixels, for those who find the file later.
struct PictureNotes {
    std::string project;
    std::string version; ///< of the design
    std::string view;
    std::string program = "Bolster";
};

/// The bytes of a file. Whoever writes them sees whether the disk takes them; image libraries do not always tell.
struct EncodedPicture {
    std::string bytes;
    Message problem; ///< why there are none
};
/// The same picture and notes give the same bytes.
EncodedPicture encodePicture(const PreviewImage& image, PictureFormat format, const PictureNotes& notes = {});

} // namespace bolster
