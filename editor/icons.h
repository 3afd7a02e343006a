// Icons as strokes on a 16 x 16 grid, drawn sharp at any size: no icon font, no picture files.
#pragma once

#include <imgui.h>

namespace editor {

enum class Icon {
    None,
    New,
    Open,
    Save,
    Undo,
    Redo,
    Select,
    Translate,
    Rotate,
    Scale,
    World,
    Local,
    Snap,
    Place,
    PlaceHere,
    Drop,
    Frame,
    Eye,
    Sun,
    Sliders,
    Search,
    Close,
    Cross,
    ChevronRight,
    ChevronDown,
    Cube,
    Group,
    Marker,
    Terrain,
    Camera,
    Trash,
    Copy,
    Info,
    Warning,
    Error,
    Clock,
    Layers,
    Home,
    Folder,
    Up,
    Plus,
    Grid,
    Console,
    Chart,
    Tree,
    Check,
    Reset,
    Speaker,
    Pad,
    Down
};

void drawIcon(ImDrawList& draw, Icon icon, ImVec2 topLeft, float size, ImU32 colour);

} // namespace editor
