#include "app/hands/mouse.hpp"

namespace app::hands {

void Mouse::add(const Motion& motion, bool turns, double share) {
    Smooth<7>::Vector way = Smooth<7>::Vector::Zero();
    way.segment<2>(turns ? 2 : 0) = share * Eigen::Vector2d(motion.right, motion.down);
    smooth_.add(way);
}

void Mouse::add_wheel(double notches, WheelTo to, double share) {
    Smooth<7>::Vector way = Smooth<7>::Vector::Zero();
    way[4 + static_cast<int>(to)] = share * notches;
    smooth_.add(way);
}

// What is nearest to the eye goes with the mouse, as with a ball under the hand.
Mouse::Out Mouse::next(double seconds, const Settings& settings, const Sight& sight, const Vec3& tool) {
    const Smooth<7>::Vector way = smooth_.next(seconds, settings.smoothing_s);
    const double pixel = sight.metres_per_pixel(tool);
    Out out;
    out.step.move = {pixel * way[0], -pixel * way[1], -settings.wheel * way[4]};
    out.step.turn = {settings.turn * way[3], settings.turn * way[2], 0};
    out.step.roll = settings.roll * way[5];
    out.needle = settings.needle * way[6];
    return out;
}

}  // namespace app::hands
