// What covers and frames are made of. Comes after studio.glsl, and is read by C++, too.

SHARED const float clothSpecular = 0.04f;
SHARED const float bareRoughness = 0.62f, bareSheen = 0.12f; // of a cover whose fabric has no maps
SHARED const float trimRoughness = 0.6f;                     // of threads and piping
SHARED const float mapGamma = 2.2f;                          // maps of strain ... as light

// The squares of a checker in a fabric's colour.
SHARED vec3 lightSquare(vec3 color)
{
    return min(vec3(1.6f * color + 0.03f), vec3(1.0f, 1.0f, 1.0f));
}

SHARED vec3 darkSquare(vec3 color)
{
    return 0.85f * color;
}

// Rings around a wavy axis beside the piece: how many there are up to a place of its grain, mm.
SHARED float woodRings(float x, float y, float z)
{
    float wave = 6.0f * sin(z / 180.0f + 0.7f) + 2.5f * sin(z / 47.0f + x / 31.0f);
    return hypot(x + 55.0f + wave, 0.6f * y + 18.0f + 0.5f * wave) / 7.0f;
}

// How much darker wood is there; late wood ends sharply.
SHARED float woodTone(float rings, float x, float y, float z)
{
    float share = fract(rings);
    float late = smoothstep(0.35f, 0.95f, share) * (1.0f - smoothstep(0.95f, 1.0f, share));
    float fibre = sin(2.1f * x + 3.0f * sin(z / 23.0f)) * sin(2.6f * y + z / 17.0f);
    return 0.34f * late + 0.05f * fibre;
}

// `kind` as FrameMaterial::Kind: plain, wood, metal, plastic, foam. `dark` is the wood's tone.
SHARED Cloth frameSurface(int kind, vec3 color, float dark)
{
    Cloth seen;
    seen.color = color;
    seen.roughness = 0.5f;
    seen.sheen = 0.0f;
    seen.specular = clothSpecular;
    if (kind == 1) {
        seen.color = color * (1.0f - dark);
        seen.roughness = 0.42f;
    } else if (kind == 2) {
        seen.color = color * 0.35f;
        seen.roughness = 0.3f;
        seen.specular = 0.55f;
    } else if (kind == 3) {
        seen.roughness = 0.36f;
    } else if (kind == 4) {
        seen.roughness = 1.0f;
        seen.sheen = 0.25f;
        seen.specular = 0.02f;
    }
    return seen;
}
