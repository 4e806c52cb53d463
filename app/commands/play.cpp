#include "app/commands/commands.hpp"
#include "app/window/open.hpp"

namespace app {

int play_command(const PlayOptions& options) {
    window::open(options);
    return 0;
}

}  // namespace app
