// The shipped valley, open and on the GPU: once for all tests of this program.
#pragma once

#include "app/studio.h"
#include "editor/document.h"

#include <memory>

namespace test {

struct Valley {
    std::unique_ptr<editor::Document> document;
    std::unique_ptr<app::Studio> studio;

    Valley()
    {
        auto opened = editor::Document::open(std::filesystem::path{WOLD_SOURCE_DIR} / "projects/valley");
        EXPECTS(opened);
        document = *std::move(opened);
        auto made = app::Studio::create(true);
        EXPECTS(made);
        studio = *std::move(made);
        studio->follow(*document);
    }

    renderer::Renderer& renderer() { return studio->renderer(); }
    const io::Camera& camera(std::string_view name) const
    {
        const io::Camera* found = document->scene().findCamera(name);
        EXPECTS(found != nullptr);
        return *found;
    }
};

inline Valley& valley()
{
    static Valley valley;
    return valley;
}

} // namespace test
