#version 330 core
// A floor without colour: only shadow and a fine grid.
uniform vec2 center;
uniform float reach;
uniform sampler2D openness;
uniform vec2 shadowCorner;
uniform float shadowSide; // 0: none
uniform vec4 gridColor;
uniform float shadowStrength;
in vec2 ground;
out vec4 color;

float lines(float spacing)
{
    vec2 at = ground / spacing;
    vec2 width = max(fwidth(at), vec2(1e-6));
    vec2 away = abs(fract(at - 0.5) - 0.5) / width;
    vec2 line = clamp(1.0 - away, 0.0, 1.0) * clamp(0.25 / width, 0.0, 1.0); // lines closer than 4 pixels fade
    return max(line.x, line.y);
}

void main()
{
    float fade = 1.0 - smoothstep(0.35, 1.0, length(ground - center) / reach);
    float grid = max(0.45 * lines(100.0), lines(500.0)) * fade * gridColor.a;
    float shadow = 0.0;
    if (shadowSide > 0.0) {
        vec2 at = (ground - shadowCorner) / shadowSide;
        vec2 border = smoothstep(vec2(0.0), vec2(0.12), at) * smoothstep(vec2(0.0), vec2(0.12), 1.0 - at);
        shadow = shadowStrength * (1.0 - texture(openness, at).r) * border.x * border.y;
    }
    float alpha = shadow + grid * (1.0 - shadow);
    color = vec4(gridColor.rgb * grid * (1.0 - shadow), alpha); // premultiplied; the shadow is black
}
