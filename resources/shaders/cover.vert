#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 pattern;  // outline coordinates, mm
layout(location = 3) in vec2 openness; // of the outside and of the inside
layout(location = 4) in vec4 mapColor; // as displayed; alpha 0: none
layout(location = 5) in vec3 distances; // from the nearest seam of each track, mm
layout(location = 6) in vec2 shape;     // of the nearest seam: allowance in mm, 1 with a valley
uniform mat4 view;
uniform vec4 section; // what lies beyond normal . p = w is cut away
uniform mat4 projection;
out vec3 eyePosition;
out vec3 eyeNormal;
out vec2 cloth;
out vec2 open;
out vec4 map;
out vec3 seamDistances;
out vec2 seamShape;
out float gl_ClipDistance[1];

void main()
{
    gl_ClipDistance[0] = section.w - dot(section.xyz, position);
    vec4 p = view * vec4(position, 1.0);
    eyePosition = p.xyz;
    eyeNormal = mat3(view) * normal;
    cloth = pattern;
    open = openness;
    map = mapColor;
    seamDistances = distances;
    seamShape = shape;
    gl_Position = projection * p;
}
