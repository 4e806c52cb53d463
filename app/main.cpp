#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include "app/command_line.hpp"
#include "app/fault.hpp"
#include "app/one_line.hpp"
#include "assets/mesh.hpp"
#include "scenarios/drill/file.hpp"
#include "scenarios/recording/recording.hpp"

static int fail(int exit_code, const std::string& what) {
    std::cerr << app::one_line(what);
    return exit_code;
}

int main(int argc, char** argv) try {
    const int exit_code = app::asked_for(argc, argv)();
    if (!std::cout.flush()) throw std::runtime_error("standard output could not be written to its end");
    return exit_code;
} catch (const app::CheckFailed& failed) {
    return fail(3, failed.what());
} catch (const app::InputFault& fault) {
    return fail(2, fault.what());
} catch (const assets::AssetError& fault) {
    return fail(2, fault.what());
} catch (const scenarios::drill::FileError& fault) {
    return fail(2, fault.what());
} catch (const scenarios::recording::RecordingError& fault) {
    return fail(2, fault.what());
} catch (const std::exception& error) {
    return fail(1, std::string("carrel: failed: ") + error.what());
}
