#include "app/command_line.hpp"
#include "app/exit_code.hpp"

int main(int argc, char** argv) {
    return app::exit_code_of("carrel", [=] { return app::asked_for(argc, argv)(); });
}
