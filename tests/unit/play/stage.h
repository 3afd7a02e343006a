// A scene made for one test: ground of a given form, boxes and other shapes on it, and a player that walks through them.
#pragma once

#include "app/play/walker.h"

#include <functional>
#include <memory>
#include <string>

namespace test {

struct Stage {
    io::Scene scene;
    io::Assets assets;
    std::unique_ptr<play::Surroundings> around;

    io::TemplateId addTemplate(const std::string& name, io::Collision collision, const io::Model& model, bool dynamic = false);
    io::TemplateId addBox(const glm::vec3& size, io::Collision collision = io::Collision::Box);
    io::ObjectId place(io::TemplateId id, const glm::dvec3& at, const glm::vec3& rotation = {0, 0, 0}, const glm::vec3& scale = {1, 1, 1});
    void move(io::ObjectId id, const glm::dvec3& to);
    // 64 m around the origin, a texel a metre.
    void setGround(const std::function<double(double, double)>& height);
    play::Surroundings& surroundings(); // made when first asked
};

// Steps with one wish; `each` looks after every step.
void walk(play::Walker& walker, Stage& stage, const play::Wish& wish, int steps, const std::function<void()>& each = {});

} // namespace test
