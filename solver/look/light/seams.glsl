// The cross section of a seam: a valley where the thread pulls the cover in, and beside it the soft bulge of the
// allowances that lie under the cover. Lengths in mm. What is narrower than a pixel, here how much a distance changes
// from one to the next, is drawn wider and fainter. Comes after studio.glsl, and is read by C++, too.

SHARED const float valleyDepth = 0.8f, valleyReach = 1.5f; // to each side
SHARED const float bulgeHeight = 0.6f, bulgeReach = 1.3f;  // the reach in allowances: it ends softly

struct Valley {
    float dark; // 1 at the bottom, 0 outside
    float rise; // of the height over the distance
};

// `amount`: 1 where the seam has a valley, else 0.
SHARED Valley valleyAt(float distance, float amount, float pixel)
{
    float reach = hypot(valleyReach, pixel), inside = max(0.0f, 1.0f - distance / reach);
    float fainter = amount * valleyReach / reach;
    Valley seen;
    seen.dark = fainter * inside * inside;
    seen.rise = 2.0f * valleyDepth * fainter * inside / reach;
    return seen;
}

SHARED float bulgeWidth(float allowance, float pixel)
{
    return hypot(bulgeReach * allowance, pixel);
}

SHARED float bulgeTop(float allowance, float width)
{
    return bulgeHeight * min(1.0f, allowance) * bulgeReach * allowance / width;
}

// How little of a bulge there is at a distance, 0 on the seam, 1 outside; bulges that overlap multiply theirs.
struct Flat {
    float share;
    float rise; // of the share over the distance
};

SHARED Flat flatAt(float distance, float width)
{
    float at = min(distance / width, 1.0f), left = 1.0f - at * at;
    Flat seen;
    seen.share = 1.0f - left * left * left;
    seen.rise = 6.0f * at * left * left / width;
    return seen;
}
