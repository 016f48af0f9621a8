// What style sheets and style attributes of SVG say of whether and where something is drawn. Private to the
// library.
#pragma once

#include "SvgTree.h"

#include <map>
#include <optional>
#include <string>

namespace bolster {

struct SvgStyle {
    std::optional<bool> displayed; ///< false: neither it nor what is in it
    std::optional<bool> visible;   ///< holds for what is in it, too, unless that says otherwise
    std::optional<std::string> transform;
    std::optional<std::string> origin; ///< of the transform

    bool empty() const { return !displayed && !visible && !transform && !origin; }
    /// Whatever the other one says counts.
    void take(const SvgStyle& other);
};

/// Of all style sheets in the file, wherever they are. Others are not opened.
class SvgStyles {
public:
    explicit SvgStyles(const SvgElement& root);

    /// Attributes, then rules of sheets, then the element's own style.
    SvgStyle of(const SvgElement& element) const;
    /// Rules that hide or move something, of elements that are named in ways beyond tag, class and id.
    int notUnderstood() const { return m_notUnderstood; }

private:
    struct Rule {
        SvgStyle style;
        int order = 0;
    };

    void find(const SvgElement& element);
    void readSheet(std::string sheet);
    void addRule(std::string_view selector, const SvgStyle& style);

    std::map<std::string, Rule, std::less<>> m_rules; ///< by "tag", ".class", "tag.class", "#id", "tag#id", "*"
    int m_order = 0;
    int m_notUnderstood = 0;
};

} // namespace bolster
