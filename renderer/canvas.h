// Canvas: a picture to draw a whole window's content into where there is no window, and the window's own background.
#pragma once

#include "io/scene/image.h"

#include <glm/glm.hpp>
#include <memory>

namespace renderer {

class Canvas {
public:
    explicit Canvas(glm::ivec2 size);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    glm::ivec2 size() const;
    void begin();     // cleared to black; what is drawn next lands here
    io::Image read(); // RGB8, top row first

private:
    struct State;
    std::unique_ptr<State> m_state;
};

void beginWindow(glm::ivec2 size); // what is drawn next lands in the window, cleared to black

} // namespace renderer
