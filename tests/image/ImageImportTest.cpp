// Good pictures come in as they are; bad ones are refused with a reason, whatever they do to the decoder.
#include "../model/TestFiles.h"

#include "ImageImport.h"
#include "Sanitizer.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <thread>

namespace bolster {
namespace {

using OIIO::ImageSpec;
using OIIO::TypeDesc;

class ImageImportTest : public TestFiles {
protected:
    template <class Number>
    QString paint(const QString& name, ImageSpec spec, const std::vector<Number>& values, TypeDesc type) const
    {
        const auto output = OIIO::ImageOutput::create(path(name).toStdString());
        EXPECT_TRUE(output && output->open(path(name).toStdString(), spec) &&
                    output->write_image(type, values.data()) && output->close());
        return path(name);
    }

    /// 3 x 2 pixels, opacity in the last.
    QString paintSmall(const QString& name) const
    {
        ImageSpec spec(3, 2, 4, TypeDesc::UINT8);
        spec.attribute("oiio:UnassociatedAlpha", 1); // the values are not premultiplied
        return paint(name, spec, small, TypeDesc::UINT8);
    }

    /// A grey gradient, which every JPEG keeps nearly as it is.
    QString paintGradient(const QString& name, int orientation = 1) const
    {
        ImageSpec spec(64, 32, 3, TypeDesc::UINT8);
        spec.attribute("Orientation", orientation);
        std::vector<std::uint8_t> values;
        for (int i = 0; i < 64 * 32; ++i)
            values.insert(values.end(), 3, static_cast<std::uint8_t>(3 * (i % 64) + i / 64));
        return paint(name, spec, values, TypeDesc::UINT8);
    }

    void expectRefused(const QString& file, const std::string& why, const ImageDecoder& decoder = {}) const
    {
        const ImageOutcome outcome = importImage(file, {}, decoder);
        EXPECT_FALSE(outcome.pixels) << file.toStdString();
        EXPECT_NE(outcome.problem.english().find(why), std::string::npos) << outcome.problem.english();
    }

    /// A decoder that does this instead.
    ImageDecoder doing(const std::string& script) const
    {
        const QString program = write("decoder", "#!/bin/sh\n" + script + "\n");
        QFile::setPermissions(program, QFile::ReadOwner | QFile::ExeOwner);
        return {program};
    }

    const std::vector<std::uint8_t> small = {255, 0,  0,  255, 0, 255, 0, 255, 0, 0, 255, 255,
                                             10,  20, 30, 255, 0, 0,   0, 255, 9, 9, 9,   64};
};

TEST_F(ImageImportTest, ReadsPngAndTiffAsTheyAre)
{
    for (const char* name : {"a.png", "a.tif"}) {
        const ImageOutcome outcome = importImage(paintSmall(name));
        ASSERT_TRUE(outcome.pixels) << outcome.problem.english();
        EXPECT_EQ(*outcome.pixels, (ImagePixels{3, 2, small})) << name;
    }
    QFile::rename(path("a.png"), path("b.jpg"));
    EXPECT_EQ(importImage(path("b.jpg")).pixels->rgba, small) << "the content decides, not the name";
}

TEST_F(ImageImportTest, ReadsGreyAndSixteenBits)
{
    const std::vector<std::uint16_t> grey = {0, 0x8080, 0xFFFF};
    const ImageOutcome png =
        importImage(paint("g.png", ImageSpec(3, 1, 1, TypeDesc::UINT16), grey, TypeDesc::UINT16));
    ASSERT_TRUE(png.pixels) << png.problem.english();
    EXPECT_EQ(png.pixels->rgba, (std::vector<std::uint8_t>{0, 0, 0, 255, 128, 128, 128, 255, 255, 255, 255, 255}));
}

/// Nobody sees more of a fabric, and it is in memory several times while its maps are made.
TEST_F(ImageImportTest, LargePicturesComeSmaller)
{
    constexpr std::size_t width = 5000, height = 3000;
    std::vector<std::uint8_t> values(4 * width * height, 0);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            if (x < width / 2) // the other half is not seen, whatever its colour
                std::fill_n(&values[4 * (y * width + x)], 4, static_cast<std::uint8_t>(x % 3 == 0 ? 255 : 105));
    for (std::size_t i = 3; i < values.size(); i += 4)
        values[i] = values[i] > 0 ? 255 : 0;
    for (const char* name : {"a.png", "a.tif"}) {
        ImageSpec spec(width, height, 4, TypeDesc::UINT8);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        const ImageOutcome outcome = importImage(paint(name, spec, values, TypeDesc::UINT8));
        ASSERT_TRUE(outcome.pixels) << outcome.problem.english();
        EXPECT_EQ(outcome.pixels->width, 1667);
        EXPECT_EQ(outcome.pixels->height, 1000);
        const auto pixel = [&](std::size_t x, std::size_t y) {
            const std::uint8_t* const at = &outcome.pixels->rgba[4 * (1667 * y + x)];
            return std::vector<std::uint8_t>(at, at + 4);
        };
        EXPECT_EQ(pixel(3, 7), (std::vector<std::uint8_t>{155, 155, 155, 255})) << "the mean of three";
        EXPECT_EQ(pixel(833, 999), (std::vector<std::uint8_t>{255, 255, 255, 85})) << "of what is seen";
        EXPECT_EQ(pixel(1666, 999)[3], 0);
    }
}

TEST_F(ImageImportTest, ReadsTiledTiff)
{
    ImageSpec spec(100, 70, 3, TypeDesc::UINT8);
    spec.tile_width = spec.tile_height = 32;
    std::vector<std::uint8_t> values(100 * 70 * 3);
    std::mt19937 random(1);
    std::ranges::generate(values, [&] { return static_cast<std::uint8_t>(random()); });
    const ImageOutcome outcome = importImage(paint("t.tif", spec, values, TypeDesc::UINT8));
    ASSERT_TRUE(outcome.pixels) << outcome.problem.english();
    for (std::size_t i = 0; i < 100 * 70; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            ASSERT_EQ(outcome.pixels->rgba[4 * i + k], values[3 * i + k]) << i;
}

TEST_F(ImageImportTest, ReadsJpegAndTurnsItUpright)
{
    const ImageOutcome plain = importImage(paintGradient("a.jpg"));
    ASSERT_TRUE(plain.pixels) << plain.problem.english();
    EXPECT_EQ(plain.pixels->width, 64);
    EXPECT_NEAR(plain.pixels->rgba[4 * 40], 120, 3);
    const auto at = [](const ImagePixels& image, int x, int y) { return image.rgba[4 * (y * image.width + x)]; };
    for (const int orientation : {2, 3, 4, 5, 6, 7, 8}) {
        const ImageOutcome outcome = importImage(paintGradient("o.jpg", orientation));
        ASSERT_TRUE(outcome.pixels) << outcome.problem.english();
        const ImagePixels& image = *outcome.pixels;
        const bool swapped = orientation >= 5;
        EXPECT_EQ(image.width, swapped ? 32 : 64) << orientation;
        // The first row of the file is the visual top (1, 2), bottom (3, 4), left (5, 8 reversed) or right (6, 7).
        const int right = image.width - 1, bottom = image.height - 1;
        const std::array<std::array<int, 2>, 9> first = {{{},
                                                          {0, 0},
                                                          {right, 0},
                                                          {right, bottom},
                                                          {0, bottom},
                                                          {0, 0},
                                                          {right, 0},
                                                          {right, bottom},
                                                          {0, bottom}}};
        const auto [x, y] = first[static_cast<std::size_t>(orientation)];
        EXPECT_NEAR(at(image, x, y), 0, 4) << orientation;
        EXPECT_NEAR(at(image, right - x, bottom - y), 3 * 63 + 31, 4) << orientation;
        // Along the file's rows the grey grows fast.
        const int alongX = at(image, right - x, y), alongY = at(image, x, bottom - y);
        EXPECT_NEAR(swapped ? alongY : alongX, 3 * 63, 4) << orientation;
    }
}

TEST_F(ImageImportTest, EncodesTheLightOfOpenExr)
{
    const std::vector<float> light = {0, 0.0031308F, 0.2140411F, 1, 7.5F, -1, 0.25F, 0.25F, 0.25F, 0.5F, NAN, 1};
    ImageSpec spec(3, 1, 4, TypeDesc::HALF);
    const ImageOutcome outcome = importImage(paint("a.exr", spec, light, TypeDesc::FLOAT));
    ASSERT_TRUE(outcome.pixels) << outcome.problem.english();
    const std::vector<std::uint8_t>& rgba = outcome.pixels->rgba;
    EXPECT_EQ(rgba[0], 0);
    EXPECT_NEAR(rgba[1], 0.04045 * 255, 1);
    EXPECT_NEAR(rgba[2], 127.5, 1);
    EXPECT_EQ(rgba[3], 255);
    EXPECT_EQ(rgba[4], 255) << "brighter than white";
    EXPECT_EQ(rgba[5], 0);
    EXPECT_EQ(rgba[7], 64) << "a quarter opaque, and the colour no longer multiplied by that";
    EXPECT_EQ(rgba[4], rgba[6]);
    EXPECT_EQ(rgba[10], 0) << "not a number";
}

TEST_F(ImageImportTest, RefusesOtherKindsWhateverTheyAreCalled)
{
    paintSmall("a.tga");
    paintSmall("a.sgi");
    for (const char* name : {"a.tga", "a.sgi"}) {
        expectRefused(path(name), "PNG, JPEG, TIFF and OpenEXR");
        QFile::rename(path(name), path("renamed.png"));
        expectRefused(path("renamed.png"), "PNG, JPEG, TIFF and OpenEXR");
        QFile::remove(path("renamed.png"));
    }
    expectRefused(write("empty.png", ""), "PNG, JPEG, TIFF and OpenEXR");
    expectRefused(write("text.png", "hello"), "PNG, JPEG, TIFF and OpenEXR");
    expectRefused(path("none.png"), "there is no file");
    expectRefused(m_folder.path(), "is a folder");
    expectRefused("/dev/zero", "not an ordinary file");
}

TEST_F(ImageImportTest, RefusesTruncatedFiles)
{
    paintGradient("a.jpg");
    paintGradient("a.png");
    paintGradient("a.tif");
    paintGradient("a.exr");
    for (const char* name : {"a.jpg", "a.png", "a.tif", "a.exr"}) {
        const std::string whole = read(name);
        ASSERT_TRUE(importImage(path(name)).pixels) << name;
        for (const double part : {0.1, 0.5, 0.9})
            expectRefused(write(name, whole.substr(0, static_cast<std::size_t>(part * whole.size()))), "damaged");
    }
}

std::uint32_t crcOf(std::string_view bytes)
{
    std::uint32_t crc = 0xFFFFFFFF;
    for (const char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320 : 0);
    }
    return ~crc;
}

/// A PNG that says it has another size.
std::string withSize(std::string png, std::uint32_t width, std::uint32_t height)
{
    const auto put = [&](std::size_t at, std::uint32_t value) {
        for (int i = 0; i < 4; ++i)
            png[at + static_cast<std::size_t>(i)] = static_cast<char>(value >> (24 - 8 * i));
    };
    put(16, width);
    put(20, height);
    put(29, crcOf(std::string_view(png).substr(12, 17)));
    return png;
}

TEST_F(ImageImportTest, RefusesSizesThatAreTooLargeOrALie)
{
    paintSmall("a.png");
    const std::string png = read("a.png");
    EXPECT_TRUE(importImage(write("same.png", withSize(png, 3, 2))).pixels);
    expectRefused(write("b.png", withSize(png, 60'000, 60'000)), "60000 by 60000 pixels");
    expectRefused(write("b.png", withSize(png, 8193, 8193)), "at most 64 million");
    expectRefused(write("b.png", withSize(png, 0x7FFFFFFF, 0x7FFFFFFF)), "");
    expectRefused(write("b.png", withSize(png, 8000, 8000)), "damaged");
    expectRefused(write("b.png", withSize(png, 3, 3)), "damaged");
    expectRefused(write("b.png", withSize(png, 0, 2)), "damaged");
}

TEST_F(ImageImportTest, SurvivesDamagedFiles)
{
    std::mt19937 random(1);
    for (const char* name : {"a.jpg", "a.png", "a.tif", "a.exr"}) {
        paintGradient(name);
        const std::string whole = read(name);
        for (int i = 0; i < 3; ++i) { // fuzz_image_stream does this by the thousand
            std::string damaged = whole;
            for (int k = 0; k < 4; ++k)
                damaged[8 + random() % (damaged.size() - 8)] = static_cast<char>(random());
            const ImageOutcome outcome = importImage(write(name, damaged));
            EXPECT_NE(outcome.pixels == nullptr, outcome.problem.empty());
        }
    }
}

TEST_F(ImageImportTest, ADecoderThatHangsIsKilled)
{
    const QString file = paintSmall("a.png");
    ImageDecoder decoder = doing("sleep 1000");
    decoder.time = std::chrono::milliseconds(100);
    expectRefused(file, "takes too long", decoder);

    decoder = doing("while :; do :; done");
    decoder.processor = std::chrono::seconds(1);
    expectRefused(file, "cannot be decoded", decoder);
}

TEST_F(ImageImportTest, ADecoderThatDiesOrTalksNonsenseDoesNoHarm)
{
    const QString file = paintSmall("a.png");
    for (const char* script :
         {"kill -SEGV $$", "exit 0", "exit 3", "echo 'hello, I am not a picture at all'",
          "printf 'MILB\\0\\0\\0\\0\\003\\0\\0\\0\\002\\0\\0\\0\\001\\0\\0\\0only some of it'",
          "printf 'MILB\\0\\0\\0\\0\\377\\377\\377\\377\\377\\377\\377\\377\\001\\0\\0\\0'", "cat /dev/zero"})
        expectRefused(file, "cannot be decoded", doing(script));
    expectRefused(file, "install Bolster again", {path("no such program")});
    expectRefused(file, "install Bolster again", {QString()});
    const std::string pixels(24, 'p');
    const ImageDecoder good =
        doing("printf 'MILB\\0\\0\\0\\0\\003\\0\\0\\0\\002\\0\\0\\0\\001\\0\\0\\0" + pixels + "'; sleep 1000");
    const ImageOutcome outcome = importImage(file, {}, good);
    ASSERT_TRUE(outcome.pixels) << "the injected ones above fail for what they do wrong";
    EXPECT_EQ(outcome.pixels->rgba, std::vector<std::uint8_t>(pixels.begin(), pixels.end()));
}

TEST_F(ImageImportTest, ADecoderThatEatsMemoryIsRefusedIt)
{
#ifdef BOLSTER_ADDRESS_SANITIZER
    GTEST_SKIP() << "the sanitizer needs more address space than any limit";
#else
    const QString file = paintSmall("a.png");
    ASSERT_TRUE(importImage(file).pixels);
    ImageDecoder decoder;
    decoder.memory = 1'000'000; // not even its libraries fit
    expectRefused(file, "cannot be decoded", decoder);

    decoder = doing("exec python3 -c 'bytearray(3 << 30)'");
    expectRefused(file, "cannot be decoded", decoder);
#endif
}

TEST_F(ImageImportTest, StopsWhenToldTo)
{
    const QString file = paintSmall("a.png");
    const QString started = path("started");
    std::stop_source stop;
    const std::jthread stopper([&](const std::stop_token& over) {
        while (!QFile::exists(started) && !over.stop_requested())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        stop.request_stop();
    });
    const ImageOutcome outcome =
        importImage(file, stop.get_token(), doing(": > '" + started.toStdString() + "'; sleep 1000"));
    EXPECT_TRUE(QFile::exists(started));
    EXPECT_FALSE(outcome.pixels);
    EXPECT_TRUE(outcome.problem.empty());
}

} // namespace
} // namespace bolster
