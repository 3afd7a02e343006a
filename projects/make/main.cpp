// wold-make-worlds OUTPUT_FOLDER [NAME…]: makes the worlds that ship, the same bytes every time.
#include "projects/make/worlds.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

int main(int count, char** words)
{
    if (count < 2) {
        std::fputs("usage: wold-make-worlds OUTPUT_FOLDER [valley | forest-1 | forest-2 | forest-3 | empty]…\n",
                   stderr);
        return 2;
    }
    make::Textures textures;
    for (const make::WorldPlan& plan : make::worldPlans()) {
        if (count > 2 && std::find(words + 2, words + count, plan.name) == words + count) continue;
        const auto begun = std::chrono::steady_clock::now();
        const io::Status made = plan.make(std::filesystem::path{words[1]} / plan.name, textures);
        if (!made) {
            std::fprintf(stderr, "wold-make-worlds: %s\n", made.error().text().c_str());
            return 1;
        }
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
        std::printf("%s made in %.1f s\n", std::string{plan.name}.c_str(), took.count());
    }
    return 0;
}
