// Drawings as tests write them.
#pragma once

#include "DrawingReaders.h"
#include "FoundPieces.h"

#include <gtest/gtest.h>

namespace bolster::test {

/// "0 LINE 8 cut 10 0": codes and values with a blank between them, values without blanks.
inline std::string dxfGroupsOf(const std::string& words)
{
    std::string text;
    bool code = true;
    std::string word;
    for (const char c : words + " ") {
        if (c != ' ') {
            word += c;
            continue;
        }
        if (word.empty())
            continue;
        text += (code ? "  " : "") + word + "\r\n";
        code = !code;
        word.clear();
    }
    return text;
}

inline Drawing drawn(const std::string& text, Drawing (*read)(const FileBytes&) = readDxf)
{
    return read(FileBytes(std::string_view(text)));
}

inline Drawing drawnSvg(const std::string& inside,
                        const std::string& root = "width=\"200mm\" height=\"100mm\" viewBox=\"0 0 200 100\"")
{
    return drawn("<svg xmlns=\"http://www.w3.org/2000/svg\" " + root + ">" + inside + "</svg>", readSvg);
}

/// Why a file is refused; "" when it is read.
inline FileRefused refusalOf(const std::string& text, Drawing (*read)(const FileBytes&) = readDxf)
{
    try {
        read(FileBytes(std::string_view(text)));
    } catch (const FileRefused& refused) {
        return refused;
    }
    return {};
}

inline Box2 boxOf(const Drawing& drawing)
{
    Box2 box;
    for (const DrawnPart& part : drawing.parts)
        for (const DrawnLine& line : part.lines)
            for (const DrawnPoint& point : line.points)
                box.extend(point.at);
    return box;
}

inline DrawnLine lineOf(const std::string& layer, const std::vector<Vec2>& points, bool closed = false)
{
    DrawnLine line;
    line.layer = layer;
    line.closed = closed;
    for (const Vec2& at : points)
        line.points.push_back({at});
    return line;
}

inline DrawnLine rectangleOf(const std::string& layer, const Vec2& from, const Vec2& size)
{
    return lineOf(layer, {from, from + Vec2(size.x(), 0), from + size, from + Vec2(0, size.y())}, true);
}

inline Drawing drawingWith(std::vector<DrawnLine> lines, std::vector<DrawnDot> dots = {})
{
    Drawing drawing;
    drawing.parts.push_back({"", std::move(lines), std::move(dots), {}});
    return drawing;
}

} // namespace bolster::test
