#version 330 core
#include "studio.glsl"

uniform vec3 material; // linear
uniform int kind;      // as FrameMaterial::Kind: plain, wood, metal, plastic, foam
uniform float opacity; // where it faces the eye; its silhouette is denser
in vec3 eyePosition;
in vec3 eyeNormal;
in vec3 grainPlace; // mm, z along the grain
out vec4 color;

// How much darker wood is there: the same as in FrameLook.cpp.
float woodTone(vec3 at)
{
    float wave = 6.0 * sin(at.z / 180.0 + 0.7) + 2.5 * sin(at.z / 47.0 + at.x / 31.0);
    float ring = length(vec2(at.x + 55.0 + wave, 0.6 * at.y + 18.0 + 0.5 * wave)) / 7.0;
    float late = smoothstep(0.35, 0.95, fract(ring)) * (1.0 - smoothstep(0.95, 1.0, fract(ring)));
    float fibre = sin(2.1 * at.x + 3.0 * sin(at.z / 23.0)) * sin(2.6 * at.y + at.z / 17.0);
    float near = 1.0 - smoothstep(0.3, 0.8, fwidth(ring)); // rings closer than pixels are one tone
    return mix(0.12, 0.34 * late + 0.05 * fibre, near);
}

Cloth surfaceOf(vec3 at)
{
    if (kind == 1)
        return Cloth(material * (1.0 - woodTone(at)), 0.42, 0.0, 0.04);
    if (kind == 2)
        return Cloth(0.35 * material, 0.3, 0.0, 0.55);
    if (kind == 3)
        return Cloth(material, 0.36, 0.0, 0.04);
    if (kind == 4)
        return Cloth(material, 1.0, 0.25, 0.02);
    return Cloth(material, 0.5, 0.0, 0.04);
}

void main()
{
    vec3 toEye = towardsEye(eyePosition);
    vec3 n = normalize(eyeNormal);
    if (dot(n, toEye) < 0.0)
        n = -n;
    float silhouette = pow(1.0 - clamp(dot(n, toEye), 0.0, 1.0), 2.0);
    float alpha = mix(opacity, min(1.0, 1.35 * opacity), silhouette);
    vec3 shown = displayed(studio(surfaceOf(grainPlace), n, toEye, 1.0));
    color = vec4(shown * alpha, alpha);
}
