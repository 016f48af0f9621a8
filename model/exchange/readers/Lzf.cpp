#include "Lzf.h"

namespace bolster {
namespace {

constexpr std::uint64_t stepsBetweenChecks = 1 << 12; // each makes less than 300 bytes
constexpr std::uint64_t largestRatio = 264 / 2;       // the longest copy from the fewest bytes

} // namespace

bool lzfMayHold(std::uint64_t packedSize, std::uint64_t size)
{
    return size / largestRatio <= packedSize;
}

LzfReader::LzfReader(FileBytes bytes, std::uint64_t start, std::uint64_t packedSize)
    : m_watch(bytes.watch())
    , m_packed(std::move(bytes), false, start)
    , m_start(m_packed.place())
    , m_left(packedSize)
{
    m_packed.require(packedSize, 1);
}

void LzfReader::requireEnd() const
{
    if (m_left > 0 || m_given != m_made)
        refuse();
}

void LzfReader::refuse() const
{
    refuseFile(m_start, QT_TRANSLATE_NOOP("Message", "%1: the compressed points are damaged"));
}

void LzfReader::take(char* to, std::uint64_t count)
{
    while (count > 0) {
        if (m_given == m_made)
            unpackMore();
        for (; count > 0 && m_given < m_made; --count, ++m_given)
            if (to)
                *to++ = m_recent[m_given % m_recent.size()];
    }
}

void LzfReader::unpackMore()
{
    if (++m_steps % stepsBetweenChecks == 0)
        m_watch.checkStop(); // a window of packed bytes may become a hundred of unpacked ones
    const auto next = [this] {
        if (m_left-- == 0)
            refuse();
        return std::uint64_t{m_packed.read<std::uint8_t>()};
    };
    const std::uint64_t control = next();
    if (control < 32) { // bytes as they are
        for (std::uint64_t i = 0; i <= control; ++i)
            put(static_cast<char>(next()));
        return;
    }
    std::uint64_t count = (control >> 5) + 2; // a copy of what was there before
    if (control >> 5 == 7)
        count += next();
    const std::uint64_t back = ((control & 31) << 8) + next() + 1;
    if (back > m_made)
        refuse();
    for (std::uint64_t i = 0; i < count; ++i) // may overlap itself
        put(m_recent[(m_made - back) % m_recent.size()]);
}

} // namespace bolster
