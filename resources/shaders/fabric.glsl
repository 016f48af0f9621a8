// The maps of a fabric. Comes after lit.glsl.
uniform bool textured;
uniform sampler2D colorMap;
uniform sampler2D reliefMap; // normal, roughness
uniform vec2 toTileX;        // from mm of the cloth to repeats of the tile
uniform vec2 toTileY;
uniform float plainRoughness;
uniform float sheen;

// The directions in which the tile's x and y, up, run on the surface, from how its coordinates change in the picture.
vec3 bent(vec3 n, vec3 position, vec2 tile, vec3 relief)
{
    vec3 px = dFdx(position), py = dFdy(position);
    vec2 tx = dFdx(tile), ty = dFdy(tile);
    vec3 across = cross(py, n), along = cross(n, px);
    vec3 x = across * tx.x + along * ty.x, y = across * tx.y + along * ty.y;
    float longest = max(dot(x, x), dot(y, y));
    if (!(longest > 0.0))
        return n;
    float scale = inversesqrt(longest) * sign(dot(cross(px, py), n));
    return normalize(scale * (relief.x * x - relief.y * y) + relief.z * n);
}

// What lies at a place of the cloth, mm; the plain colour where there are no maps. With relief the normal leans.
Cloth fabric(vec3 plain, vec2 place, vec3 position, bool relief, inout vec3 n)
{
    Cloth seen = Cloth(plain, plainRoughness, sheen, clothSpecular);
    if (!textured)
        return seen;
    vec2 tile = vec2(dot(toTileX, place), dot(toTileY, place));
    seen.color = texture(colorMap, tile).rgb;
    vec4 map = texture(reliefMap, tile);
    seen.roughness = map.a;
    if (relief) {
        vec3 slope = 2.0 * map.xyz - 1.0;
        float spread = 1.0 - min(1.0, dot(slope, slope)); // mip-maps mean over different normals
        seen.roughness = roughened(pow(map.a, 4.0), 0.5 * spread);
        n = bent(n, position, tile, slope);
    }
    return seen;
}
