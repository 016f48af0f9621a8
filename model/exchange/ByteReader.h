// Numbers of a binary file, in either byte order, with every access checked.
#pragma once

#include "FileRefused.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace bolster {

class ByteReader {
public:
    ByteReader(std::string_view bytes, bool bigEndian, std::uint64_t start = 0)
        : m_bytes(bytes)
        , m_at(start)
        , m_swapped(bigEndian != (std::endian::native == std::endian::big))
    {}

    FilePlace place() const { return {FilePlace::Unit::Byte, m_at}; }
    std::uint64_t bytesLeft() const { return m_bytes.size() - m_at; }

    /// Refuses when fewer than `count` rows of this size are left; the sum cannot overflow.
    void require(std::uint64_t count, std::uint64_t bytesPerRow) const
    {
        if (bytesPerRow > 0 && count > bytesLeft() / bytesPerRow)
            refuseFile(place(), QT_TRANSLATE_NOOP("Message", "%1: the file promises more than it holds"));
    }

    void skip(std::uint64_t bytes)
    {
        require(bytes, 1);
        m_at += bytes;
    }

    template <class Number>
    Number read()
    {
        require(1, sizeof(Number));
        std::array<char, sizeof(Number)> raw;
        std::memcpy(raw.data(), m_bytes.data() + m_at, raw.size());
        m_at += raw.size();
        if (m_swapped)
            std::reverse(raw.begin(), raw.end());
        return std::bit_cast<Number>(raw);
    }

private:
    std::string_view m_bytes;
    std::uint64_t m_at;
    bool m_swapped;
};

} // namespace bolster
