#include "ImageStream.h"

#include <algorithm>
#include <cstring>

namespace bolster {
namespace {

constexpr std::uint32_t mark = 0x424C494D; // "BLIM"

} // namespace

std::array<char, imageHeadBytes> bytesOf(const ImageHead& head)
{
    const std::uint32_t words[] = {mark, static_cast<std::uint32_t>(head.verdict), head.width, head.height,
                                   head.orientation};
    static_assert(sizeof words == imageHeadBytes);
    std::array<char, imageHeadBytes> bytes;
    std::memcpy(bytes.data(), words, sizeof words);
    return bytes;
}

ImageStreamReader::State ImageStreamReader::take(std::string_view bytes)
{
    const std::size_t ofHead = std::min(bytes.size(), imageHeadBytes - m_headBytes.size());
    m_headBytes.insert(m_headBytes.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(ofHead));
    bytes.remove_prefix(ofHead);
    if (ofHead > 0 && m_headBytes.size() == imageHeadBytes)
        takeHead();
    if (m_state == State::Broken || m_headBytes.size() < imageHeadBytes)
        return m_state;
    if (bytes.size() > m_expected - m_pixels.size()) {
        m_pixels.clear();
        return m_state = State::Broken;
    }
    m_pixels.insert(m_pixels.end(), bytes.begin(), bytes.end());
    if (m_pixels.size() == m_expected)
        m_state = State::Done;
    return m_state;
}

void ImageStreamReader::takeHead()
{
    std::uint32_t words[imageHeadBytes / sizeof(std::uint32_t)];
    std::memcpy(words, m_headBytes.data(), imageHeadBytes);
    const auto verdict = static_cast<ImageVerdict>(words[1]);
    const bool hasPixels = verdict == ImageVerdict::Pixels;
    if (words[0] != mark || words[1] > static_cast<std::uint32_t>(ImageVerdict::NoColours) ||
        (hasPixels && (!imageFits(words[2], words[3]) || words[4] < 1 || words[4] > 8))) {
        m_state = State::Broken;
        return;
    }
    m_head = {verdict, words[2], words[3], words[4]};
    m_expected = hasPixels ? std::size_t{4} * words[2] * words[3] : 0;
    m_pixels.reserve(m_expected);
}

} // namespace bolster
