// The keys of one JSON object, with what is wrong about them. Private to the library.
#pragma once

#include "Geometry.h"
#include "JsonText.h"
#include "Problem.h"

#include <array>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace bolster::json {

/// Gathers the problems of one element. Of a thoroughly broken one the first hundred.
class Report {
public:
    Report(ElementId element, std::string label);

    void add(std::string field, Message message);
    bool clean() const { return m_problems.empty(); }
    /// Of all that were added.
    std::size_t count() const { return m_problems.size() + m_unlisted; }
    const Problems& problems() const { return m_problems; }

private:
    ElementId m_element;
    std::string m_label;
    Problems m_problems;
    std::size_t m_unlisted = 0;
};

/// A value that must be a number; reports under `field` if it is none or beyond +-limit.
double numberIn(const Value& value, const std::string& field, Report& report,
                double limit = std::numeric_limits<double>::max());
/// A whole number within [low, high].
int integerIn(const Value& value, const std::string& field, Report& report, int low, int high);

/// Each getter marks its key as known; after them `finish` reports the rest. A getter without a fallback reports a
/// missing key. Whatever is wrong, getters return something harmless.
class Fields {
public:
    /// `path` stands before each key in reports, for instance "outline.". Keys that occur twice are reported.
    Fields(const Value& object, std::string path, Report& report);

    const Value* optional(std::string_view key);
    const Value* required(std::string_view key);
    bool has(std::string_view key) const;
    std::string fieldOf(std::string_view key) const;
    Report& report() { return m_report; }

    double number(std::string_view key);
    double number(std::string_view key, double fallback);
    bool flag(std::string_view key);
    bool flag(std::string_view key, bool fallback);
    std::string text(std::string_view key);
    std::string text(std::string_view key, const std::string& fallback);
    ElementId id(std::string_view key);
    template <int Dim>
    Eigen::Matrix<double, Dim, 1> vector(std::string_view key, const Eigen::Matrix<double, Dim, 1>& fallback);
    /// The index of a word in the list; the first one when the key is missing.
    int choice(std::string_view key, std::span<const char* const> words);

    void finish();

private:
    struct Member {
        std::string key;
        Value value;
        bool known = false;
    };

    std::string m_path;
    Report& m_report;
    std::vector<Member> m_members;
};

/// The items of a list of exactly Dim numbers within +-limit.
template <int Dim>
Eigen::Matrix<double, Dim, 1> vectorIn(const Value& value, const std::string& field, Report& report,
                                       double limit = std::numeric_limits<double>::max());

} // namespace bolster::json
