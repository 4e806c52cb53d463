#include "app/commands/commands.hpp"
#include "app/files.hpp"
#include "scenarios/drill/waypoints.hpp"

namespace app {

int motion_command(const MotionOptions& options) {
    expect_writable("--out", options.out, {options.waypoints});
    expect_ending("--out", options.out, ".csv");
    const auto waypoints = scenarios::drill::load_waypoints(options.waypoints);
    write_file(options.out, scenarios::drill::motion_text(waypoints.motion, waypoints.instruments));
    return 0;
}

}  // namespace app
