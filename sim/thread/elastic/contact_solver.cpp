#include "sim/thread/elastic/contact_solver.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "sim/geometry/at.hpp"
#include "sim/geometry/lane.hpp"
#include "sim/thread/contact/rows.hpp"

// What an elastic thread touches, solved together with it: one contact after the other pushes as Coulomb wants it,
// against how the points of all move (Gauss and Seidel on the rod's inverse at the nodes that touch).
namespace sim::thread::elastic {

using geometry::Lane;
using Mat3 = Eigen::Matrix3d;

// The push with which one contact alone would be as Coulomb wants it, from the one it has: its points are `lacks` from
// where they would be. First across, then along.
static Vec3 push_of(const ContactConstraint& contact, const Vec3& lacks) {
    const Vec3& n = contact.normal;
    const double before = contact.push.dot(n), normal = std::max(0.0, before + lacks.dot(n) / contact.own_compliance);
    Vec3 drag = contact.push - before * n + contact.along * (lacks - (normal - before) * contact.across);
    const double size2 = drag.squaredNorm(), most = contact.friction * normal;
    if (size2 > most * most) drag *= most / std::sqrt(size2);
    return normal * n + drag;
}

// Its compliance to its own push.
static void measure_own(ContactConstraint& contact, const Mat3& diagonal_block) {
    const Vec3& n = contact.normal;
    const Mat3 own = diagonal_block + contact.compliance * Mat3::Identity(),
               along = Mat3::Identity() - n * n.transpose();
    contact.across = own * n;
    contact.own_compliance = n.dot(contact.across);
    contact.along = along * (along * own * along + own.trace() * n * n.transpose()).inverse() * along;
}

Vec3 displacement_of(const State& state, const Row& row) {
    const std::span<const Vec3> step = state.rod.step_found();
    const auto moved = [&](int link, double s) { return Vec3((1 - s) * step[at(link)] + s * step[at(link + 1)]); };
    return row.against == Against::thread ? Vec3(moved(row.link, row.s) - moved(row.other, row.t))
                                          : moved(row.link, row.s);
}

// Where the step takes the points of all.
static void find_apart(const State& state, ContactSet& set) {
    set.apart.resize(3 * set.contacts.size());
    for (std::size_t c = 0; c < set.contacts.size(); ++c) {
        const Row& row = *set.contacts[c].row;
        const Vec3 apart = apart_of(state, row) + displacement_of(state, row);
        std::copy_n(apart.data(), 3, set.apart.data() + 3 * c);
    }
}

void push_more(ContactSet& set, const DelassusMatrix& delassus, std::size_t c, const Vec3& more) {
    set.contacts[c].push += more;
    const double* const x = delassus.row(c, 0);
    const double* const y = delassus.row(c, 1);
    const double* const z = delassus.row(c, 2);
    const double along_x = more.x(), along_y = more.y(), along_z = more.z();
    double* const apart = set.apart.data();
    for (const Run& run : delassus.coupled_with(set.contacts[c])) {
        const std::size_t past = 3 * run.past;
        std::size_t i = 3 * run.first;
        for (; i + 4 <= past; i += 4)
            (Lane::from(apart + i) +
             (Lane::from(x + i) * along_x + Lane::from(y + i) * along_y + Lane::from(z + i) * along_z))
                .to(apart + i);
        for (; i < past; ++i) apart[i] += x[i] * along_x + y[i] * along_y + z[i] * along_z;
    }
}

// One contact after the other; returns how much that changed, as share of all pushes.
double ContactSolver::sweep(ContactSet& set) const {
    double changed = 0, all = 0;
    for (std::size_t c = 0; c < set.contacts.size(); ++c) {
        const ContactConstraint& contact = set.contacts[c];
        const Vec3 lacks = contact.rest - set.apart_of(c) - contact.compliance * contact.push;
        if (contact.push.squaredNorm() == 0 && lacks.dot(contact.normal) <= 0) continue;  // as half of them
        const Vec3 push = push_of(contact, lacks), more = push - contact.push;
        changed += more.squaredNorm(), all += push.squaredNorm();
        if (more.squaredNorm() > 0) push_more(set, delassus_, c, more);
    }
    return all > 0 ? std::sqrt(changed / all) : 0;
}

// What the last sweep gained is carried on by `again` times where the ones before led.
void ContactSolver::carry_on(ContactSet& set, double again) {
    for (ContactConstraint& contact : set.contacts) {
        const Vec3 gain = contact.push - contact.before;
        contact.search *= again;
        contact.push += contact.search;
        contact.search += gain;
    }
    for (std::size_t i = 0; i < set.apart.size(); ++i) {
        const double gain = set.apart[i] - apart_before_[i];
        apart_search_[i] *= again;
        set.apart[i] += apart_search_[i];
        apart_search_[i] += gain;
    }
}

static double gained(const ContactSet& set) {
    double sum = 0;
    for (const ContactConstraint& contact : set.contacts) sum += (contact.push - contact.before).squaredNorm();
    return sum;
}

// Sixty keep a knot tight: 80 contacts, the worst of the knot drills, then take half a millisecond. A belt, which
// touches rigid bodies alone, hands drag on from contact to contact along all of it: it gets what its fewer contacts
// leave of that time, and comes to rest in some 300 over 20 contacts. Knots swept so take half as long again.
static int most_sweeps(const State& state, const ContactSet& set) {
    constexpr auto fewest = 60L, most_pushes = 60L * 90;
    const auto is_rigid = [&](const ContactConstraint& contact) {
        return contact.row->against != Against::thread && !is_on_soft_wall(state, *contact.row);
    };
    if (!std::all_of(set.contacts.begin(), set.contacts.end(), is_rigid)) return fewest;
    const auto pushes = [](const ContactConstraint& contact) { return contact.push.squaredNorm() > 0; };
    const long pushing = std::count_if(set.contacts.begin(), set.contacts.end(), pushes);
    return static_cast<int>(std::max(fewest, most_pushes / std::max(1L, pushing)));
}

// Gauss and Seidel alone gain a little less each time where many work against each other; what each sweep gains is
// carried on as by nonlinear conjugate gradients [Silcowitz, Niebe and Erleben 2010, algorithm 1]. A sweep is last, so
// that no push leaves its cone.
int ContactSolver::sweep_until_still(ContactSet& set, int most_sweeps) {
    constexpr double enough = 1e-5;  // of all pushes, by a sweep: with a hundred times that a loaded knot creeps on by
                                     // its thickness every half second
    double last = 0;
    apart_search_.assign(set.apart.size(), 0.0);
    for (int sweeps = 1;; ++sweeps) {
        for (ContactConstraint& contact : set.contacts) contact.before = contact.push;
        apart_before_ = set.apart;
        if (sweep(set) < enough || sweeps == most_sweeps) return sweeps;
        const double now = gained(set);
        carry_on(set, now < last ? now / last : 0);
        last = now;
    }
}

int ContactSolver::solve(State& state, ContactSet& set, const Pieces& pieces) {
    if (set.contacts.empty()) return 0;
    delassus_.measure(state, set.contacts, pieces);
    find_apart(state, set);
    for (std::size_t c = 0; c < set.contacts.size(); ++c) measure_own(set.contacts[c], delassus_.block(c, c));
    const int sweeps = sweep_until_still(set, most_sweeps(state, set));
    normals_.part(set, delassus_, state.def.radius);
    return sweeps;
}

}  // namespace sim::thread::elastic
