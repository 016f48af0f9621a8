#version 330 core
// One segment as a rectangle in the picture, wide enough for soft edges and round ends.
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 lineColor;
layout(location = 3) in vec3 style; // width in pixels, share of the opacity where hidden, width of the casing
uniform mat4 view;
uniform mat4 projection;
uniform vec2 viewport;    // pixels
uniform float pixelAtOne; // mm per pixel at depth 1, or everywhere without perspective
uniform bool perspectiveView;
uniform float pixelRatio; // pixels of the picture per pixel in which widths are given
uniform float lift;       // towards the eye, pixels
uniform bool hiddenPart;
uniform bool casingPart; // the dark borders of all lines come first, so that none lies on another line
noperspective out vec2 local; // along and across the segment, pixels
flat out float along;
flat out float halfWidth;
flat out vec4 tone;

vec3 lifted(vec3 p)
{
    float pixel = pixelAtOne * (perspectiveView ? max(-p.z, 1.0) : 1.0);
    vec3 toEye = perspectiveView ? normalize(-p) : vec3(0.0, 0.0, 1.0);
    return p + (lift * pixel + 0.4) * toEye;
}

void main()
{
    vec3 a = (view * vec4(from, 1.0)).xyz, b = (view * vec4(to, 1.0)).xyz;
    float near = perspectiveView ? -1.0 : 1e9;
    if ((a.z > near && b.z > near) || (hiddenPart && style.y <= 0.0) || (casingPart && style.z <= 0.0)) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside
        return;
    }
    if (a.z > near)
        a = mix(a, b, (near - a.z) / (b.z - a.z));
    if (b.z > near)
        b = mix(b, a, (near - b.z) / (a.z - b.z));
    vec4 clipA = projection * vec4(lifted(a), 1.0), clipB = projection * vec4(lifted(b), 1.0);
    vec2 pixelA = 0.5 * viewport * clipA.xy / clipA.w, pixelB = 0.5 * viewport * clipB.xy / clipB.w;
    along = length(pixelB - pixelA);
    vec2 forward = along > 1e-4 ? (pixelB - pixelA) / along : vec2(1.0, 0.0);
    vec2 aside = vec2(-forward.y, forward.x);

    bool atEnd = (gl_VertexID & 1) == 1;
    float across = (gl_VertexID >> 1) == 1 ? 1.0 : -1.0;
    halfWidth = pixelRatio * (0.5 * style.x + (casingPart ? style.z : 0.0));
    float reach = halfWidth + 1.0;
    float cap = hiddenPart ? 0.0 : reach; // see-through segments must not overlap
    local = vec2(atEnd ? along + cap : -cap, across * reach);
    tone = vec4((casingPart ? 0.25 : 1.0) * lineColor.rgb, lineColor.a * (hiddenPart ? style.y : 1.0));
    vec4 clip = atEnd ? clipB : clipA;
    vec2 moved = (atEnd ? pixelB : pixelA) + (atEnd ? cap : -cap) * forward + across * reach * aside;
    gl_Position = vec4(moved / (0.5 * viewport) * clip.w, clip.z, clip.w);
}
