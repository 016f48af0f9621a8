#version 330 core
#include "lit.glsl"
#include "fabric.glsl"

uniform vec3 lightTone; // of the checker, linear
uniform vec3 darkTone;
uniform float square;   // mm; 0: no checker
uniform bool quick;     // something moves: without the fabric's relief
uniform vec4 seamProfile; // valley's depth and reach, bulge's height, mm, and its reach in allowances: see SeamRelief.h
uniform vec4 tint;      // what the pointer or the selection adds, as displayed
uniform vec4 veil;      // over everything that is not up to date
in vec3 eyePosition;
in vec3 eyeNormal;
in vec2 cloth;
in vec2 open;
in vec4 map;
in vec3 seamDistances;
in vec2 seamShape;
out vec4 color;

vec3 checker()
{
    vec2 at = cloth / square;
    vec2 width = fwidth(at);
    return mix(darkTone, lightTone, 0.5 + 0.5 * squareWave(at.x, width.x) * squareWave(at.y, width.y));
}

// How dark it is in the valley of a seam, and how the normal leans there: SeamProfile of SeamRelief.h. What is
// narrower than a pixel is drawn wider and fainter.
float pressed(vec3 even, inout vec3 n)
{
    vec3 dx = dFdx(seamDistances), dy = dFdy(seamDistances);
    float nearest = min(seamDistances.x, min(seamDistances.y, seamDistances.z));
    vec3 first = vec3(lessThanEqual(seamDistances, vec3(nearest)));
    first /= dot(first, vec3(1.0));
    float pixel = dot(first, max(abs(dx), abs(dy)));

    float reach = length(vec2(seamProfile.y, pixel));
    float inside = max(0.0, 1.0 - nearest / reach), amount = seamShape.y * seamProfile.y / reach;
    vec3 slope = first * (2.0 * seamProfile.x * amount * inside / reach);
    if (seamShape.x > 0.0) {
        float allowance = seamProfile.w * seamShape.x, width = length(vec2(allowance, pixel));
        float high = seamProfile.z * min(1.0, seamShape.x) * allowance / width;
        vec3 at = min(seamDistances / width, 1.0), left = 1.0 - at * at;
        vec3 without = 1.0 - left * left * left, fall = -6.0 * at * left * left / width;
        slope += high * fall * vec3(without.y * without.z, without.x * without.z, without.x * without.y);
    }
    // The surface gradient (M. Mikkelsen, "Bump mapping unparametrized surfaces on the GPU", 2010).
    vec3 px = dFdx(eyePosition), py = dFdy(eyePosition);
    float area = dot(even, cross(px, py));
    if (area != 0.0)
        n = normalize(n - (dot(slope, dx) * cross(py, even) + dot(slope, dy) * cross(even, px)) / area);
    return amount * inside * inside;
}

void main()
{
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 even = normalize(side * eyeNormal), n = even;
    Cloth seen = fabric(square > 0.0 ? checker() : darkTone, cloth, eyePosition, !quick && gl_FrontFacing, n);
    seen.color = mix(seen.color, pow(map.rgb, vec3(mapGamma)), map.a);
    if (gl_FrontFacing)
        seen = inValley(seen, pressed(even, n));
    else
        seen = lining(seen.color);
    vec3 shown = displayed(studio(seen, n, towardsEye(eyePosition), gl_FrontFacing ? open.x : open.y));
    shown = mix(shown, tint.rgb, tint.a);
    color = vec4(mix(shown, veil.rgb, veil.a), 1.0);
}
