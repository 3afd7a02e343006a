// Toasts: short messages in a corner of the window that go by themselves. They stand in the log too.
#pragma once

#include "io/base/log.h"

#include <string>
#include <vector>

namespace editor {

class Toasts {
public:
    void add(io::log::Level level, std::string text);
    void pass(double seconds); // time has gone by
    void draw();               // over everything, bottom right
    double nextChange() const; // s until one fades or goes; infinity without any
    bool empty() const { return m_toasts.empty(); }

private:
    struct Toast {
        io::log::Level level;
        std::string text;
        double left; // s
    };
    std::vector<Toast> m_toasts;
};

} // namespace editor
