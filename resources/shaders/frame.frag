#version 330 core
#include "lit.glsl"

uniform vec3 material; // linear
uniform int kind;      // as FrameMaterial::Kind: plain, wood, metal, plastic, foam
uniform float opacity; // where it faces the eye; its silhouette is denser
in vec3 eyePosition;
in vec3 eyeNormal;
in vec3 grainPlace; // mm, z along the grain
out vec4 color;

// Rings closer than pixels are one tone.
float woodTone(vec3 at)
{
    float rings = woodRings(at.x, at.y, at.z);
    return mix(0.12, woodTone(rings, at.x, at.y, at.z), 1.0 - smoothstep(0.3, 0.8, fwidth(rings)));
}

void main()
{
    vec3 toEye = towardsEye(eyePosition);
    vec3 n = normalize(eyeNormal);
    if (dot(n, toEye) < 0.0)
        n = -n;
    float silhouette = pow(1.0 - clamp(dot(n, toEye), 0.0, 1.0), 2.0);
    float alpha = mix(opacity, min(1.0, 1.35 * opacity), silhouette);
    vec3 shown = displayed(studio(frameSurface(kind, material, woodTone(grainPlace)), n, toEye, 1.0));
    color = vec4(shown * alpha, alpha);
}
