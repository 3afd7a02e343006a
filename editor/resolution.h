// Resolution: how much coarser the picture is drawn while the eye moves, so that a frame rate is held.
#pragma once

namespace editor {

class Resolution {
public:
    // Hears how long each frame took while the eye moves, in s, and how many a second are wanted.
    void note(double seconds, double framesPerSecond);
    void sharpen() { *this = {}; } // the eye rests
    double scale() const;          // of the picture's width and height, at most 1

private:
    int m_step = 0;
    int m_slow = 0, m_quick = 0; // frames in a row
    int m_patience = 4;          // quick frames until it is drawn finer
    int m_sinceFiner = 1000;     // frames
};

} // namespace editor
