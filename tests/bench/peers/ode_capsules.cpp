#include <ode/ode.h>

#include "tests/bench/peers/capsules.hpp"

// The overhand pull with capsules of the Open Dynamics Engine, its iterative solver, contacts with Coulomb friction.
namespace {

using bench::lab::PullDef;
using bench::peers::Settings;
using sim::geometry::Vec3;

class OdeRope : public bench::lab::Rope {
  public:
    OdeRope(const PullDef& def, const Settings& settings, const std::vector<Vec3>& start)
        : def_(def), settings_(settings), neighbours_(bench::peers::neighbours(def)) {
        set_up_world();
        for (std::size_t i = 0; i + 1 < start.size(); ++i) add_link(start[i], start[i + 1], static_cast<int>(i));
        for (std::size_t i = 1; i < links_.size(); ++i) join(links_[i - 1], links_[i], start[i]);
        left_ = join(links_.front(), nullptr, start.front());
        right_ = join(links_.back(), nullptr, start.back());
    }
    ~OdeRope() override {
        dJointGroupDestroy(contacts_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
    }
    OdeRope(const OdeRope&) = delete;
    OdeRope& operator=(const OdeRope&) = delete;

    void tick(const Vec3& left, const Vec3& right) override {
        move(left_, left);
        move(right_, right);
        dSpaceCollide(space_, this, meet);
        dWorldQuickStep(world_, def_.tick);
        dJointGroupEmpty(contacts_);
    }

    // A node is where both links that meet there see it: half a joint's gap lengthens either.
    void read(std::vector<Vec3>& nodes) const override {
        nodes.front() = end(links_.front(), -1);
        for (std::size_t i = 1; i < links_.size(); ++i) nodes[i] = 0.5 * (end(links_[i - 1], 1) + end(links_[i], -1));
        nodes.back() = end(links_.back(), 1);
    }

  private:
    void set_up_world() {
        world_ = dWorldCreate();
        space_ = dSweepAndPruneSpaceCreate(
            nullptr, dSAP_AXES_XYZ);  // along the rope first; a hash makes ticks 1.6 times as long
        contacts_ = dJointGroupCreate(0);
        dWorldSetGravity(world_, 0, 0, 0);
        dWorldSetERP(world_, settings_.error_reduction);
        dWorldSetCFM(world_, 1e-9);               // stiff joints; at 0 the solver's rows could be singular
        dWorldSetContactSurfaceLayer(world_, 0);  // strands may touch, not overlap
        dWorldSetQuickStepNumIterations(world_, settings_.iterations);
        dWorldSetLinearDamping(world_, settings_.linear_damping * def_.tick);
        dWorldSetAngularDamping(world_, settings_.angular_damping * def_.tick);
        dWorldSetAutoDisableFlag(world_, 0);
    }

    void add_link(const Vec3& from, const Vec3& to, int number) {
        const double scale = settings_.scale;
        dBodyID body = dBodyCreate(world_);
        const Vec3 middle = 0.5 * scale * (from + to);
        dBodySetPosition(body, middle.x(), middle.y(), middle.z());
        const auto turned = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), to - from);  // capsules lie along z
        const dQuaternion q = {turned.w(), turned.x(), turned.y(), turned.z()};
        dBodySetQuaternion(body, q);
        dMass mass;
        const double radius = 0.5 * def_.thickness() * scale, length = def_.link() * scale;
        dMassSetCapsuleTotal(&mass, settings_.mass / def_.links, 3, radius, length);
        dBodySetMass(body, &mass);
        dGeomID shape = dCreateCapsule(space_, radius, length);
        dGeomSetBody(shape, body);
        dGeomSetData(shape, reinterpret_cast<void*>(static_cast<std::intptr_t>(number)));
        links_.push_back(body);
    }

    dJointID join(dBodyID a, dBodyID b, const Vec3& place) {
        dJointID joint = dJointCreateBall(world_, nullptr);
        dJointAttach(joint, a, b);
        dJointSetBallAnchor(joint, place.x() * settings_.scale, place.y() * settings_.scale,
                            place.z() * settings_.scale);
        return joint;
    }

    void move(dJointID hand, const Vec3& place) const {
        dJointSetBallAnchor2(hand, place.x() * settings_.scale, place.y() * settings_.scale,
                             place.z() * settings_.scale);
    }

    static void meet(void* self, dGeomID a, dGeomID b) {
        const OdeRope& rope = *static_cast<OdeRope*>(self);
        const auto number = [](dGeomID shape) { return reinterpret_cast<std::intptr_t>(dGeomGetData(shape)); };
        if (std::abs(number(a) - number(b)) < rope.neighbours_) return;
        constexpr int most = 3;  // two capsules side by side touch at both ends
        dContact contacts[most];
        const int found = dCollide(a, b, most, &contacts[0].geom, sizeof(dContact));
        for (dContact* contact = contacts; contact != contacts + found; ++contact) {
            contact->surface.mode = dContactApprox1;  // friction in proportion to the normal force
            contact->surface.mu = rope.def_.friction;
            dJointAttach(dJointCreateContact(rope.world_, rope.contacts_, contact), dGeomGetBody(a), dGeomGetBody(b));
        }
    }

    Vec3 end(dBodyID link, int side) const {
        dVector3 p;
        dBodyGetRelPointPos(link, 0, 0, 0.5 * side * def_.link() * settings_.scale, p);
        return Vec3(p[0], p[1], p[2]) / settings_.scale;
    }

    PullDef def_;
    Settings settings_;
    int neighbours_;
    dWorldID world_;
    dSpaceID space_;
    dJointGroupID contacts_;
    std::vector<dBodyID> links_;
    dJointID left_, right_;
};

}  // namespace

int main(int argc, char** argv) {
    dInitODE2(0);
    const int exit_code = bench::peers::run<OdeRope>(argc, argv);
    dCloseODE();
    return exit_code;
}
