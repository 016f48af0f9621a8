#version 330 core
#include "studio.glsl"

uniform vec3 material; // linear
uniform float opacity; // where it faces the eye; its silhouette is denser
in vec3 eyePosition;
in vec3 eyeNormal;
out vec4 color;

void main()
{
    vec3 toEye = towardsEye(eyePosition);
    vec3 n = normalize(eyeNormal);
    if (dot(n, toEye) < 0.0)
        n = -n;
    float silhouette = pow(1.0 - clamp(dot(n, toEye), 0.0, 1.0), 2.0);
    float alpha = mix(opacity, min(1.0, opacity + 0.35), silhouette);
    vec3 shown = displayed(studio(Cloth(material, 0.45, 0.0, 0.04), n, toEye, 1.0));
    color = vec4(shown * alpha, alpha);
}
