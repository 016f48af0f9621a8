// Pictures on disk, through OpenImageIO.
#pragma once

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

/// Over what is at `path`, from the first byte on: whoever wants the old file or the new one gives a name that
/// nobody else knows (replaceFile). The same picture and notes give the same bytes. Returns what went wrong, or "".
std::string writePicture(const PreviewImage& image, PictureFormat format, const std::string& path,
                         const PictureNotes& notes = {});

} // namespace bolster
