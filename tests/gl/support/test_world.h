// A small landscape made by arithmetic: hills, four grounds, trees of crossed leaf cards, boxes.
#pragma once

#include "io/scene/assets.h"
#include "io/scene/scene.h"

namespace test {

struct TestWorld {
    io::Scene scene;
    io::Assets assets;
};

struct WorldOptions {
    glm::ivec2 heightMap{513, 513}; // texels; 0: no terrain
    double metresPerTexel = 2;
    int trees = 600;
    int boxes = 40;
};

TestWorld makeWorld(const WorldOptions& options = {});
io::TemplateId addTemplate(TestWorld& world, const std::string& name, std::shared_ptr<const io::Model> model);
io::ObjectId addObject(TestWorld& world, io::TemplateId id, const io::Transform& transform);

std::shared_ptr<const io::Model> treeModel();
std::shared_ptr<const io::Model> box(const glm::vec3& size, const glm::vec4& colour);
std::shared_ptr<const io::HeightMap> heightMap(glm::ivec2 size, double metresPerTexel, double (*height)(double x, double z));
double hills(double x, double z);

// Writes a picture that anything can open; for a person who looks, not for tests.
void writePng(const std::string& file, const io::Image& image);

} // namespace test
