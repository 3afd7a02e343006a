// StartView: the start page, as long as no project is open.
#pragma once

#include "app/views/view.h"
#include "editor/editor.h"

namespace app {

class EditView;

class StartView final : public View {
public:
    explicit StartView(EditView& edit) : m_edit{edit} {}

    io::Status init() override { return {}; } // the editor behind it is made by the edit view
    void wake() override;
    void run(double seconds) override { m_seconds = seconds; }
    void runImGui() override;

private:
    EditView& m_edit;
    double m_seconds = 0;
};

} // namespace app
