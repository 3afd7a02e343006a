// Rig: the whole editor in an ImGui context without a window or a GPU, driven as a person drives it.
#pragma once

#include "editor/editor.h"
#include "editor/keys.h"

#include <imgui.h>
#include <memory>
#include <string>
#include <string_view>

namespace test {

// A host that keeps everything in memory.
class MemoryHost final : public editor::Host {
public:
    std::vector<editor::Language> languages() const override { return {{"en", "English"}, {"cs", "Čeština"}}; }
    std::string language() const override { return m_language; }
    void setLanguage(const std::string& code) override;
    std::vector<std::filesystem::path> recentProjects() const override { return recent; }
    void addRecentProject(const std::filesystem::path& project) override { recent.push_back(project); }
    bool repeatable() const override { return !background; }
    io::Value settings() const override { return saved; }
    void saveSettings(const io::Value& settings) override { saved = settings; }

    std::vector<std::filesystem::path> recent;
    double frameRate() const override { return rate; }
    editor::Held padsHeld() const override { return pads; }

    io::Value saved;
    editor::Held pads; // what a pad holds down
    bool background = false;
    double rate = 30;

private:
    std::string m_language = "en";
};

// Flat ground at height 0 and `count` crates (ids 1…) of 2 m in a row along x, 4 m apart, the first at 0; a template
// "post" without a model. The camera looks at them from the south.
std::unique_ptr<editor::Document> crates(int count);

class Rig {
public:
    explicit Rig(std::unique_ptr<editor::Document> document = crates(5), io::Value settings = {});
    ~Rig();
    Rig(const Rig&) = delete;
    Rig& operator=(const Rig&) = delete;

    void frame(int count = 1);
    void pass(double seconds); // until one frame more
    void move(ImVec2 to);
    void press(int button = 0);
    void release(int button = 0);
    void click(ImVec2 at, int button = 0);
    void doubleClick(ImVec2 at);
    void drag(ImVec2 from, ImVec2 to, int button = 0); // and lets go
    void key(editor::Chord chord);
    void hold(bool ctrl, bool shift = false, bool alt = false); // modifiers, until the next call
    void type(std::string_view text);

    // The middle of a visible widget; the test fails when there is none. An empty panel or kind: any.
    ImVec2 at(std::string_view label, std::string_view kind = {}, std::string_view panel = {});
    bool has(std::string_view label, std::string_view kind = {}, std::string_view panel = {});
    io::Value value(std::string_view label, std::string_view kind = {});
    void click(std::string_view label, std::string_view kind = {}, std::string_view panel = {})
    {
        click(at(label, kind, panel));
    }
    ImVec2 onScreen(const glm::dvec3& world); // in the viewport

    editor::Document& document() { return *editor->document(); }
    glm::dvec3 position(std::uint32_t id) { return document().scene().at(io::ObjectId{id}).transform.position; }

    MemoryHost host;
    std::unique_ptr<editor::Editor> editor;

private:
    const io::Value* find(const io::Value& map, std::string_view label, std::string_view kind, std::string_view panel);
};

} // namespace test
