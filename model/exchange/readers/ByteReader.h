// Numbers of a binary file, in either byte order, with every access checked.
#pragma once

#include "FileBytes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace bolster {

class ByteReader {
public:
    ByteReader(FileBytes bytes, bool bigEndian, std::uint64_t start = 0)
        : m_window(std::move(bytes))
        , m_at(start)
        , m_swapped(bigEndian != (std::endian::native == std::endian::big))
    {}

    FilePlace place() const { return {FilePlace::Unit::Byte, m_at}; }
    std::uint64_t bytesLeft() const { return m_window.size() - m_at; }

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
        std::memcpy(raw.data(), next(raw.size()), raw.size());
        m_at += raw.size();
        if (m_swapped)
            std::reverse(raw.begin(), raw.end());
        return std::bit_cast<Number>(raw);
    }

private:
    const char* next(std::size_t count)
    {
        if (m_at + count > m_start + m_view.size()) {
            m_view = m_window.view(m_at, count);
            m_start = m_at;
        }
        return m_view.data() + (m_at - m_start);
    }

    FileWindow m_window;
    std::string_view m_view;
    std::uint64_t m_start = 0; // of the view
    std::uint64_t m_at;
    bool m_swapped;
};

} // namespace bolster
