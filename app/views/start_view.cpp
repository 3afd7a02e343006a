#include "app/views/start_view.h"

#include "app/views/edit_view.h"

namespace app {

// What lies on the disk is looked up when somebody comes here, and not in each frame.
void StartView::wake()
{
    m_edit.editor().listProjects();
    m_edit.editor().wake();
}

void StartView::runImGui()
{
    m_edit.editor().frame(m_seconds);
}

} // namespace app
