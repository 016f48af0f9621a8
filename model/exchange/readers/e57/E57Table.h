// A table of an E57 file (a CompressedVector): its columns lie in packets, a piece of each in every one.
#pragma once

#include "E57Column.h"

#include <limits>

namespace bolster {

/// Read once, from beginning to end; what is kept of it is what waits for the other columns.
class E57Table {
public:
    /// The pages are asked where the packets begin, and never again.
    E57Table(E57Pages& ahead, const E57Node& vector);

    std::uint64_t recordCount() const { return m_count; }
    /// Logical offsets, begin and end.
    std::pair<std::uint64_t, std::uint64_t> section() const { return {m_start, m_end}; }
    /// Of the columns with numbers; nothing where there is none of that name.
    std::optional<E57Field> field(std::string_view called) const;
    /// Reads this column, too, from now on: its number among those that are read.
    std::size_t want(std::string_view called);
    /// Whether no wanted column takes room, so that all records are one.
    bool isConstant() const;

    /// Calls take(numbers, place) with the wanted columns of each record, in the order in which they were asked
    /// for.
    template <class Take>
    void each(E57Pages& pages, const Take& take)
    {
        requireRecords(pages);
        std::vector<double> numbers(m_columns.size());
        for (std::uint64_t done = 0; done < m_count;) {
            const FilePlace place = readPacket(pages);
            const std::uint64_t ready = readyRecords(m_count - done);
            for (std::uint64_t i = 0; i < ready; ++i) {
                for (std::size_t k = 0; k < numbers.size(); ++k)
                    numbers[k] = m_columns[k].next();
                take(std::as_const(numbers), place);
            }
            done += ready;
            forget(pages);
        }
    }

private:
    void findColumns(const E57Node& prototype);
    void requireRecords(const E57Pages& pages) const;
    FilePlace readPacket(E57Pages& pages);
    void readData(std::string_view packet, FilePlace place);
    std::uint64_t readyRecords(std::uint64_t limit) const;
    void forget(const E57Pages& pages);

    static constexpr std::size_t unread = std::numeric_limits<std::size_t>::max();

    std::uint64_t m_start = 0, m_end = 0; ///< of the section, logical
    std::uint64_t m_at = 0;               ///< the next packet
    std::uint64_t m_count = 0;
    std::vector<std::optional<E57Field>> m_fields; ///< all that there are, in the order of the file
    std::vector<std::size_t> m_columnOf;           ///< of each field, among those that are read
    std::vector<E57Column> m_columns;
};

} // namespace bolster
