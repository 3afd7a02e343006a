#include "editor/loading.h"

#include "editor/keys.h"
#include "editor/text.h"
#include "editor/widgets.h"

#include <algorithm>
#include <utility>

namespace editor {

Loading::~Loading()
{
    cancel();
    if (m_thread.joinable()) m_thread.join();
}

void Loading::start(std::filesystem::path project, std::string scene)
{
    cancel();
    if (m_thread.joinable()) m_thread.join();
    m_document.reset();
    m_name =
        project.filename() == "project.json" ? project.parent_path().filename().string() : project.filename().string();
    m_cancelled = false;
    m_fraction = 0;
    m_step.clear();
    m_done = m_announced = false;
    m_thread = std::thread{[this, project = std::move(project), scene = std::move(scene)] { read(project, scene); }};
}

void Loading::read(const std::filesystem::path& project, const std::string& scene)
{
    auto opened = Document::open(project, scene, [this](float fraction, std::string_view step) {
        say(fraction, step);
        return !m_cancelled;
    });
    if (opened)
        m_document = std::move(opened.value());
    else
        m_error = opened.error();
    m_done = true;
}

void Loading::say(float fraction, std::string_view step)
{
    m_fraction = fraction;
    const std::lock_guard lock{m_mutex};
    m_step = step;
}

// What the graphics card and the picker need is made on this thread, and the window stands still meanwhile.
std::optional<Loading::Opened> Loading::finished()
{
    if (!m_thread.joinable() || !m_done) return {};
    if (!m_cancelled && m_document && !std::exchange(m_announced, true)) {
        say(1, tr("loading.prepares"));
        return {};
    }
    m_thread.join();
    std::unique_ptr<Document> document = std::move(m_document);
    if (m_cancelled) return {};
    std::optional<Opened> opened; // made in place: g++ 12 with sanitizers mistrusts a moved Result
    if (document)
        opened.emplace(std::move(document));
    else
        opened.emplace(m_error);
    return opened;
}

void Loading::draw()
{
    constexpr float kWidth = 420;
    if (!running()) return;
    if (!ImGui::IsPopupOpen("##loading")) ImGui::OpenPopup("##loading");
    const MapPanel map{"dialog"};
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x / 2, display.y * 0.46f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({kWidth, 0}, {kWidth, display.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{20, 18});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6);
    const bool open = ImGui::BeginPopupModal("##loading", nullptr,
                                             ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar(2);
    if (!open) return;
    ui::heading(trf("loading.title", m_name).c_str());
    {
        const std::lock_guard lock{m_mutex};
        ui::softText(m_step.empty() ? tr("loading.begins") : ui::fitted(m_step, kWidth - 40).c_str());
    }
    ui::progressBar(m_fraction, kWidth - 40);
    ImGui::Dummy({0, 4});
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - 120);
    if (ui::button("cancel", tr("dialog.cancel"), ui::Emphasis::Normal, {120, 0}) || pressed(Key::Escape)) cancel();
    if (!running()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

} // namespace editor
