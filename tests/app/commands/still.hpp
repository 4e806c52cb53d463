#pragma once
#include <string>

// Tools that stand still above the square drill's vessel: a session as short or as long as a test wants it.
namespace still {

inline const std::string drill = CARREL_SOURCE "/scenarios/drills/square-knot.json";

inline std::string motion(const std::string& seconds) {
    const std::string left = ",left,-6.6,37,39.5,0,0.8155827440327885,0,0.5786404649140492,0.6\n",
                      right = ",right,22,0,30,0.5606288093051838,0,-0.8280672304692729,0,0\n";
    return "t_s,instrument,x_mm,y_mm,z_mm,qw,qx,qy,qz,jaw\n0" + left + "0" + right + seconds + left + seconds + right;
}

}  // namespace still
