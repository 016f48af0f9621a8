// Pictures whose borders fit together.
#pragma once

#include <OpenImageIO/imagebuf.h>

namespace bolster {

/// Takes the jump out of the borders, so that the picture can be laid side by side: what is taken is smooth inside,
/// and next to nothing where the borders fit already. It is s of L. Moisan, "Periodic plus smooth image
/// decomposition" (2011): Laplace(s) = the jumps, on a torus. Float pixels, in memory.
void makeSeamless(OIIO::ImageBuf& image);

} // namespace bolster
