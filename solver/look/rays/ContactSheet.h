// Several pictures on one, with their names.
#pragma once

#include "PreviewRenderer.h"

#include <span>

namespace bolster {

struct SheetPicture {
    PreviewImage image; ///< all of the same size, with light or without
    std::string name;   ///< UTF-8
};

/// Columns and rows for so many pictures, as square as can be.
std::array<int, 2> sheetGrid(std::size_t pictures);
/// Pixels below each picture for its name, by the picture's size.
int sheetCaption(int width, int height);

/// Row by row, the name below each picture, in grey that can be read on white and on black. `problem` says when
/// there is no font; the pictures are there nevertheless.
PreviewImage contactSheet(std::span<const SheetPicture> pictures, bool transparent, std::string& problem);

} // namespace bolster
