#include <btBulletDynamicsCommon.h>

#include <memory>

#include "tests/bench/peers/capsules.hpp"

// The overhand pull with Bullet's rigid capsules in double precision, its sequential impulse solver.
namespace {

using bench::lab::PullDef;
using bench::peers::Settings;
using sim::geometry::Vec3;

constexpr int hand = -1;  // a body's number when it is no link

class Strangers : public btOverlapFilterCallback {
  public:
    explicit Strangers(int neighbours) : neighbours_(neighbours) {}
    bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override {
        const int i = number(a), j = number(b);
        return i != hand && j != hand && std::abs(i - j) >= neighbours_;
    }

  private:
    static int number(const btBroadphaseProxy* proxy) {
        return static_cast<const btCollisionObject*>(proxy->m_clientObject)->getUserIndex();
    }
    int neighbours_;
};

class BulletRope : public bench::lab::Rope {
  public:
    BulletRope(const PullDef& def, const Settings& settings, const std::vector<Vec3>& start)
        : def_(def),
          settings_(settings),
          strangers_(bench::peers::neighbours(def)),
          capsule_(0.5 * def.thickness() * settings.scale, def.link() * settings.scale),
          point_(0.01 * def.thickness() * settings.scale) {
        world_.getPairCache()->setOverlapFilterCallback(&strangers_);
        world_.setGravity(btVector3(0, 0, 0));
        btContactSolverInfo& solver = world_.getSolverInfo();
        solver.m_numIterations = settings.iterations;
        solver.m_erp = solver.m_erp2 = settings.error_reduction;
        for (std::size_t i = 0; i + 1 < start.size(); ++i) add_link(start[i], start[i + 1], static_cast<int>(i));
        const btVector3 half(0.5 * def.link() * settings.scale, 0, 0), middle(0, 0, 0);
        for (std::size_t i = 1; i < links_.size(); ++i) join(*links_[i - 1], *links_[i], half, -half);
        left_ = add_hand(start.front());
        right_ = add_hand(start.back());
        join(*left_, *links_.front(), middle, -half);
        join(*right_, *links_.back(), middle, half);
    }
    ~BulletRope() override {
        for (auto& joint : joints_) world_.removeConstraint(joint.get());
        for (auto& body : bodies_) world_.removeRigidBody(body.get());
    }
    BulletRope(const BulletRope&) = delete;
    BulletRope& operator=(const BulletRope&) = delete;

    void tick(const Vec3& left, const Vec3& right) override {
        move(*left_, left);
        move(*right_, right);
        world_.stepSimulation(def_.tick, 0, def_.tick);
    }

    // A node is where both links that meet there see it: half a joint's gap lengthens either.
    void read(std::vector<Vec3>& nodes) const override {
        nodes.front() = end(*links_.front(), -1);
        for (std::size_t i = 1; i < links_.size(); ++i) nodes[i] = 0.5 * (end(*links_[i - 1], 1) + end(*links_[i], -1));
        nodes.back() = end(*links_.back(), 1);
    }

  private:
    btVector3 scaled(const Vec3& p) const { return btVector3(p.x(), p.y(), p.z()) * settings_.scale; }

    btRigidBody* add(double mass, btCollisionShape& shape, const btTransform& pose, int number) {
        btVector3 inertia(0, 0, 0);
        if (mass > 0) shape.calculateLocalInertia(mass, inertia);
        btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
        info.m_startWorldTransform = pose;
        info.m_friction = std::sqrt(def_.friction);  // Bullet takes the product of both bodies'
        info.m_linearDamping = settings_.linear_damping;
        info.m_angularDamping = 1 - std::exp(-settings_.angular_damping);  // Bullet: the share lost in a second
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        btRigidBody* body = bodies_.back().get();
        body->setActivationState(DISABLE_DEACTIVATION);
        body->setUserIndex(number);
        if (number == hand)
            body->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT | btCollisionObject::CF_NO_CONTACT_RESPONSE);
        world_.addRigidBody(body);
        return body;
    }

    void add_link(const Vec3& from, const Vec3& to, int number) {
        const auto turned = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitX(), to - from);  // capsules lie along x
        const btTransform pose(btQuaternion(turned.x(), turned.y(), turned.z(), turned.w()), scaled(0.5 * (from + to)));
        links_.push_back(add(settings_.mass / def_.links, capsule_, pose, number));
    }

    btRigidBody* add_hand(const Vec3& place) {
        return add(0, point_, btTransform(btQuaternion::getIdentity(), scaled(place)), hand);
    }

    void join(btRigidBody& a, btRigidBody& b, const btVector3& in_a, const btVector3& in_b) {
        joints_.push_back(std::make_unique<btPoint2PointConstraint>(a, b, in_a, in_b));
        world_.addConstraint(joints_.back().get(), true);
    }

    void move(btRigidBody& body, const Vec3& place) const {
        btTransform pose = body.getWorldTransform();
        body.setInterpolationWorldTransform(pose);
        pose.setOrigin(scaled(place));
        body.setWorldTransform(pose);
    }

    Vec3 end(const btRigidBody& link, int side) const {
        const btVector3 p = link.getWorldTransform() * btVector3(0.5 * side * def_.link() * settings_.scale, 0, 0);
        return Vec3(p.x(), p.y(), p.z()) / settings_.scale;
    }

    PullDef def_;
    Settings settings_;
    Strangers strangers_;
    btCapsuleShapeX capsule_;
    btSphereShape point_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<std::unique_ptr<btPoint2PointConstraint>> joints_;
    std::vector<btRigidBody*> links_;
    btRigidBody *left_, *right_;
};

}  // namespace

int main(int argc, char** argv) {
    return bench::peers::run<BulletRope>(argc, argv);
}
