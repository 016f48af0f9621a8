// What the XML of an E57 file says: its elements, and numbers in them.
#pragma once

#include "E57Pages.h"

#include <map>
#include <optional>
#include <vector>

namespace bolster {

struct E57Node {
    std::string name; ///< with its prefix, which only extensions have
    std::map<std::string, std::string, std::less<>> attributes;
    std::string text;
    std::vector<E57Node> children{};

    /// Null where there is none.
    const E57Node* child(std::string_view called) const;
    /// Of the element itself: Structure, Integer, Float ...
    std::string_view type() const { return attribute("type"); }
    /// "" where there is none.
    std::string_view attribute(std::string_view called) const;
    /// Its text as a number, by whatever type; empty counts as 0. Nothing where it is none.
    std::optional<double> number() const;
    /// Of a child.
    std::optional<double> number(std::string_view called) const;
};

/// Refuses what is not well-formed, too large or too deep. There are no entities but XML's own, as a document type
/// is refused; nothing else is opened.
E57Node readE57Tree(E57Pages& pages, std::uint64_t physical, std::uint64_t length);

std::optional<double> e57Number(std::string_view text);
std::optional<std::int64_t> e57Integer(std::string_view text);

} // namespace bolster
