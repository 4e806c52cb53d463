#include "app/exit_code.hpp"

#include <iostream>
#include <stdexcept>

#include "app/fault.hpp"
#include "app/one_line.hpp"
#include "assets/mesh.hpp"
#include "scenarios/drill/file.hpp"
#include "scenarios/recording/recording.hpp"

namespace app {

static int fail(int exit_code, const std::string& what) {
    std::cerr << one_line(what);
    return exit_code;
}

int exit_code_of(const std::string& program, const std::function<int()>& work) try {
    const int exit_code = work();
    if (!std::cout.flush()) throw std::runtime_error("standard output could not be written to its end");
    return exit_code;
} catch (const CheckFailed& failed) {
    return fail(3, failed.what());
} catch (const InputFault& fault) {
    return fail(2, fault.what());
} catch (const assets::AssetError& fault) {
    return fail(2, fault.what());
} catch (const scenarios::drill::FileError& fault) {
    return fail(2, fault.what());
} catch (const scenarios::recording::RecordingError& fault) {
    return fail(2, fault.what());
} catch (const std::exception& error) {
    return fail(1, program + ": failed: " + error.what());
}

}  // namespace app
