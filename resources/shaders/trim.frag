#version 330 core
#include "lit.glsl"
#include "fabric.glsl"

uniform vec3 material; // of thread and of plain fabric, linear
uniform bool quick;    // something moves: without the fabric's relief
in vec3 eyePosition;
in vec3 eyeNormal;
in vec2 cloth;
out vec4 color;

void main()
{
    vec3 toEye = towardsEye(eyePosition);
    vec3 n = normalize(eyeNormal);
    Cloth seen = fabric(material, cloth, eyePosition, !quick, n);
    color = vec4(displayed(studio(seen, n, toEye, 1.0)), 1.0);
}
