#version 330 core
#include "lit.glsl"
#include "fabric.glsl"
#include "seams.glsl"

uniform vec3 lightTone; // of the checker, linear
uniform vec3 darkTone;
uniform float square;   // mm; 0: no checker
uniform bool quick;     // something moves: without the fabric's relief
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

// How dark it is in the valley of a seam, and how the normal leans there: SeamProfile of SeamRelief.h.
float pressed(vec3 even, inout vec3 n)
{
    vec3 dx = dFdx(seamDistances), dy = dFdy(seamDistances);
    float nearest = min(seamDistances.x, min(seamDistances.y, seamDistances.z));
    vec3 first = vec3(lessThanEqual(seamDistances, vec3(nearest)));
    first /= dot(first, vec3(1.0));
    float pixel = dot(first, max(abs(dx), abs(dy)));

    Valley valley = valleyAt(nearest, seamShape.y, pixel);
    vec3 slope = first * valley.rise;
    if (seamShape.x > 0.0) {
        float width = bulgeWidth(seamShape.x, pixel);
        Flat a = flatAt(seamDistances.x, width), b = flatAt(seamDistances.y, width), c = flatAt(seamDistances.z, width);
        slope -= bulgeTop(seamShape.x, width) *
                 vec3(a.rise * b.share * c.share, b.rise * c.share * a.share, c.rise * a.share * b.share);
    }
    // The surface gradient (M. Mikkelsen, "Bump mapping unparametrized surfaces on the GPU", 2010).
    vec3 px = dFdx(eyePosition), py = dFdy(eyePosition);
    float area = dot(even, cross(px, py));
    if (area != 0.0)
        n = normalize(n - (dot(slope, dx) * cross(py, even) + dot(slope, dy) * cross(even, px)) / area);
    return valley.dark;
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
