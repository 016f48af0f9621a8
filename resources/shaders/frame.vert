#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 grain;
uniform mat4 moved; // to where the frame is now
uniform mat4 view;
uniform vec4 section; // what lies beyond normal . p = w is cut away
uniform mat4 projection;
uniform bool perspectiveView;
uniform float push; // mm away from the eye
out vec3 eyePosition;
out vec3 eyeNormal;
out vec3 grainPlace;
out float gl_ClipDistance[1];

void main()
{
    vec4 placed = moved * vec4(position, 1.0);
    gl_ClipDistance[0] = section.w - dot(section.xyz, placed.xyz);
    vec4 p = view * placed;
    eyePosition = p.xyz;
    eyeNormal = mat3(view) * mat3(moved) * normal;
    grainPlace = grain;
    p.xyz -= push * (perspectiveView ? normalize(-p.xyz) : vec3(0.0, 0.0, 1.0));
    gl_Position = projection * p;
}
