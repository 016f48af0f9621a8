#version 330 core
#include "studio.glsl"

uniform vec3 lightTone; // of the checker, linear
uniform vec3 darkTone;
uniform float square;   // mm; 0: no checker
uniform vec4 tint;      // what the pointer or the selection adds, as displayed
uniform vec4 veil;      // over everything that is not up to date
in vec3 eyePosition;
in vec3 eyeNormal;
in vec3 worldNormal;
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

vec3 clothColor()
{
    if (square <= 0.0)
        return darkTone;
    vec2 at = cloth.xy / square;
    vec2 width = fwidth(at);
    return mix(darkTone, lightTone, 0.5 + 0.5 * wave(at.x, width.x) * wave(at.y, width.y));
}

void main()
{
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 n = normalize(side * eyeNormal);
    vec3 base = mix(clothColor(), pow(map.rgb, vec3(2.2)), map.a);
    float gloss = 0.09;
    if (gl_FrontFacing) {
        float valley = 1.0 - clamp(cloth.z / 0.45, 0.0, 1.0);
        base *= 1.0 - 0.35 * valley * valley;
    } else { // the lining: the cover's colour, but greyed
        base = 0.25 * base + 0.12 + 0.35 * dot(base, vec3(0.2126, 0.7152, 0.0722));
        gloss = 0.0;
    }
    float openness = gl_FrontFacing ? open.x : open.y;
    vec3 shown = displayed(studio(base, n, side * normalize(worldNormal).z, towardsEye(eyePosition), gloss, openness));
    shown = mix(shown, tint.rgb, tint.a);
    color = vec4(mix(shown, veil.rgb, veil.a), 1.0);
}
