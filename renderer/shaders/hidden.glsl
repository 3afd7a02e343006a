// Whether what a frame has drawn so far hides a sphere.
layout(binding = IMAGE_UNIT) uniform sampler2D pyramid; // the farthest depth, which is the least

// Bounds of a sphere's picture along one axis: Mara and McGuire, "2D Polyhedral Bounds of a Clipped,
// Perspective-Projected 3D Sphere" (2013). `along` and `z` in m, z > radius.
vec2 projectedBounds(float along, float z, float radius)
{
    float t = sqrt(max(along * along + z * z - radius * radius, 0.0));
    float low = (along * t - z * radius) / (z * t + along * radius);
    float high = (along * t + z * radius) / (z * t - along * radius);
    return vec2(low, high);
}

// A sphere, m from the eye.
bool hidden(vec3 relative, float radius)
{
    float z = dot(relative, view.forward);
    if (z < radius + view.near * 2.0) return false;
    float halfWidth = length(view.right), halfHeight = length(view.up);
    vec2 x = projectedBounds(dot(relative, view.right) / halfWidth, z, radius) / halfWidth;
    vec2 y = projectedBounds(dot(relative, view.up) / halfHeight, z, radius) / halfHeight;
    if (x.y - x.x <= 0.0 || y.y - y.x <= 0.0) return false; // wider than half a turn
    vec2 low = clamp(vec2(x.x, y.x) * 0.5 + 0.5, 0.0, 1.0);
    vec2 high = clamp(vec2(x.y, y.y) * 0.5 + 0.5, 0.0, 1.0);
    ivec2 size = textureSize(pyramid, 0);
    vec2 extent = (high - low) * vec2(size);
    int mip = clamp(int(ceil(log2(max(max(extent.x, extent.y), 1.0)))), 0, textureQueryLevels(pyramid) - 1);
    ivec2 last = max(size >> mip, 1) - 1; // llvmpipe answers textureSize(pyramid, mip) for one thread's mip only
    ivec2 a = clamp(ivec2(low * vec2(last + 1)), ivec2(0), last);
    ivec2 b = clamp(ivec2(high * vec2(last + 1)), ivec2(0), last);
    float farthest = min(min(texelFetch(pyramid, a, mip).r, texelFetch(pyramid, b, mip).r),
                         min(texelFetch(pyramid, ivec2(a.x, b.y), mip).r, texelFetch(pyramid, ivec2(b.x, a.y), mip).r));
    return view.near / (z - radius) < farthest;
}
