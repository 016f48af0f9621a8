// One column of a table in an E57 file: what its numbers are, and how they are packed.
#pragma once

#include "E57Tree.h"

namespace bolster {

/// An element of a prototype.
struct E57Field {
    std::string name;
    int bits = 0; ///< of one record; 0: the same number in all of them
    bool isFloat = false;
    std::int64_t least = 0; ///< what is added to the packed number
    double scale = 1, offset = 0;
    std::optional<std::pair<double, double>> range{}; ///< from, to: as far as the file says

    /// Nothing of what holds no numbers.
    static std::optional<E57Field> of(const E57Node& element);
};

/// The bytes that belong to a field, from packet to packet, as records.
class E57Column {
public:
    explicit E57Column(E57Field field)
        : m_field(std::move(field))
    {}

    const E57Field& field() const { return m_field; }
    void append(std::string_view bytes) { m_bytes.append(bytes); }
    /// Records that can be taken, at most `limit`.
    std::uint64_t available(std::uint64_t limit) const;
    double next();
    /// Forgets what was taken; how many bytes wait.
    std::size_t compact();

private:
    std::uint64_t take();

    E57Field m_field;
    std::string m_bytes;
    std::size_t m_bit = 0; ///< of them, where the next record begins
};

} // namespace bolster
