#version 330 core
#include "studio.glsl"

uniform vec3 lightTone; // of the checker, linear
uniform vec3 darkTone;
uniform float square;   // mm; 0: no checker
uniform bool textured;  // by the maps of a fabric
uniform sampler2D colorMap;
uniform sampler2D reliefMap; // normal, roughness
uniform vec2 toTileX;        // from mm of the pattern to repeats of the tile
uniform vec2 toTileY;
uniform float plainRoughness;
uniform float sheen;
uniform bool quick;     // something moves: without relief
uniform vec4 tint;      // what the pointer or the selection adds, as displayed
uniform vec4 veil;      // over everything that is not up to date
in vec3 eyePosition;
in vec3 eyeNormal;
in vec3 cloth;
in vec2 open;
in vec4 map;
out vec4 color;

// Mean of a square wave of period 2 over a window of this width.
float wave(float at, float width)
{
    width = max(width, 1e-4);
    vec2 ends = at + vec2(-0.5, 0.5) * width;
    vec2 integral = 1.0 - abs(ends - 2.0 * floor(ends / 2.0) - 1.0);
    return width > 8.0 ? 0.0 : (integral.y - integral.x) / width;
}

vec3 checker()
{
    vec2 at = cloth.xy / square;
    vec2 width = fwidth(at);
    return mix(darkTone, lightTone, 0.5 + 0.5 * wave(at.x, width.x) * wave(at.y, width.y));
}

// The directions in which the tile's x and y, up, run on the surface, from how its coordinates change in the picture.
vec3 bent(vec3 n, vec2 tile, vec3 relief)
{
    vec3 px = dFdx(eyePosition), py = dFdy(eyePosition);
    vec2 tx = dFdx(tile), ty = dFdy(tile);
    vec3 across = cross(py, n), along = cross(n, px);
    vec3 x = across * tx.x + along * ty.x, y = across * tx.y + along * ty.y;
    float longest = max(dot(x, x), dot(y, y));
    if (!(longest > 0.0))
        return n;
    float scale = inversesqrt(longest) * sign(dot(cross(px, py), n));
    return normalize(scale * (relief.x * x - relief.y * y) + relief.z * n);
}

void main()
{
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 n = normalize(side * eyeNormal);
    Cloth seen = Cloth(square > 0.0 ? checker() : darkTone, plainRoughness, sheen, 0.04);
    if (textured) {
        vec2 tile = vec2(dot(toTileX, cloth.xy), dot(toTileY, cloth.xy));
        seen.color = texture(colorMap, tile).rgb;
        vec4 relief = texture(reliefMap, tile);
        seen.roughness = relief.a;
        if (!quick && gl_FrontFacing) {
            vec3 slope = 2.0 * relief.xyz - 1.0;
            float spread = 1.0 - min(1.0, dot(slope, slope)); // mip-maps mean over different normals
            seen.roughness = pow(clamp(pow(relief.a, 4.0) + 0.5 * spread, 0.0, 1.0), 0.25);
            n = bent(n, tile, slope);
        }
    }
    seen.color = mix(seen.color, pow(map.rgb, vec3(2.2)), map.a);
    if (gl_FrontFacing) {
        float valley = 1.0 - clamp(cloth.z / 0.45, 0.0, 1.0);
        seen.color *= 1.0 - 0.35 * valley * valley;
    } else { // the lining: the cover's colour, but greyed
        float grey = dot(seen.color, vec3(0.2126, 0.7152, 0.0722));
        seen = Cloth(0.25 * seen.color + 0.12 + 0.35 * grey, 0.9, 0.0, 0.02);
    }
    vec3 shown = displayed(studio(seen, n, towardsEye(eyePosition), gl_FrontFacing ? open.x : open.y));
    shown = mix(shown, tint.rgb, tint.a);
    color = vec4(mix(shown, veil.rgb, veil.a), 1.0);
}
