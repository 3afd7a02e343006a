// One level of the depth pyramid: each texel holds the least depth, which is the farthest, of all that it covers of the
// level below, at any ratio of their sizes. A texel that covers three of them reads three.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, r32f) writeonly uniform image2D coarse;
layout(binding = 10) uniform sampler2D fine;
layout(location = 0) uniform ivec3 level; // size of the coarse one, mip of the fine one

void main()
{
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, level.xy))) return;
    ivec2 size = textureSize(fine, level.z);
    ivec2 low = texel * size / level.xy;
    ivec2 high = min(((texel + 1) * size + level.xy - 1) / level.xy, size);
    float farthest = 1.0;
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x)
            farthest = min(farthest, texelFetch(fine, ivec2(x, y), level.z).r);
    imageStore(coarse, texel, vec4(farthest));
}
