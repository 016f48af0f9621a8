// The keys of all tools that draw a line point by point.
#pragma once

#include "ToolKey.h"

#include <QCoreApplication>

#include <vector>

namespace bolster {

inline bool isEnterKey(int key)
{
    return key == Qt::Key_Return || key == Qt::Key_Enter;
}

/// A number begins. Tools that take typed numbers keep it even where it means nothing yet: elsewhere it turns the
/// camera.
inline bool isDigitKey(int key)
{
    return key >= Qt::Key_0 && key <= Qt::Key_9;
}

/// Enter ends the line, Backspace takes back a point, B switches between straight and smooth.
inline bool isDrawingKey(int key, bool canBeSmooth)
{
    return isEnterKey(key) || key == Qt::Key_Backspace || (key == Qt::Key_B && canBeSmooth);
}

/// What they do with a line that has been begun.
class DrawingKeys {
    Q_DECLARE_TR_FUNCTIONS(DrawingKeys)

public:
    static ToolKeys ofLine(bool canBeSmooth)
    {
        ToolKeys keys{{Qt::Key_Return, tr("&Finish")}, {Qt::Key_Backspace, tr("&Take back the last point")}};
        if (canBeSmooth)
            keys.append({Qt::Key_B, tr("Switch between &straight and smooth")});
        keys.append({Qt::Key_Escape, tr("&Give up")});
        return keys;
    }
};

/// Does what the key means; false when it is none of these. Lines that are always straight have no `smooth`.
template <class Point, class Finish>
bool pressDrawingKey(int key, std::vector<Point>& points, bool* smooth, Finish finish)
{
    if (!isDrawingKey(key, smooth))
        return false;
    if (key == Qt::Key_B)
        *smooth = !*smooth;
    else if (key != Qt::Key_Backspace)
        finish();
    else if (!points.empty())
        points.pop_back();
    return true;
}

} // namespace bolster
