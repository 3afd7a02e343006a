#include "stage.h"

namespace test {

io::TemplateId Stage::addTemplate(const std::string& name, io::Collision collision, const io::Model& model, bool dynamic)
{
    const io::TemplateId id = scene.templateSlot(name);
    scene.exchange(id, io::Template{.name = name, .collision = collision, .body = {.dynamic = dynamic}});
    assets.models.resize(number(id));
    assets.models[number(id) - 1] = std::make_shared<io::Model>(model);
    return id;
}

io::TemplateId Stage::addBox(const glm::vec3& size, io::Collision collision)
{
    return addTemplate("box" + std::to_string(scene.templates().size()), collision, io::boxModel(size, glm::vec4{1}));
}

io::ObjectId Stage::place(io::TemplateId id, const glm::dvec3& at, const glm::vec3& rotation, const glm::vec3& scale)
{
    const io::ObjectId fresh = scene.freshId();
    scene.exchange(fresh, io::Object{.id = fresh, .templateId = id, .transform = {at, rotation, scale}});
    return fresh;
}

void Stage::move(io::ObjectId id, const glm::dvec3& to)
{
    io::Object object = scene.at(id);
    object.transform.position = to;
    scene.exchange(id, object);
    surroundings().follow({.objects = {id}});
}

void Stage::setGround(const std::function<double(double, double)>& height)
{
    io::HeightGrid grid{.size = {65, 65}, .origin = {-32, -32}};
    for (int z = 0; z < 65; ++z)
        for (int x = 0; x < 65; ++x)
            grid.metres.push_back(float(height(x - 32, z - 32)));
    scene.exchange(std::make_shared<const io::HeightMap>(grid));
}

play::Surroundings& Stage::surroundings()
{
    if (!around) around = std::make_unique<play::Surroundings>(scene, assets);
    return *around;
}

void walk(play::Walker& walker, Stage& stage, const play::Wish& wish, int steps, const std::function<void()>& each)
{
    for (int i = 0; i < steps; ++i) {
        walker.step(wish, stage.surroundings());
        if (each) each();
    }
}

} // namespace test
