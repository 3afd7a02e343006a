#include "editor/icons.h"

#include "editor/icon_pen.h"

#include <cmath>

namespace editor {
namespace {

void speaker(const Pen& p)
{
    p.path({{1.8f, 6}, {4.6f, 6}, {8.2f, 2.8f}, {8.2f, 13.2f}, {4.6f, 10}, {1.8f, 10}}, true);
    p.arc(8, 8, 3.4f, -45, 45);
    p.arc(8, 8, 6.2f, -45, 45);
}

void pad(const Pen& p)
{
    p.path({{4.6f, 4}, {11.4f, 4}, {13.6f, 6}, {14.6f, 12}, {12.6f, 12.6f}, {10, 10}, {6, 10}, {3.4f, 12.6f}, {1.4f, 12}, {2.4f, 6}}, true);
    p.line(4.4f, 7, 7, 7), p.line(5.7f, 5.7f, 5.7f, 8.3f);
    p.disc(10.8f, 7, 1);
}

void page(const Pen& p)
{
    p.path({{3.5f, 1.8f}, {9.5f, 1.8f}, {12.8f, 5}, {12.8f, 14.2f}, {3.5f, 14.2f}}, true);
    p.path({{9.3f, 2}, {9.3f, 5.3f}, {12.6f, 5.3f}});
}

void folder(const Pen& p)
{
    p.path({{1.8f, 13.2f}, {1.8f, 3}, {6.2f, 3}, {7.8f, 5}, {14.2f, 5}, {14.2f, 13.2f}}, true);
}

void openFolder(const Pen& p)
{
    p.path({{12.8f, 7}, {12.8f, 5}, {7.6f, 5}, {6, 3}, {1.8f, 3}, {1.8f, 13.2f}});
    p.path({{1.8f, 13.2f}, {4, 7.2f}, {15, 7.2f}, {12.6f, 13.2f}}, true);
}

void floppy(const Pen& p)
{
    p.path({{2.2f, 2.2f}, {11.2f, 2.2f}, {13.8f, 4.8f}, {13.8f, 13.8f}, {2.2f, 13.8f}}, true);
    p.box(4.8f, 8.6f, 11.2f, 13.8f, 0);
    p.path({{5, 2.4f}, {5, 5.4f}, {10, 5.4f}, {10, 2.4f}});
}

void turnBack(const Pen& p, bool forward)
{
    const auto x = [forward](float at) { return forward ? 16 - at : at; };
    p.path({{x(2.4f), 6}, {x(9.6f), 6}});
    if (forward)
        p.arc(6.4f, 9.5f, 3.5f, 90, 270);
    else
        p.arc(9.6f, 9.5f, 3.5f, -90, 90);
    p.line(x(9.6f), 13, x(5.2f), 13);
    p.path({{x(5.8f), 2.6f}, {x(2.4f), 6}, {x(5.8f), 9.4f}});
}

void pointer(const Pen& p)
{
    p.path({{3.6f, 1.8f}, {3.6f, 12.4f}, {6.4f, 9.9f}, {8.4f, 14.2f}, {10.3f, 13.3f}, {8.4f, 9.2f}, {12.2f, 8.9f}},
           true);
}

void fourArrows(const Pen& p)
{
    p.line(8, 3, 8, 13);
    p.line(3, 8, 13, 8);
    p.head(8, 0.8f, 0, -1);
    p.head(8, 15.2f, 0, 1);
    p.head(0.8f, 8, -1, 0);
    p.head(15.2f, 8, 1, 0);
}

void roundArrow(const Pen& p)
{
    p.arc(8, 8, 5.6f, -40, 235);
    p.head(4.2f, 1.4f, 0.72f, -0.69f, 0.1f);
    p.fill({{3, 5.9f}, {2.6f, 1.4f}, {6.9f, 3.1f}});
}

void growing(const Pen& p)
{
    p.box(2, 8.6f, 7.4f, 14, 0.6f);
    p.path({{5.4f, 2}, {14, 2}, {14, 10.6f}});
    p.line(8.6f, 7.4f, 11.6f, 4.4f);
    p.head(13, 3, 0.707f, -0.707f, 3);
}

void globe(const Pen& p)
{
    p.circle(8, 8, 6);
    p.line(2, 8, 14, 8);
    p.draw.AddBezierCubic(p.at(8, 2), p.at(4.2f, 5), p.at(4.2f, 11), p.at(8, 14), p.colour, p.width());
    p.draw.AddBezierCubic(p.at(8, 2), p.at(11.8f, 5), p.at(11.8f, 11), p.at(8, 14), p.colour, p.width());
}

void axes(const Pen& p)
{
    p.line(5, 11, 5, 3.4f);
    p.line(5, 11, 12.6f, 11);
    p.line(5, 11, 2.2f, 13.8f);
    p.head(5, 1.2f, 0, -1);
    p.head(14.8f, 11, 1, 0);
}

void magnet(const Pen& p)
{
    p.arc(8, 7.6f, 5.2f, 180, 360);
    p.arc(8, 7.6f, 2.2f, 180, 360);
    p.path({{2.8f, 7.4f}, {2.8f, 13.6f}, {5.8f, 13.6f}, {5.8f, 7.4f}});
    p.path({{10.2f, 7.4f}, {10.2f, 13.6f}, {13.2f, 13.6f}, {13.2f, 7.4f}});
    p.block(2.8f, 10.8f, 5.8f, 13.6f);
    p.block(10.2f, 10.8f, 13.2f, 13.6f);
}

void pin(const Pen& p)
{
    p.arc(8, 6.2f, 4.4f, 150, 390);
    p.path({{4.2f, 8.4f}, {8, 14.6f}, {11.8f, 8.4f}});
    p.disc(8, 6.2f, 1.5f);
}

void treePlus(const Pen& p)
{
    p.path({{6, 1.8f}, {10.4f, 8.4f}, {1.6f, 8.4f}}, true);
    p.path({{6, 5.4f}, {11.2f, 12}, {0.8f, 12}});
    p.line(6, 12, 6, 15);
    p.line(13.2f, 2, 13.2f, 7);
    p.line(10.7f, 4.5f, 15.7f, 4.5f);
}

void dropDown(const Pen& p)
{
    p.line(8, 1.6f, 8, 8.6f);
    p.head(8, 11, 0, 1, 3.4f);
    p.path({{1.6f, 14}, {14.4f, 14}});
}

void corners(const Pen& p)
{
    p.path({{2, 5.4f}, {2, 2}, {5.4f, 2}});
    p.path({{10.6f, 2}, {14, 2}, {14, 5.4f}});
    p.path({{14, 10.6f}, {14, 14}, {10.6f, 14}});
    p.path({{5.4f, 14}, {2, 14}, {2, 10.6f}});
    p.disc(8, 8, 2.2f);
}

void eye(const Pen& p)
{
    p.draw.AddBezierCubic(p.at(1, 8), p.at(4.4f, 2.6f), p.at(11.6f, 2.6f), p.at(15, 8), p.colour, p.width());
    p.draw.AddBezierCubic(p.at(1, 8), p.at(4.4f, 13.4f), p.at(11.6f, 13.4f), p.at(15, 8), p.colour, p.width());
    p.disc(8, 8, 2.3f);
}

void sun(const Pen& p)
{
    p.circle(8, 8, 3);
    for (int i = 0; i < 8; ++i) {
        const float a = float(i) * 0.785398f;
        p.line(8 + 5 * std::cos(a), 8 + 5 * std::sin(a), 8 + 7 * std::cos(a), 8 + 7 * std::sin(a));
    }
}

void sliders(const Pen& p)
{
    const float knob[] = {10, 5.4f, 11.4f};
    for (int i = 0; i < 3; ++i) {
        const float y = 3.4f + 4.6f * float(i);
        p.line(1.6f, y, 14.4f, y);
        p.disc(knob[i], y, 2);
    }
}

void magnifier(const Pen& p)
{
    p.circle(6.8f, 6.8f, 4.4f);
    p.line(10, 10, 14.2f, 14.2f);
}

void cube(const Pen& p)
{
    p.path({{8, 1.6f}, {13.8f, 4.8f}, {13.8f, 11.2f}, {8, 14.4f}, {2.2f, 11.2f}, {2.2f, 4.8f}}, true);
    p.path({{2.4f, 4.9f}, {8, 8}, {13.6f, 4.9f}});
    p.line(8, 8, 8, 14.2f);
}

void groupBoxes(const Pen& p)
{
    p.box(1.8f, 1.8f, 9.6f, 9.6f);
    p.path({{12, 6.4f}, {14.2f, 6.4f}, {14.2f, 14.2f}, {6.4f, 14.2f}, {6.4f, 12}});
}

void mountains(const Pen& p)
{
    p.path({{1, 13.4f}, {6, 4.2f}, {9, 9.4f}, {10.8f, 6.8f}, {15, 13.4f}}, true);
}

void videoCamera(const Pen& p)
{
    p.box(1.4f, 4.4f, 10, 11.8f, 1.4f);
    p.path({{10.2f, 7.2f}, {14.4f, 4.8f}, {14.4f, 11.4f}, {10.2f, 9}});
}

void bin(const Pen& p)
{
    p.line(2.2f, 4, 13.8f, 4);
    p.path({{5.8f, 3.8f}, {5.8f, 1.8f}, {10.2f, 1.8f}, {10.2f, 3.8f}});
    p.path({{3.8f, 4.2f}, {4.6f, 14.2f}, {11.4f, 14.2f}, {12.2f, 4.2f}});
    p.line(6.7f, 6.6f, 6.9f, 11.8f);
    p.line(9.3f, 6.6f, 9.1f, 11.8f);
}

void twoPages(const Pen& p)
{
    p.box(5.6f, 5.6f, 14, 14);
    p.path({{3.8f, 10.4f}, {2, 10.4f}, {2, 2}, {10.4f, 2}, {10.4f, 3.8f}});
}

void triangleSign(const Pen& p)
{
    p.path({{8, 1.8f}, {15, 14}, {1, 14}}, true);
    p.line(8, 6, 8, 10);
    p.disc(8, 12, 0.9f);
}

void infoSign(const Pen& p)
{
    p.circle(8, 8, 6.2f);
    p.line(8, 7.2f, 8, 11.6f);
    p.disc(8, 4.8f, 0.95f);
}

void errorSign(const Pen& p)
{
    p.circle(8, 8, 6.2f);
    p.line(5.6f, 5.6f, 10.4f, 10.4f);
    p.line(10.4f, 5.6f, 5.6f, 10.4f);
}

void clockFace(const Pen& p)
{
    p.circle(8, 8, 6.2f);
    p.path({{8, 4.2f}, {8, 8}, {10.8f, 9.8f}});
}

void layers(const Pen& p)
{
    p.path({{8, 1.8f}, {14.6f, 5.4f}, {8, 9}, {1.4f, 5.4f}}, true);
    p.path({{1.6f, 8.4f}, {8, 11.8f}, {14.4f, 8.4f}});
    p.path({{1.6f, 11.4f}, {8, 14.8f}, {14.4f, 11.4f}});
}

void house(const Pen& p)
{
    p.path({{1.4f, 8}, {8, 2}, {14.6f, 8}});
    p.path({{3.4f, 6.6f}, {3.4f, 14}, {12.6f, 14}, {12.6f, 6.6f}});
}

void grid(const Pen& p)
{
    p.box(2, 2, 14, 14, 1);
    for (const float at : {6.f, 10.f}) {
        p.line(at, 2, at, 14);
        p.line(2, at, 14, at);
    }
}

void console(const Pen& p)
{
    p.box(1.4f, 2.4f, 14.6f, 13.6f, 1.4f);
    p.path({{4.2f, 5.8f}, {6.6f, 8}, {4.2f, 10.2f}});
    p.line(8.2f, 10.6f, 11.8f, 10.6f);
}

void chart(const Pen& p)
{
    p.path({{1.8f, 1.8f}, {1.8f, 14.2f}, {14.2f, 14.2f}});
    p.block(4, 8.4f, 6.2f, 12.6f);
    p.block(7.6f, 4, 9.8f, 12.6f);
    p.block(11.2f, 6.4f, 13.4f, 12.6f);
}

void fir(const Pen& p)
{
    p.path({{8, 1.4f}, {12.6f, 8.2f}, {3.4f, 8.2f}}, true);
    p.path({{5.6f, 8.4f}, {2.4f, 12.6f}, {13.6f, 12.6f}, {10.4f, 8.4f}});
    p.line(8, 12.6f, 8, 15);
}

void backArrow(const Pen& p)
{
    p.arc(8, 8.4f, 5.2f, -70, 200);
    p.fill({{9.6f, 0.6f}, {9.6f, 6}, {5.6f, 3.2f}});
}

void strokes(const Pen& p, Icon icon)
{
    switch (icon) {
    case Icon::None:
        break;
    case Icon::New:
        return page(p);
    case Icon::Open:
        return openFolder(p);
    case Icon::Folder:
        return folder(p);
    case Icon::Save:
        return floppy(p);
    case Icon::Undo:
        return turnBack(p, false);
    case Icon::Redo:
        return turnBack(p, true);
    case Icon::Select:
        return pointer(p);
    case Icon::Translate:
        return fourArrows(p);
    case Icon::Rotate:
        return roundArrow(p);
    case Icon::Scale:
        return growing(p);
    case Icon::World:
        return globe(p);
    case Icon::Local:
        return axes(p);
    case Icon::Snap:
        return magnet(p);
    case Icon::Place:
        return treePlus(p);
    case Icon::PlaceHere:
        return pin(p);
    case Icon::Drop:
        return dropDown(p);
    case Icon::Frame:
        return corners(p);
    case Icon::Eye:
        return eye(p);
    case Icon::Sun:
        return sun(p);
    case Icon::Sliders:
        return sliders(p);
    case Icon::Search:
        return magnifier(p);
    case Icon::Close:
        p.line(3.5f, 3.5f, 12.5f, 12.5f), p.line(12.5f, 3.5f, 3.5f, 12.5f);
        break;
    case Icon::Cross:
        p.line(3, 3, 13, 13), p.line(13, 3, 3, 13);
        break;
    case Icon::ChevronRight:
        p.path({{6, 4}, {10, 8}, {6, 12}});
        break;
    case Icon::ChevronDown:
        p.path({{4, 6}, {8, 10}, {12, 6}});
        break;
    case Icon::Cube:
        return cube(p);
    case Icon::Group:
        return groupBoxes(p);
    case Icon::Marker:
        p.box(3, 3, 13, 13, 0), p.disc(8, 8, 1.4f);
        break;
    case Icon::Terrain:
        return mountains(p);
    case Icon::Camera:
        return videoCamera(p);
    case Icon::Trash:
        return bin(p);
    case Icon::Copy:
        return twoPages(p);
    case Icon::Info:
        return infoSign(p);
    case Icon::Warning:
        return triangleSign(p);
    case Icon::Error:
        return errorSign(p);
    case Icon::Clock:
        return clockFace(p);
    case Icon::Layers:
        return layers(p);
    case Icon::Home:
        return house(p);
    case Icon::Up:
        p.line(8, 13.6f, 8, 3), p.path({{3.6f, 7.4f}, {8, 3}, {12.4f, 7.4f}});
        break;
    case Icon::Plus:
        p.line(8, 2.6f, 8, 13.4f), p.line(2.6f, 8, 13.4f, 8);
        break;
    case Icon::Grid:
        return grid(p);
    case Icon::Console:
        return console(p);
    case Icon::Chart:
        return chart(p);
    case Icon::Tree:
        return fir(p);
    case Icon::Check:
        p.path({{2.8f, 8.4f}, {6.4f, 12}, {13.2f, 4.4f}});
        break;
    case Icon::Reset:
        return backArrow(p);
    case Icon::Speaker:
        return speaker(p);
    case Icon::Pad:
        return pad(p);
    case Icon::Down:
        p.line(8, 2.4f, 8, 13), p.path({{3.6f, 8.6f}, {8, 13}, {12.4f, 8.6f}});
        break;
    }
}

} // namespace

void drawIcon(ImDrawList& draw, Icon icon, ImVec2 topLeft, float size, ImU32 colour)
{
    strokes({draw, {std::floor(topLeft.x), std::floor(topLeft.y)}, size / 16, colour}, icon);
}

} // namespace editor
