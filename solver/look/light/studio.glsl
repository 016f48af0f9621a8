// The light of a small photo studio: a bright room with a lamp above, a large soft box beside the camera, a strip of
// light behind the model; and how surfaces answer to it. OpenGL's shaders and C++ (Shading.h) read this same text, so
// numbers have their f, and of a vector only all of it is spoken of. Colours are linear; directions are unit.
#ifndef SHARED
#define SHARED
#endif

SHARED const vec3 keyColor = vec3(1.02f, 0.98f, 0.92f);
SHARED const vec3 skyColor = vec3(0.50f, 0.52f, 0.56f);
SHARED const vec3 floorColor = vec3(0.25f, 0.235f, 0.22f);
SHARED const vec3 rimColor = vec3(0.30f, 0.32f, 0.37f);
SHARED const vec3 lampColor = vec3(1.30f, 1.28f, 1.24f); // it shines in what is smooth
SHARED const float keySize = 0.14f; // what the soft box adds to a highlight's width (alpha of GGX)
SHARED const float rimSize = 0.12f;
// Where they stand: to the right of the camera, and upwards, radians.
SHARED const float keyAzimuth = 0.55f, keyElevation = 0.8f;
SHARED const float rimAzimuth = -2.2f, rimElevation = 0.5f;

// What a surface is like.
struct Cloth {
    vec3 color;
    float roughness; // perceptual; its square is GGX's alpha
    float sheen;     // of fibres, 0 to 1
    float specular;  // reflected straight on; 0.04 for leather and lacquer
};

// Where light comes from, and where is up.
struct Studio {
    vec3 key;
    vec3 rim;
    vec3 up;
};

// The light that a place sends to the eye, by where it comes from, so that shadows can be put in afterwards.
struct Shade {
    vec3 direct;  // from the key light
    vec3 ambient; // from all around
};

// Light from an area goes a little round the edge.
SHARED float wrapped(float cosine, float by)
{
    return max(0.0f, cosine + by) / ((1.0f + by) * (1.0f + by));
}

// GGX with the visibility term of B. Karis, "Real shading in Unreal Engine 4", 2013; `light` is what arrives, `nh` and
// `lh` are the cosines between the normal, or the light, and the direction halfway to the eye.
SHARED float glossy(float light, float nh, float lh, float alpha, float roughness)
{
    float a2 = alpha * alpha, d = nh * nh * (a2 - 1.0f) + 1.0f;
    return light * a2 / (d * d * max(0.1f, lh * lh) * (4.0f * roughness + 2.0f));
}

// The same course has area lights as wider lobes: `size` is what that adds to alpha.
SHARED float highlight(Cloth cloth, vec3 n, vec3 light, vec3 toEye, float size)
{
    vec3 h = normalize(vec3(light + toEye));
    float alpha = min(1.0f, cloth.roughness * cloth.roughness + size);
    return glossy(cloth.specular * max(0.0f, dot(n, light)), max(0.0f, dot(n, h)), max(0.0f, dot(light, h)), alpha,
                  cloth.roughness);
}

// The room as a rough mirror shows it that looks so far up: sky over floor, and the lamp.
SHARED vec3 roomSeen(float up, float roughness)
{
    float blur = 0.15f + 0.85f * roughness;
    return vec3(floorColor + smoothstep(-blur, blur, up) * (skyColor - floorColor) +
                smoothstep(0.6f - blur, 0.6f + blur, up) * lampColor);
}

// The share of it that GGX reflects (Karis' fit).
SHARED float reflected(float specular, float roughness, float facing)
{
    float x = 1.0f - roughness;
    float a = min(x * x, exp2(-9.28f * facing)) * x + (0.0425f - 0.0275f * roughness);
    return max(0.0f, specular * (-1.04f * a + (1.04f - 0.572f * roughness)) + 1.04f * a + (0.022f * roughness - 0.04f));
}

SHARED vec3 mirrored(Cloth cloth, vec3 n, vec3 toEye, vec3 up, float facing)
{
    if (!(cloth.specular > 0.0f))
        return vec3(0.0f, 0.0f, 0.0f);
    float seen = 2.0f * dot(n, toEye) * dot(n, up) - dot(toEye, up);
    return vec3(roomSeen(seen, cloth.roughness) * reflected(cloth.specular, cloth.roughness, facing));
}

// What fibres scatter where they are seen from the side.
SHARED vec3 fuzzOf(Cloth cloth, float facing)
{
    return vec3(cloth.sheen * pow(1.0f - facing, 3.0f) * (0.75f * cloth.color + 0.25f));
}

SHARED vec3 skyLight(float up)
{
    return vec3(floorColor + (0.5f + 0.5f * up) * (skyColor - floorColor));
}

SHARED Shade shaded(Cloth cloth, vec3 n, vec3 toEye, Studio studio)
{
    float facing = clamp(dot(n, toEye), 0.03f, 1.0f);
    float key = dot(n, studio.key), rim = dot(n, studio.rim);
    vec3 fuzz = fuzzOf(cloth, facing);
    Shade shade;
    shade.direct = (cloth.color * wrapped(key, 0.15f) + fuzz * wrapped(key, 0.5f) +
                    highlight(cloth, n, studio.key, toEye, keySize)) *
                   keyColor;
    shade.ambient = (cloth.color + fuzz) * skyLight(dot(n, studio.up)) +
                    mirrored(cloth, n, toEye, studio.up, facing) +
                    (cloth.color * wrapped(rim, 0.1f) + fuzz * wrapped(rim, 0.5f) +
                     6.0f * highlight(cloth, n, studio.rim, toEye, rimSize)) *
                        rimColor;
    return shade;
}

// The lining of a cover: its colour, but greyed.
SHARED Cloth lining(vec3 color)
{
    float grey = dot(color, vec3(0.2126f, 0.7152f, 0.0722f));
    Cloth seen;
    seen.color = 0.25f * color + (0.12f + 0.35f * grey);
    seen.roughness = 0.9f;
    seen.sheen = 0.0f;
    seen.specular = 0.02f;
    return seen;
}

// How dark it is in the valley of a seam, 1 at the bottom: the thread pulls the cover in, and little light gets there.
SHARED Cloth inValley(Cloth cloth, float dark)
{
    cloth.color = cloth.color * (1.0f - 0.72f * dark);
    cloth.sheen = cloth.sheen * (1.0f - dark);
    cloth.specular = cloth.specular * (1.0f - dark);
    return cloth;
}

// Means over a pixel lose how different the normals in it are: that is rough, too. `alpha2` is GGX's, squared.
SHARED float roughened(float alpha2, float spread)
{
    return pow(clamp(alpha2 + spread, 0.0f, 1.0f), 0.25f);
}

// Mean of a square wave of period 2 (+1 on [0, 1), -1 on [1, 2)) over a window of this width.
SHARED float squareWave(float at, float width)
{
    width = max(width, 1e-4f);
    float to = at + width / 2.0f, from = at - width / 2.0f;
    float there = 1.0f - abs(to - 2.0f * floor(to / 2.0f) - 1.0f);
    float here = 1.0f - abs(from - 2.0f * floor(from / 2.0f) - 1.0f);
    return width > 8.0f ? 0.0f : (there - here) / width;
}

SHARED const float screenShoulder = 0.75f; // of pictures: above it, light is bent

// What is too bright for a screen is bent from `shoulder` on, so that highlights keep their shape.
SHARED float toned(float light, float shoulder)
{
    float over = (light - shoulder) / (1.0f - shoulder);
    return over < 0.0f ? light : shoulder + (1.0f - shoulder) * (1.0f - exp(-over));
}

// sRGB's curve (IEC 61966-2-1); 0 to 1.
SHARED float encoded(float light)
{
    return light <= 0.0031308f ? 12.92f * light : 1.055f * pow(light, 1.0f / 2.4f) - 0.055f;
}
