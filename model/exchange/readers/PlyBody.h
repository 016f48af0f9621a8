// The numbers behind the header of a PLY file, whichever way they are written.
#pragma once

#include "ByteReader.h"
#include "Geometry.h"
#include "PlyHeader.h"

namespace bolster {

/// Throws FileRefused when numbers are missing or wrong.
class PlyBody {
public:
    /// `text` stands where readPlyHeader() has left it, and must outlive the body.
    PlyBody(const PlyHeader& header, const FileBytes& bytes, TextScanner& text);
    /// At the end: tells the watch of the bytes whether something was left out.
    void warnOfSurplus() const;

    FilePlace place() const { return m_isText ? m_text.place() : m_binary.place(); }

    /// Refuses when so many rows cannot be in the rest of the file.
    void requireRows(const PlyElement& element) const;
    /// Every type fits into a double.
    double number(PlyType type) { return m_isText ? m_text.number(m_text.wordOnAnyLine()) : binaryNumber(type); }
    std::int64_t integer(PlyType type);
    std::uint64_t listSize(const PlyProperty& property);
    void skip(const PlyProperty& property);
    /// All rows of an element.
    void skip(const PlyElement& element);

    /// Behind the last number of a row. Where each row has a line of its own, what else is there is left out:
    /// VCGLIB, for one, writes more than it says in the header.
    void endRow()
    {
        if (m_isText && m_text.moreOnLine() && rowsHaveLines())
            m_surplus = !m_text.restOfLine().empty();
    }

    /// Calls add(point, place, color) for each row of an element with x, y and z; the colour, 0xRRGGBB, where it
    /// has bytes red, green and blue.
    template <class Add>
    void eachPoint(const PlyElement& element, const Add& add)
    {
        const std::vector<int> axisOf = axes(element);
        const std::vector<int> shiftOf = colorShifts(element);
        const bool colored = std::ranges::any_of(shiftOf, [](int shift) { return shift >= 0; });
        for (std::uint64_t i = 0; i < element.count; ++i) {
            const FilePlace where = place();
            Vec3 point;
            std::uint32_t color = 0;
            for (std::size_t k = 0; k < axisOf.size(); ++k) {
                if (axisOf[k] >= 0)
                    point[axisOf[k]] = number(element.properties[k].type);
                else if (shiftOf[k] >= 0)
                    color |= (static_cast<std::uint32_t>(integer(PlyType::Uint8)) & 0xffU) << shiftOf[k];
                else
                    skip(element.properties[k]);
            }
            endRow();
            add(point, where, colored ? std::optional(color) : std::nullopt);
        }
    }

private:
    void require(std::uint64_t rows, std::uint64_t binaryBytesPerRow, std::uint64_t wordsPerRow) const;
    static std::vector<int> axes(const PlyElement& element);
    /// By how many bits each column is shifted in a colour; -1 where it is none.
    static std::vector<int> colorShifts(const PlyElement& element);
    double binaryNumber(PlyType type);
    bool rowsHaveLines();

    FileBytes m_bytes;
    std::uint64_t m_rows = 0;
    std::optional<bool> m_rowsHaveLines;
    bool m_surplus = false;
    bool m_isText;
    TextScanner& m_text;
    ByteReader m_binary;
};

} // namespace bolster
