// Contracts: what our own code promises itself. A broken one is our bug, never the user's data.
#pragma once

namespace io {
[[noreturn]] void contractBroken(const char* condition, const char* file, int line);
}

// Kept in every build: a wrong world on disk costs more than a branch.
#define EXPECTS(condition)                                                                                             \
    do {                                                                                                               \
        if (!(condition)) ::io::contractBroken(#condition, __FILE__, __LINE__);                                        \
    } while (false)
