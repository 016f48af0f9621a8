#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 fill;
layout(location = 2) in vec4 rim;
layout(location = 3) in vec2 style; // radius in pixels, share of the opacity where hidden
uniform mat4 view;
uniform mat4 projection;
uniform vec2 viewport;
uniform float pixelAtOne;
uniform bool perspectiveView;
uniform float pixelRatio; // pixels of the picture per pixel in which widths are given
uniform float lift;
uniform bool hiddenPart;
noperspective out vec2 local;
flat out float radius;
flat out vec4 fillColor;
flat out vec4 rimColor;

void main()
{
    vec3 p = (view * vec4(position, 1.0)).xyz;
    if (perspectiveView && p.z > -1.0) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    float pixel = pixelAtOne * (perspectiveView ? -p.z : 1.0);
    vec3 toEye = perspectiveView ? normalize(-p) : vec3(0.0, 0.0, 1.0);
    vec4 clip = projection * vec4(p + (lift * pixel + 0.4) * toEye, 1.0);
    radius = pixelRatio * style.x;
    local = (vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1)) * (radius + 1.5);
    float opacity = hiddenPart ? style.y : 1.0;
    fillColor = vec4(fill.rgb, fill.a * opacity);
    rimColor = vec4(rim.rgb, rim.a * opacity);
    gl_Position = vec4(clip.xy + local / (0.5 * viewport) * clip.w, clip.z, clip.w);
}
