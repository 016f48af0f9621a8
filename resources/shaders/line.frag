#version 330 core
noperspective in vec2 local;
flat in float along;
flat in vec2 widths;
flat in vec4 tone;
out vec4 color;

void main()
{
    float away = length(vec2(local.x - clamp(local.x, 0.0, along), local.y));
    float whole = clamp(widths.y - away + 0.5, 0.0, 1.0) * min(1.0, 2.0 * widths.y);
    if (whole <= 0.0)
        discard;
    float core = clamp(widths.x - away + 0.5, 0.0, 1.0);
    vec3 shown = mix(0.25 * tone.rgb, tone.rgb, core); // the casing keeps it apart from any ground
    float alpha = tone.a * whole * mix(0.7, 1.0, core);
    color = vec4(shown * alpha, alpha);
}
