#include "instruments/bullet_world.hpp"

#include <btBulletCollisionCommon.h>

#include <algorithm>
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
    std::unique_ptr<SurfaceData> surface;  ///< None for a capsule.
    std::unique_ptr<btCollisionShape> shape;
    std::unique_ptr<btCollisionObject> object;
};

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

    ~Impl() {
        for (Body& body : bodies) world.removeCollisionObject(body.object.get());
    }
};

BulletWorld::BulletWorld(double metres_per_unit) : impl_(std::make_unique<Impl>()) {
    impl_->units_per_metre = 1 / metres_per_unit;
    impl_->world.setForceUpdateAllAabbs(false);
    // Bullet is never asked to integrate or to respond, so its sweeps and allowed penetration (0.04) stay out of it.
    impl_->world.getDispatchInfo().m_useContinuous = false;
    impl_->world.getDispatchInfo().m_allowedCcdPenetration = 0;
}

BulletWorld::~BulletWorld() = default;

int BulletWorld::add_surface(const std::vector<Triangle>& triangles) {
    Body body;
    body.surface = std::make_unique<SurfaceData>();
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
    auto shape = std::make_unique<btBvhTriangleMeshShape>(arrays.get(), compressed);
    shape->setMargin(0);  // a wall is where its triangles are
    body.shape = std::move(shape);
    return impl_->add(std::move(body), btCollisionObject::CF_STATIC_OBJECT);
}

int BulletWorld::add_capsule(double length, double radius) {
    Body body;
    // A capsule's margin is its radius: nothing is added to the real size.
    body.shape = std::make_unique<btCapsuleShapeZ>(radius * impl_->units_per_metre, length * impl_->units_per_metre);
    return impl_->add(std::move(body), btCollisionObject::CF_KINEMATIC_OBJECT);
}

void BulletWorld::place(int index, const Capsule& capsule, const Vec3& hinge_axis) {
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

}  // namespace instruments
