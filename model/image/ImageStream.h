// What the process that decodes pictures says to the one that has started it: a head, then the pixels.
#pragma once

#include "ImageKind.h"

#include <array>
#include <string_view>
#include <vector>

namespace bolster {

/// How it ended.
enum class ImageVerdict : std::uint32_t { Pixels, UnknownKind, TooLarge, Damaged, NoColours };

struct ImageHead {
    ImageVerdict verdict = ImageVerdict::Damaged;
    std::uint32_t width = 0; ///< pixels that follow; of one that is too large those that it has
    std::uint32_t height = 0;
    std::uint32_t orientation = 1; ///< 1 to 8, as Exif has it: how the rows that follow have to be turned
};

inline constexpr std::size_t imageHeadBytes = 20;
std::array<char, imageHeadBytes> bytesOf(const ImageHead& head);

/// Takes the bytes as they come. They are not trusted: whoever has taken over the decoder may send anything.
class ImageStreamReader {
public:
    enum class State {
        Unfinished,
        Done,  ///< the head and, if there are any, all the pixels are there
        Broken ///< nothing that is expected
    };

    State take(std::string_view bytes);
    State state() const { return m_state; }
    const ImageHead& head() const { return m_head; }
    /// Of a picture that is Done: width x height x RGBA as they lie in the file, not turned yet.
    std::vector<std::uint8_t> takePixels() { return std::move(m_pixels); }

private:
    void takeHead();

    State m_state = State::Unfinished;
    ImageHead m_head;
    std::vector<char> m_headBytes;
    std::vector<std::uint8_t> m_pixels;
    std::size_t m_expected = 0;
};

} // namespace bolster
