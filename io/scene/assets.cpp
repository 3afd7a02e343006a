#include "io/scene/assets.h"

namespace io {

WorldBox worldBounds(const Assets& assets, const Object& object)
{
    const Model* model = assets.model(object.templateId);
    return model ? transformed(model->bounds, worldFromModel(object.transform)) : WorldBox{};
}

} // namespace io
