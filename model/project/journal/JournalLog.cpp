#include "JournalLog.h"

#include "DiskFile.h"
#include "Schema.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace bolster {
namespace {

constexpr std::size_t logHeadSize = 32;
constexpr std::size_t frameHeadSize = 24; // a page follows
constexpr std::uint32_t logMagic = 0x377F0682;

std::uint32_t wordAt(std::string_view bytes, std::size_t at, bool bigEndian = true)
{
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i)
        word |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + i])} << (bigEndian ? 24 - 8 * i : 8 * i);
    return word;
}

/// Of all that was written to the log so far.
class LogSum {
public:
    explicit LogSum(bool bigEndian)
        : m_bigEndian(bigEndian)
    {}

    void add(std::string_view bytes)
    {
        for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8) {
            m_first += wordAt(bytes, at, m_bigEndian) + m_second;
            m_second += wordAt(bytes, at + 4, m_bigEndian) + m_first;
        }
    }
    bool standsAt(std::string_view bytes, std::size_t at) const
    {
        return wordAt(bytes, at) == m_first && wordAt(bytes, at + 4) == m_second;
    }

private:
    bool m_bigEndian;
    std::uint32_t m_first = 0;
    std::uint32_t m_second = 0;
};

class LogReader {
public:
    /// `head` is that of the log.
    explicit LogReader(std::string_view head)
        : m_salts{wordAt(head, 16), wordAt(head, 20)}
        , m_sum(wordAt(head, 0) == logMagic + 1)
    {
        m_sum.add(head.substr(0, 24));
        m_whole = (wordAt(head, 0) | 1) == logMagic + 1 && m_sum.standsAt(head, 24);
    }

    /// Returns whether more was stored behind what is damaged.
    bool add(std::string_view frame)
    {
        const std::uint32_t first = wordAt(frame, 8), second = wordAt(frame, 12);
        if (m_whole) {
            m_sum.add(frame.substr(0, 8));
            m_sum.add(frame.substr(frameHeadSize));
            m_whole = first == m_salts[0] && second == m_salts[1] && m_sum.standsAt(frame, 16);
        }
        // What an older log has left has other salts, both of them; what is damaged may have lost one.
        if (m_whole || (first != m_salts[0] && second != m_salts[1]))
            return false;
        const bool behind = m_stepEnded;
        m_stepEnded = m_stepEnded || wordAt(frame, 4) != 0;
        return behind;
    }

private:
    std::array<std::uint32_t, 2> m_salts;
    LogSum m_sum;
    bool m_whole = true;
    bool m_stepEnded = false; ///< one that cannot be read
};

} // namespace

bool logBreaksOff(const QString& log)
{
    Message problem;
    const auto file = DiskFile::open(log, std::numeric_limits<std::int64_t>::max(), problem);
    std::string bytes(logHeadSize, '\0');
    if (!file || file->read(0, bytes.data(), bytes.size()) < static_cast<std::int64_t>(bytes.size()))
        return false;
    LogReader reader(bytes);
    bytes.resize(frameHeadSize + pageSize);
    for (std::uint64_t at = logHeadSize; at + bytes.size() <= file->size(); at += bytes.size())
        if (file->read(at, bytes.data(), bytes.size()) < static_cast<std::int64_t>(bytes.size()) ||
            reader.add(bytes))
            return true;
    return false;
}

} // namespace bolster
