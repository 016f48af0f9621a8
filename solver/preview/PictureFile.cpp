#include "PreviewRenderer.h"

#include <OpenImageIO/imageio.h>

#include <filesystem>

namespace bolster {

namespace {

std::string written(const PreviewImage& image, const std::string& path)
{
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("png");
    if (!output)
        return OIIO::geterror();
    OIIO::ImageSpec spec(image.width, image.height, 4, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("Software", "Bolster");
    if (!output->open(path, spec) || !output->write_image(OIIO::TypeDesc::UINT8, image.rgba.data()) ||
        !output->close())
        return output->geterror();
    return {};
}

} // namespace

std::string writePng(const PreviewImage& image, const std::string& path)
{
    if (image.empty())
        return "There is no picture to write";
    const std::string unfinished = path + ".part";
    std::string problem = written(image, unfinished);
    std::error_code error;
    if (problem.empty()) {
        std::filesystem::rename(unfinished, path, error);
        if (!error)
            return {};
        problem = error.message();
    }
    std::filesystem::remove(unfinished, error);
    return problem;
}

} // namespace bolster
