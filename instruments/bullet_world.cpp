#include "instruments/bullet_world.hpp"

#include <btBulletCollisionCommon.h>

#include <algorithm>
#include <cassert>
#include <deque>

namespace instruments {

namespace {

/// A surface's arrays, which Bullet reads but does not own.
struct SurfaceData {
    std::vector<btScalar> corners;  ///< Bullet units, nine a triangle.
    std::vector<int> indices;
    std::unique_ptr<btTriangleIndexVertexArray> arrays;
};

struct Body {
    std::shared_ptr<SurfaceData> surface;  ///< None for a capsule.
    std::shared_ptr<btCollisionShape> shape;
    std::unique_ptr<btCollisionObject> object;
};

btDbvtNode* leaf_of(btCollisionObject& object) {
    return static_cast<btDbvtProxy*>(object.getBroadphaseHandle())->leaf;
}

struct CollectTriangles final : btTriangleCallback {
    int body;
    std::vector<BulletWorld::Near>& found;
    CollectTriangles(int b, std::vector<BulletWorld::Near>& f) : body(b), found(f) {}
    void processTriangle(btVector3*, int, int index) override { found.push_back({body, index}); }
};

struct Collect final : btBroadphaseAabbCallback {
    btVector3 low, high;
    std::vector<BulletWorld::Near>& found;
    Collect(const btVector3& l, const btVector3& h, std::vector<BulletWorld::Near>& f) : low(l), high(h), found(f) {}
    bool process(const btBroadphaseProxy* proxy) override {
        const auto* object = static_cast<const btCollisionObject*>(proxy->m_clientObject);
        const int body = object->getUserIndex();
        if (!object->isStaticObject()) {
            found.push_back({body, -1});
            return true;
        }
        CollectTriangles triangles(body, found);
        static_cast<const btBvhTriangleMeshShape*>(object->getCollisionShape())
            ->processAllTriangles(&triangles, low, high);
        return true;
    }
};

}  // namespace

struct BulletWorld::Impl {
    double units_per_metre;
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btNullPairCache no_pairs;  // pairs of boxes that overlap are asked for per motion, not kept
    btDbvtBroadphase broadphase{&no_pairs};
    btCollisionWorld world{&dispatcher, &broadphase, &configuration};
    std::deque<Body> bodies;

    explicit Impl(double units) : units_per_metre(units) {
        world.setForceUpdateAllAabbs(false);
        // Bullet is never asked to integrate or to respond, so its sweeps and allowed penetration (0.04) stay out of
        // it.
        world.getDispatchInfo().m_useContinuous = false;
        world.getDispatchInfo().m_allowedCcdPenetration = 0;
    }

    btVector3 bullet(const Vec3& p) const {
        return {p.x() * units_per_metre, p.y() * units_per_metre, p.z() * units_per_metre};
    }

    int add(Body body, int flags) {
        const int index = static_cast<int>(bodies.size());
        body.object = std::make_unique<btCollisionObject>();
        body.object->setCollisionShape(body.shape.get());
        body.object->setCollisionFlags(flags);
        body.object->setUserIndex(index);
        // No contact is kept beyond touching; Bullet's default keeps all of them, however far.
        body.object->setContactProcessingThreshold(0);
        world.addCollisionObject(body.object.get());
        bodies.push_back(std::move(body));
        return index;
    }

    // A body's box in Bullet's tree is wider than the body, by what depends on how it moved before, and decides what is
    // found near it: a copy's boxes are the original's, bit for bit.
    void add_copy(const Body& other) {
        const int flags = other.object->getCollisionFlags();
        const int index = add({other.surface, other.shape, nullptr}, flags);
        btCollisionObject& object = *bodies[static_cast<std::size_t>(index)].object;
        object.setWorldTransform(other.object->getWorldTransform());
        world.updateSingleAabb(&object);
        btDbvtVolume box = leaf_of(*other.object)->volume;
        broadphase.m_sets[0].update(leaf_of(object), box);
    }

    ~Impl() {
        for (Body& body : bodies) world.removeCollisionObject(body.object.get());
    }
};

BulletWorld::BulletWorld(double metres_per_unit) : impl_(std::make_unique<Impl>(1 / metres_per_unit)) {}

BulletWorld::BulletWorld(const BulletWorld& other) : impl_(std::make_unique<Impl>(other.impl_->units_per_metre)) {
    for (const Body& body : other.impl_->bodies) impl_->add_copy(body);
}

BulletWorld& BulletWorld::operator=(const BulletWorld& other) {
    return *this = BulletWorld(other);
}

BulletWorld::BulletWorld(BulletWorld&&) noexcept = default;
BulletWorld& BulletWorld::operator=(BulletWorld&&) noexcept = default;
BulletWorld::~BulletWorld() = default;

int BulletWorld::add_surface(const std::vector<Triangle>& triangles) {
    assert(!triangles.empty() && "a surface of at least one triangle");
    Body body;
    body.surface = std::make_shared<SurfaceData>();
    auto& [corners, indices, arrays] = *body.surface;
    for (const Triangle& triangle : triangles)
        for (const Vec3* p : {&triangle.a, &triangle.b, &triangle.c}) {
            indices.push_back(static_cast<int>(indices.size()));
            for (int axis = 0; axis < 3; ++axis) corners.push_back((*p)[axis] * impl_->units_per_metre);
        }
    arrays = std::make_unique<btTriangleIndexVertexArray>(
        static_cast<int>(triangles.size()), indices.data(), static_cast<int>(3 * sizeof(int)),
        static_cast<int>(indices.size()), corners.data(), static_cast<int>(3 * sizeof(btScalar)));
    // Compressed boxes would add a fixed 1 unit around the mesh and 0.002 around each triangle.
    const bool compressed = false;
    auto shape = std::make_shared<btBvhTriangleMeshShape>(arrays.get(), compressed);
    shape->setMargin(0);  // a wall is where its triangles are
    body.shape = std::move(shape);
    return impl_->add(std::move(body), btCollisionObject::CF_STATIC_OBJECT);
}

int BulletWorld::add_capsule(double length, double radius) {
    Body body;
    // A capsule's margin is its radius: nothing is added to the real size.
    body.shape = std::make_shared<btCapsuleShapeZ>(radius * impl_->units_per_metre, length * impl_->units_per_metre);
    return impl_->add(std::move(body), btCollisionObject::CF_KINEMATIC_OBJECT);
}

void BulletWorld::place(int index, const Capsule& capsule, const Vec3& hinge_axis) {
    assert(index >= 0 && static_cast<std::size_t>(index) < impl_->bodies.size() && "the number of a body");
    const Vec3 z = (capsule.b - capsule.a).normalized(), x = hinge_axis.cross(z);
    const btMatrix3x3 basis(x.x(), hinge_axis.x(), z.x(), x.y(), hinge_axis.y(), z.y(), x.z(), hinge_axis.z(), z.z());
    btCollisionObject& object = *impl_->bodies[static_cast<std::size_t>(index)].object;
    object.setWorldTransform(btTransform(basis, impl_->bullet((capsule.a + capsule.b) / 2)));
    impl_->world.updateSingleAabb(&object);
}

void BulletWorld::near(const Box& box, std::vector<Near>& found) const {
    found.clear();
    Collect collect(impl_->bullet(box.low), impl_->bullet(box.high), found);
    impl_->broadphase.aabbTest(collect.low, collect.high, collect);
    std::sort(found.begin(), found.end());
}

void add_to(sim::geometry::Hash& hash, const BulletWorld& world) {
    const auto add = [&](const btVector3& v) { hash.add(v.x(), v.y(), v.z()); };
    for (const Body& body : world.impl_->bodies) {
        const btTransform& at = body.object->getWorldTransform();
        for (int row = 0; row < 3; ++row) add(at.getBasis()[row]);
        add(at.getOrigin());
        const btDbvtVolume& box = leaf_of(*body.object)->volume;
        add(box.Mins()), add(box.Maxs());
    }
}

}  // namespace instruments
