// wold run: the editor's commands from a file or stdin, one JSON object a line, an answer each.
#include "app/commands/commands.h"
#include "app/drawing_settings.h"
#include "app/opened.h"
#include "app/report.h"
#include "app/studio.h"
#include "editor/script.h"
#include "io/files/image_file.h"
#include "io/files/json.h"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <iostream>

namespace app {
namespace {

// Draws for scripts; the context is made when the first picture is asked for.
class ScriptPictures {
public:
    ScriptPictures(const Options& options, editor::Document& document, renderer::Settings& drawing)
        : m_options{options}, m_document{document}, m_drawing{drawing}
    {
    }

    void changed(const io::Changes& changes)
    {
        if (m_studio) m_studio->renderer().update(m_document.scene(), m_document.assets(), changes);
    }

    io::Status draw(const editor::RenderRequest& request)
    {
        const auto names = enumNames(renderer::Show{});
        const auto show = std::ranges::find(names, request.show);
        if (show == names.end()) return io::Error{"show", fmt::format("is one of {}", fmt::join(names, " "))};
        const bool radiance = request.out.extension() == ".exr";
        if (radiance && request.show != "final")
            return io::Error{"show", "goes into .png or .jpg; .exr holds the radiance of the final picture"};
        if (io::Status ready = prepare(); !ready) return ready;
        renderer::Renderer& renderer = m_studio->renderer();
        renderer.render({.camera = request.view.camera,
                         .size = request.view.size,
                         .settings = m_drawing,
                         .show = renderer::Show(show - names.begin()),
                         .ids = false});
        return io::writeImage(request.out, radiance ? renderer.readRadiance() : renderer.readPicture());
    }

private:
    io::Status prepare()
    {
        if (m_studio) return {};
        auto studio = Studio::create(m_options.headless);
        if (!studio) return studio.error();
        m_studio = *std::move(studio);
        m_studio->renderer().update(m_document.scene(), m_document.assets(), {.everything = true});
        if (m_options.quality) applyQuality(*m_options.quality, m_studio->renderer().deviceName(), m_drawing);
        return {};
    }

    const Options& m_options;
    editor::Document& m_document;
    renderer::Settings& m_drawing;
    std::unique_ptr<Studio> m_studio;
};

editor::ScriptHooks hooksFor(ScriptPictures& pictures, renderer::Settings& drawing)
{
    constexpr std::size_t kPrefix = std::string_view{"render."}.size();
    return {.changed = [&](const io::Changes& changes) { pictures.changed(changes); },
            .render = [&](const editor::RenderRequest& request) { return pictures.draw(request); },
            .getSetting = [&](std::string_view key) { return getDrawing(drawing, key.substr(kPrefix)); },
            .setSetting = [&](std::string_view key,
                              const io::Value& value) { return setDrawing(drawing, key.substr(kPrefix), value); }};
}

io::Value refusal(const std::string& error)
{
    return io::Value::Object{{"ok", false}, {"error", error}};
}

struct Outcome {
    int line = 0, commands = 0, failed = 0;
    io::Error first; // fault
};

void answerLine(editor::Script& script, const std::string& text, const std::string& name, Outcome& outcome)
{
    const std::string where = fmt::format("{}:{}", name, outcome.line);
    const auto command = io::parseJson(text, where);
    const io::Value answer = command ? script.execute(*command) : refusal(command.error().text());
    std::puts(io::writeJson(answer).c_str());
    std::fflush(stdout); // whoever feeds us through a pipe waits for it
    ++outcome.commands;
    const io::Value* ok = answer.find("ok");
    if (ok && ok->asBool() && *ok->asBool()) return;
    const io::Value* error = answer.find("error");
    if (++outcome.failed == 1)
        outcome.first =
            command ? io::Error{where, error && error->asString() ? *error->asString() : "failed"} : command.error();
}

Outcome answerAll(editor::Script& script, std::istream& lines, const std::string& name)
{
    Outcome outcome;
    for (std::string line; std::getline(lines, line);) {
        ++outcome.line;
        if (line.find_first_not_of(" \t\r") != line.npos) answerLine(script, line, name, outcome);
    }
    return outcome;
}

} // namespace

int runScript(const Options& options)
{
    std::ifstream file;
    const bool piped = options.script == "-";
    if (!piped) {
        std::error_code failed;
        if (!std::filesystem::is_regular_file(options.script, failed))
            return fault({options.script, "is no file; name a script, or - for stdin"});
        file.open(options.script);
        if (!file) return fault({options.script, "cannot be read"});
    }
    auto opened = openAsAsked(options);
    if (const int* code = std::get_if<int>(&opened)) return *code;
    auto& [document, drawing, milliseconds] = std::get<Opened>(opened);
    const auto camera = cameraFor(options, *document);
    if (!camera) return fault(camera.error());

    editor::Selection selection;
    editor::Picker picker;
    editor::View view{.camera = *camera, .size = options.size};
    ScriptPictures pictures{options, *document, drawing};
    editor::Script script{*document, selection, picker, view, hooksFor(pictures, drawing)};
    const Outcome outcome = answerAll(script, piped ? std::cin : file, piped ? "stdin" : options.script);

    const io::Status written = writeFigures(
        options.json,
        io::Value::Object{{"commands", outcome.commands}, {"failed", outcome.failed}, {"load_ms", milliseconds}});
    if (!written) return fault(written.error());
    return outcome.failed == 0 ? 0 : fault(outcome.first);
}

} // namespace app
