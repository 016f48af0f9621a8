// The numbers behind the header of a PLY file, whichever way they are written.
#pragma once

#include "ByteReader.h"
#include "Geometry.h"
#include "PlyHeader.h"

namespace bolster {

/// Throws FileRefused when numbers are missing or wrong.
class PlyBody {
public:
    /// `header` stands where readPlyHeader() has left it; both must outlive the body.
    PlyBody(PlyHeader::Format format, const FileBytes& bytes, TextScanner& header);

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

    /// Calls add(point, place) for each row of an element with x, y and z.
    template <class Add>
    void eachPoint(const PlyElement& element, const Add& add)
    {
        const std::vector<int> axisOf = axes(element);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            const FilePlace where = place();
            Vec3 point;
            for (std::size_t k = 0; k < axisOf.size(); ++k) {
                if (axisOf[k] >= 0)
                    point[axisOf[k]] = number(element.properties[k].type);
                else
                    skip(element.properties[k]);
            }
            add(point, where);
        }
    }

private:
    void require(std::uint64_t rows, std::uint64_t binaryBytesPerRow, std::uint64_t wordsPerRow) const;
    static std::vector<int> axes(const PlyElement& element);
    double binaryNumber(PlyType type);

    bool m_isText;
    TextScanner& m_text;
    ByteReader m_binary;
};

} // namespace bolster
