#include "tests/ui/support/rig.h"

#include "editor/text.h"
#include "editor/theme.h"
#include "editor/ui_map.h"
#include "io/files/atomic_file.h"
#include "io/files/json.h"

#include <gtest/gtest.h>

namespace test {
namespace {

constexpr float kWidth = 1280, kHeight = 720;
constexpr float kSecond = 1 / 60.f;

std::string labels(const io::Value& map)
{
    std::string all;
    for (const io::Value& item : *map.asArray())
        all += *item.find("label")->asString() + " (" + *item.find("kind")->asString() + "), ";
    return all;
}

std::shared_ptr<const io::HeightMap> flatGround()
{
    return std::make_shared<const io::HeightMap>(
        io::HeightGrid{.size = {65, 65}, .metres = std::vector<float>(65 * 65, 0), .metresPerTexel = 4, .origin = {-128, -128}});
}

void mapKeys(ImGuiIO& io)
{
    using editor::Key;
    constexpr std::pair<ImGuiKey, Key> kKeys[] = {{ImGuiKey_Tab, Key::Tab},
                                                  {ImGuiKey_Enter, Key::Enter},
                                                  {ImGuiKey_Escape, Key::Escape},
                                                  {ImGuiKey_Backspace, Key::Backspace},
                                                  {ImGuiKey_Delete, Key::Delete},
                                                  {ImGuiKey_A, Key::A},
                                                  {ImGuiKey_C, Key::C},
                                                  {ImGuiKey_V, Key::V},
                                                  {ImGuiKey_X, Key::X},
                                                  {ImGuiKey_Y, Key::Y},
                                                  {ImGuiKey_Z, Key::Z}};
    for (const auto& [key, code] : kKeys)
        io.KeyMap[key] = int(code);
}

} // namespace

void MemoryHost::setLanguage(const std::string& code)
{
    const std::string file = WOLD_SOURCE_DIR "/app/lang/" + code + ".json";
    const auto text = io::readFile(file);
    ASSERT_TRUE(text) << text.error().text();
    const auto parsed = io::parseJson(*text, file);
    ASSERT_TRUE(parsed) << parsed.error().text();
    m_language = code;
    editor::setTexts(*parsed);
}

std::unique_ptr<editor::Document> crates(int count)
{
    io::World world{.project = {.folder = "/nowhere", .name = "Test"}, .entry = {.name = "main"}};
    const io::TemplateId crate = world.scene.templateSlot("crate"), post = world.scene.templateSlot("post");
    world.scene.exchange(
        crate, io::Template{.name = "crate", .category = "Things", .model = "models/crate.glb", .yaw = {0, 0}});
    world.scene.exchange(post, io::Template{.name = "post", .category = "Markers"});
    for (int i = 0; i < count; ++i) {
        io::Object object{.id = world.scene.freshId(), .templateId = crate};
        object.transform.position = {4.0 * i, 0, 0};
        world.scene.exchange(object.id, object);
    }
    world.scene.exchange(std::vector<io::Camera>{{.name = "view", .eye = {8, 8, 24}, .pitch = -18}});
    io::Assets assets;
    assets.models = {std::make_shared<io::Model>(io::boxModel({2, 2, 2}, {1, 1, 1, 1})),
                     std::make_shared<io::Model>(io::boxModel({1, 1, 1}, {1, 1, 1, 1}))};
    const auto ground = flatGround();
    world.scene.exchange(io::Terrain{.metresPerTexel = ground->metresPerTexel, .origin = ground->origin});
    world.scene.exchange(ground);
    return std::make_unique<editor::Document>(std::move(world), std::move(assets));
}

Rig::Rig(std::unique_ptr<editor::Document> document, io::Value settings)
{
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {kWidth, kHeight};
    io.DeltaTime = kSecond;
    io.MousePos = {-1, -1};
    mapKeys(io);
    editor::applyTheme();
    editor::addFonts(*io.Fonts, {});
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    host.saved = std::move(settings);
    host.setLanguage("en");
    editor = std::make_unique<editor::Editor>(host);
    if (document) editor->adopt(std::move(document));
    frame(3);
}

Rig::~Rig()
{
    editor.reset();
    ImGui::DestroyContext();
}

void Rig::frame(int count)
{
    for (int i = 0; i < count; ++i) {
        ImGui::NewFrame();
        editor->frame(kSecond);
        ImGui::Render();
    }
}

void Rig::pass(double seconds)
{
    ImGui::GetIO().DeltaTime = float(seconds);
    ImGui::NewFrame();
    editor->frame(seconds);
    ImGui::Render();
    ImGui::GetIO().DeltaTime = kSecond;
}

void Rig::move(ImVec2 to)
{
    ImGui::GetIO().MousePos = to;
    frame(2);
}

void Rig::press(int button)
{
    ImGui::GetIO().MouseDown[button] = true;
    frame();
}

void Rig::release(int button)
{
    ImGui::GetIO().MouseDown[button] = false;
    frame(2);
}

void Rig::click(ImVec2 at, int button)
{
    frame(25); // never a double click
    move(at);
    press(button);
    release(button);
}

void Rig::doubleClick(ImVec2 at)
{
    click(at);
    press();
    release();
}

void Rig::drag(ImVec2 from, ImVec2 to, int button)
{
    constexpr int kSteps = 8;
    frame(25);
    move(from);
    press(button);
    for (int i = 1; i <= kSteps; ++i) {
        ImGui::GetIO().MousePos = {from.x + (to.x - from.x) * float(i) / kSteps,
                                   from.y + (to.y - from.y) * float(i) / kSteps};
        frame();
    }
    release(button);
}

void Rig::hold(bool ctrl, bool shift, bool alt)
{
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = ctrl;
    io.KeyShift = shift;
    io.KeyAlt = alt;
    frame();
}

void Rig::key(editor::Chord chord)
{
    hold(chord.ctrl, chord.shift, chord.alt);
    ImGui::GetIO().KeysDown[int(chord.key)] = true;
    frame();
    ImGui::GetIO().KeysDown[int(chord.key)] = false;
    hold(false);
}

void Rig::type(std::string_view text)
{
    ImGui::GetIO().AddInputCharactersUTF8(std::string{text}.c_str());
    frame(2);
}

const io::Value* Rig::find(const io::Value& map, std::string_view label, std::string_view kind, std::string_view panel)
{
    for (const io::Value& item : *map.asArray())
        if (*item.find("label")->asString() == label && (kind.empty() || *item.find("kind")->asString() == kind) &&
            (panel.empty() || *item.find("panel")->asString() == panel))
            return &item;
    return nullptr;
}

bool Rig::has(std::string_view label, std::string_view kind, std::string_view panel)
{
    const io::Value map = editor::uiMap();
    return find(map, label, kind, panel) != nullptr;
}

ImVec2 Rig::at(std::string_view label, std::string_view kind, std::string_view panel)
{
    const io::Value map = editor::uiMap();
    const io::Value* item = find(map, label, kind, panel);
    EXPECT_TRUE(item) << "no widget \"" << label << "\" " << kind << " among " << labels(map);
    if (!item) return {-1, -1};
    const io::Value::Array& rect = *item->find("rect")->asArray();
    const auto side = [&rect](std::size_t i) { return float(*rect[i].asNumber()); };
    return {std::floor(side(0) + side(2) / 2), std::floor(side(1) + side(3) / 2)};
}

io::Value Rig::value(std::string_view label, std::string_view kind)
{
    const io::Value map = editor::uiMap();
    const io::Value* item = find(map, label, kind, {});
    const io::Value* value = item ? item->find("value") : nullptr;
    return value ? *value : io::Value{};
}

ImVec2 Rig::onScreen(const glm::dvec3& world)
{
    const editor::View view = editor->viewport().view();
    const auto pixel = editor::project(view, world);
    EXPECT_TRUE(pixel);
    const ImVec2 middle = at("Viewport", "viewport");
    if (!pixel) return {-1, -1};
    return {middle.x - float(view.size.x) / 2 + float(pixel->x), middle.y - float(view.size.y) / 2 + float(pixel->y)};
}

} // namespace test
