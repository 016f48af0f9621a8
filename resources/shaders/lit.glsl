// Studio light on what OpenGL draws. Directions are in eye coordinates.
float hypot(float x, float y)
{
    return length(vec2(x, y));
}

#include "studio.glsl"
#include "materials.glsl"

uniform vec3 keyDirection;
uniform vec3 rimDirection;
uniform vec3 upDirection;
uniform bool perspectiveView;

vec3 towardsEye(vec3 position)
{
    return perspectiveView ? normalize(-position) : vec3(0.0, 0.0, 1.0);
}

// `open`: the share of the sky that is seen.
vec3 studio(Cloth cloth, vec3 n, vec3 toEye, float open)
{
    Shade shade = shaded(cloth, n, toEye, Studio(keyDirection, rimDirection, upDirection));
    return shade.direct * (0.4 + 0.6 * smoothstep(0.0, 0.7, open)) + shade.ambient * open;
}

vec3 displayed(vec3 light)
{
    return vec3(encoded(toned(light.r, screenShoulder)), encoded(toned(light.g, screenShoulder)),
                encoded(toned(light.b, screenShoulder)));
}
