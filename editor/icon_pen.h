// The pen that icons are drawn with: strokes and areas on a grid of 16 x 16, at any size.
#pragma once

#include <imgui.h>
#include <initializer_list>

namespace editor {

struct Pen {
    ImDrawList& draw;
    ImVec2 origin;
    float scale;
    ImU32 colour;

    float width() const { return 1.35f * scale; }
    ImVec2 at(float x, float y) const { return {origin.x + x * scale, origin.y + y * scale}; }
    void line(float x0, float y0, float x1, float y1) const { draw.AddLine(at(x0, y0), at(x1, y1), colour, width()); }
    void path(std::initializer_list<ImVec2> points, bool closed = false) const
    {
        for (const ImVec2& p : points)
            draw.PathLineTo(at(p.x, p.y));
        draw.PathStroke(colour, closed ? ImDrawFlags_Closed : ImDrawFlags_None, width());
    }
    void fill(std::initializer_list<ImVec2> points) const
    {
        for (const ImVec2& p : points)
            draw.PathLineTo(at(p.x, p.y));
        draw.PathFillConvex(colour);
    }
    void circle(float x, float y, float r) const { draw.AddCircle(at(x, y), r * scale, colour, 0, width()); }
    void disc(float x, float y, float r) const { draw.AddCircleFilled(at(x, y), r * scale, colour); }
    void box(float x0, float y0, float x1, float y1, float round = 1) const
    {
        draw.AddRect(at(x0, y0), at(x1, y1), colour, round * scale, 0, width());
    }
    void block(float x0, float y0, float x1, float y1, float round = 0) const
    {
        draw.AddRectFilled(at(x0, y0), at(x1, y1), colour, round * scale);
    }
    void arc(float x, float y, float r, float from, float to) const // degrees, clockwise from +x
    {
        constexpr float kRadians = 3.14159265f / 180;
        draw.PathArcTo(at(x, y), r * scale, from * kRadians, to * kRadians);
        draw.PathStroke(colour, 0, width());
    }
    void head(float x, float y, float dx, float dy,
              float size = 2.6f) const // an arrow's tip that points along (dx, dy)
    {
        const float bx = x - dx * size, by = y - dy * size, wing = size * 0.8f;
        fill({{x, y}, {bx - dy * wing, by + dx * wing}, {bx + dy * wing, by - dx * wing}});
    }
};

} // namespace editor
