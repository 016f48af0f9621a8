#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 place; // in the fabric, mm
uniform mat4 view;
uniform vec4 section; // what lies beyond normal . p = w is cut away
uniform mat4 projection;
out vec3 eyePosition;
out vec3 eyeNormal;
out vec2 cloth;
out float gl_ClipDistance[1];

void main()
{
    gl_ClipDistance[0] = section.w - dot(section.xyz, position);
    vec4 p = view * vec4(position, 1.0);
    eyePosition = p.xyz;
    eyeNormal = mat3(view) * normal;
    cloth = place;
    gl_Position = projection * p;
}
