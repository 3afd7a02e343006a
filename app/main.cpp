#include "app/commands/commands.h"
#include "app/report.h"

#include <cstdio>
#include <exception>
#include <new>

namespace {

int run(std::vector<std::string> arguments)
{
    const auto parsed = app::parseOptions(std::move(arguments));
    if (const auto* ending = std::get_if<app::Ending>(&parsed)) {
        std::fputs(ending->text.c_str(), ending->code == 0 ? stdout : stderr);
        return ending->code;
    }
    return app::execute(std::get<app::Options>(parsed));
}

} // namespace

int main(int count, char** words)
{
    try {
        return run({words + 1, words + count});
    } catch (const std::bad_alloc&) {
        return app::fault({"memory", "there is not enough for this; close other programs or ask for less"});
    } catch (const std::exception& error) {
        return app::fault({"wold", std::string{"unexpected: "} + error.what() + " (a bug in Wold; please report it)"});
    }
}
