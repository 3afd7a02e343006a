#include "projects/make/valley.h"
#include "projects/make/valley_land.h"

namespace make {

// Eyes and targets are heights above the ground below them; x and z are the world's.
void setViews(Stage& stage)
{
    const auto near = [](float x, float y, float z) { return glm::vec3{kCamp.x + x, y, kCamp.y + z}; };
    const auto onStream = [](float z, float y, float aside = 0) { return glm::vec3{streamX(z) + aside, y, z}; };
    std::vector<io::Camera> cameras{
        cameraAt(stage, "overview", {150, 37, 400}, {26, -3, 20}, 55),
        cameraAt(stage, "camp", near(7.0f, 1.5f, 5.6f), near(-6, 2.4f, -4.6f), 58),
        cameraAt(stage, "stream", {20, 3.2f, -60}, {-77, 9, -84}, 60),
        cameraAt(stage, "forest edge", {-5, 1.8f, 190}, {-86, 6, 152}, 60),
        cameraAt(stage, "ridge", {-330, 14, -120}, {40, 0, 120}, 60),
        cameraAt(stage, "hut", near(-6, 1.8f, -3), near(-20, 2.8f, -17), 55),
        cameraAt(stage, "woods", {-120, 36, 330}, {-35, 0, -70}, 55),
    };
    io::CameraPath fly{.name = "fly"};
    fly.keys = {
        keyAt(stage, 0, {150, 37, 400}, {26, -3, 20}),
        keyAt(stage, 5, near(120, 24, 190), near(-20, 2, -40)),
        keyAt(stage, 9, near(62, 14, 90), near(-8, 2, -6)),
        keyAt(stage, 12.5, near(24, 7, 34), near(-8, 2, -8)),
        keyAt(stage, 16, near(22, 9, -22), near(-30, 3, -30)),
        keyAt(stage, 20, onStream(10, 14, 8), onStream(-180, 14)),
        keyAt(stage, 25, onStream(-150, 26, 6), onStream(-420, 50)),
    };
    stage.setViews(std::move(cameras), {std::move(fly)});
}

} // namespace make
