#version 330 core
uniform mat4 viewProjection;
uniform vec2 center;
uniform float reach;
uniform float height;
out vec2 ground; // mm

void main()
{
    vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1);
    ground = center + reach * corner;
    gl_Position = viewProjection * vec4(ground, height, 1.0);
}
