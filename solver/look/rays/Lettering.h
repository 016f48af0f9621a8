// Text and plain colours over a picture that is drawn already.
#pragma once

#include "Imaging.h"
#include "PreviewRenderer.h"

#include <array>
#include <string>
#include <vector>

namespace bolster {

/// How much of each pixel a line of text covers, 0 to 1.
struct TextMask {
    int width = 0;
    int height = 0;
    std::vector<float> share;
};

using TextAlign = TextOrder::Align;

/// A strip of this size, the text in the middle of its height. `problem` says when there is no font; then nothing
/// is covered. `text`: UTF-8.
TextMask textMask(const std::string& text, int width, int height, TextAlign align, std::string& problem);

/// Red, green and blue as displayed, 0 to 1.
using Tone = std::array<float, 3>;
inline Tone greyTone(float shown)
{
    return {shown, shown, shown};
}

/// Covers a share of a pixel, in the picture's light too where it has one. Pixels outside are passed over.
void cover(PreviewImage& image, int x, int y, float share, const Tone& tone);
void coverWith(PreviewImage& image, const TextMask& mask, int left, int top, const Tone& tone);

} // namespace bolster
