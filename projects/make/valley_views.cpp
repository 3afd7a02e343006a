#include "projects/make/valley.h"
#include "projects/make/valley_land.h"

namespace make {

// Eyes and targets are heights above the ground below them; x and z are the world's.
void setViews(Stage& stage)
{
    const auto near = [](float x, float y, float z) { return glm::vec3{kCamp.x + x, y, kCamp.y + z}; };
    const auto onStream = [](float z, float y, float aside = 0) { return glm::vec3{streamX(z) + aside, y, z}; };
    std::vector<io::Camera> cameras{
        cameraAt(stage, "camp", near(11, 1.9f, 10), near(-6, 2.6f, -6), 58),
        cameraAt(stage, "overview", near(210, 62, 330), near(-70, 30, -240), 52),
        cameraAt(stage, "forest edge", near(-20, 1.8f, 42), near(-60, 5, 10), 60),
        cameraAt(stage, "ridge", {-330, 14, -120}, {40, 0, 120}, 60),
        cameraAt(stage, "stream", onStream(175, 1.5f), onStream(60, 5), 56),
        cameraAt(stage, "hut", near(-6, 1.8f, -2), near(-26, 2.8f, -21), 50),
    };
    io::CameraPath fly{.name = "fly"};
    fly.keys = {
        keyAt(stage, 0, near(210, 62, 330), near(-70, 30, -240)),
        keyAt(stage, 5, near(140, 34, 215), near(-40, 8, -60)),
        keyAt(stage, 9, near(62, 14, 90), near(-8, 2, -6)),
        keyAt(stage, 12.5, near(24, 7, 34), near(-8, 2, -8)),
        keyAt(stage, 16, near(22, 9, -22), near(-30, 3, -30)),
        keyAt(stage, 20, onStream(10, 14, 8), onStream(-180, 14)),
        keyAt(stage, 25, onStream(-150, 26, 6), onStream(-420, 50)),
    };
    stage.setViews(std::move(cameras), {std::move(fly)});
}

} // namespace make
