// What comes from the decoder is looked at as closely as what goes there.
#include "ImageStream.h"

#include <gtest/gtest.h>

#include <string>

namespace bolster {
namespace {

using State = ImageStreamReader::State;

std::string headText(const ImageHead& head)
{
    const auto bytes = bytesOf(head);
    return {bytes.data(), bytes.size()};
}

TEST(ImageStream, TakesPiecesOfAnySize)
{
    const std::string stream = headText({ImageVerdict::Pixels, 2, 1, 6}) + "abcdefgh";
    for (std::size_t piece = 1; piece <= stream.size(); ++piece) {
        ImageStreamReader reader;
        for (std::size_t at = 0; at < stream.size(); at += piece) {
            EXPECT_EQ(reader.state(), State::Unfinished);
            reader.take(std::string_view(stream).substr(at, piece));
        }
        EXPECT_EQ(reader.state(), State::Done) << piece;
        EXPECT_EQ(reader.head().orientation, 6u);
        const auto pixels = reader.takePixels();
        EXPECT_EQ(std::string(pixels.begin(), pixels.end()), "abcdefgh");
    }
}

TEST(ImageStream, BreaksAtWhatCannotBe)
{
    for (const ImageHead& head :
         {ImageHead{ImageVerdict::Pixels, 0, 1, 1}, ImageHead{ImageVerdict::Pixels, 8193, 8192, 1},
          ImageHead{ImageVerdict::Pixels, 0xFFFFFFFF, 0xFFFFFFFF, 1}, ImageHead{ImageVerdict::Pixels, 1, 1, 9},
          ImageHead{ImageVerdict::Pixels, 1, 1, 0}, ImageHead{static_cast<ImageVerdict>(17), 1, 1, 1}}) {
        ImageStreamReader reader;
        EXPECT_EQ(reader.take(headText(head)), State::Broken);
        EXPECT_EQ(reader.take("more"), State::Broken);
    }
    ImageStreamReader tooMuch;
    EXPECT_EQ(tooMuch.take(headText({ImageVerdict::Pixels, 1, 1, 1}) + "12345"), State::Broken);
    ImageStreamReader verdict;
    EXPECT_EQ(verdict.take(headText({ImageVerdict::Damaged})), State::Done);
}

TEST(ImageKind, IsToldByTheFirstBytes)
{
    using namespace std::string_view_literals;
    EXPECT_EQ(imageKindOf("\x89PNG\r\n\x1a\n...."sv), ImageKind::Png);
    EXPECT_EQ(imageKindOf("\xff\xd8\xff\xe0"sv), ImageKind::Jpeg);
    EXPECT_EQ(imageKindOf("II*\0"sv), ImageKind::Tiff);
    EXPECT_EQ(imageKindOf("\x76\x2f\x31\x01"sv), ImageKind::Exr);
    for (const std::string_view other :
         {""sv, "\x89PNG"sv, "GIF89a"sv, "\x01\xda\x01\x01"sv, "BM"sv, "<svg"sv, "II*"sv})
        EXPECT_FALSE(imageKindOf(other)) << other;
}

TEST(ImageKind, SizesAreLimitedWithoutOverflow)
{
    EXPECT_TRUE(imageFits(8192, 8192));
    EXPECT_FALSE(imageFits(8193, 8192));
    EXPECT_FALSE(imageFits(0, 5));
    EXPECT_FALSE(imageFits(1ull << 32, 1ull << 32));
}

TEST(ImageKind, AJpegEndsWithItsMark)
{
    using namespace std::string_literals;
    const std::string head("\xff\xd8\xff\xe1\x00\x06\xff\xd9\xff\xd9\xff\xda", 12); // an end mark inside a comment
    EXPECT_TRUE(jpegIsWhole(head + "\x12\xff\0\x34\xff\xd0\x56\xff\xd9 and more"s));
    EXPECT_TRUE(jpegIsWhole(head + "\xff\xd9"));
    EXPECT_FALSE(jpegIsWhole(head + "\x12\xff\0\x34\xff\xd0\x56"s));
    EXPECT_FALSE(jpegIsWhole(""));
    EXPECT_FALSE(jpegIsWhole("\xff\xd8\xff"));
}

} // namespace
} // namespace bolster
