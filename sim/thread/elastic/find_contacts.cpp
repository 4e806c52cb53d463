#include "sim/thread/elastic/find_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "sim/geometry/at.hpp"
#include "sim/geometry/closest_points.hpp"
#include "sim/geometry/portable_math.hpp"
#include "sim/geometry/triangle_tree.hpp"
#include "sim/thread/contact/gaps.hpp"

// What of all that an elastic thread is near may press on it in a step, and where each would be.
namespace sim::thread::elastic {

ContactFinder::ContactFinder(std::size_t most_links) {
    nearest_rows_.reserve(8 * most_links);
}

static void add_node(const State& state, Pair& pair, int node, double weight) {
    if (weight == 0 || state.inverse_mass[at(node)] == 0) return;
    pair.node[at(pair.nodes)] = node;
    pair.weight[at(pair.nodes++)] = weight;
}

static const Row* pressed_before(State& state, const Row& row) {
    // On a soft wall with both its ends, each of which goes on with what it pressed with, once.
    const auto is_its_other_end = [&](const Row& k) {
        return is_on_soft_wall(state, row) && (k.is_there_still || std::abs(k.s - row.s) >= 0.5);
    };
    const auto known = std::find_if(state.pressed.begin(), state.pressed.end(), [&](const Row& k) {
        return k.against == row.against && k.link == row.link && k.other == row.other && !is_its_other_end(k);
    });
    if (known == state.pressed.end()) return nullptr;
    known->is_there_still = true;
    return &*known;
}

static Vec3 along(const Vec3& a, const Vec3& b) {
    return (b - a).normalized();
}

// Two lines d apart at an angle b that both turn by a towards each other are d a^2 / (1 - |cos b|) nearer at most, and
// touch so much farther along: no farther than from the middle of a link to its end.
void ContactFinder::add_rolling(const State& state, const Row& row) {
    if (row.against == Against::surface) return;
    const auto end = [&](int link) { return state.nodes[at(link) + 1]; };
    const bool strand = row.against == Against::thread;
    const Capsule other =
        strand ? Capsule{state.nodes[at(row.other)], end(row.other), 0} : state.capsules[at(row.other)];
    const double cosine = std::abs(along(state.nodes[at(row.link)], end(row.link)).dot(along(other.a, other.b)));
    const auto roll = [&](int link, double s) {
        const double arm = std::min(row.distance / (1 - cosine), 0.5 * state.rest_length[at(link)]);
        if (s > 0 && s < 1) rolling_.push_back({link, row.normal, row.normal_push * arm});
    };
    roll(row.link, row.s);
    if (strand) roll(row.other, row.t);
}

bool is_far(const State& state, const Row& row) {
    return row.distance > row.target + about_to_press(state);
}

static double place_of(const State& state, int link, double s) {
    return state.arc[at(link)] + s * state.rest_length[at(link)];
}

// Links that meet in a node touch what is there both, and a link many small triangles of a wall: rows within a radius
// of each other that face the same way say the same; on a wall within a link, which is as long as its bend allows, on a
// soft one within half of it: what lies between two nodes is said at one of them. Round a tool each link needs its own:
// with one for two a wrap lost a tenth of its friction in short ticks.
static bool same_contact(const State& state, const Row& a, const Row& b) {
    constexpr double to_a_node = 0.51;  // half a link, and what rounds
    const double same_direction = a.against == Against::surface ? same_direction_on_wall(state) : 0.94;
    const double radius = state.def.radius, rest = state.rest_length[at(a.link)];
    const double on_wall = is_on_soft_wall(state, a) ? to_a_node * rest : rest;
    const double reach = a.against == Against::surface   ? std::max(radius, on_wall)
                         : a.against == Against::capsule ? std::min(radius, 0.75 * rest)
                                                         : radius;
    const auto near = [&](double p, double q) { return std::abs(p - q) < reach; };
    return a.against == b.against && a.normal.dot(b.normal) > same_direction &&
           near(place_of(state, a.link, a.s), place_of(state, b.link, b.s)) &&
           (a.against != Against::thread || near(place_of(state, a.other, a.t), place_of(state, b.other, b.t)));
}

static ContactConstraint* known_contact(const State& state, std::vector<ContactConstraint>& contacts, const Row& row) {
    const auto known = std::find_if(contacts.begin(), contacts.end(), [&](const ContactConstraint& contact) {
        return same_contact(state, *contact.row, row);
    });
    return known == contacts.end() ? nullptr : &*known;
}

static void push_as_before(ContactConstraint& contact, const Row& before) {
    const Vec3& n = contact.normal;
    contact.push += before.normal_push * n + before.tangent_push - before.tangent_push.dot(n) * n;
    contact.began += before.began;
}

// What pressed on a triangle and now lies nearer to the next goes on pressing there. Forgotten, what stuck would slide:
// the forces on a wall that a tied stitch rests on went up and down by a tenth from tick to tick, by a fiftieth with
// this, and its knot moved three times as much.
static void hand_on_between_triangles(const State& state, std::vector<ContactConstraint>& contacts) {
    for (const Row& before : state.pressed) {
        if (before.against != Against::surface || before.is_there_still) continue;
        if (ContactConstraint* const contact = known_contact(state, contacts, before)) push_as_before(*contact, before);
    }
}

// Where a link that slides on a tool or a wall will face as the step ends, when forces balance: with normals as they
// were, what slides by s about a body of radius r is dragged by s / r of its push besides friction, and drifts off it
// by s^2 / 2 r. Between strands, which rock on each other, it is left out: an overhand pulled at 0.1 m/s came to 0.98
// D, and knots that were let go of trembled.
static Vec3 normal_ahead(const State& state, const Row& row) {
    constexpr double most_turn = 0.95;  // a cosine: what turns farther does not slide, it goes round a corner
    const auto velocity = state.rod.velocity();
    const auto ahead = [&](int node) { return Vec3(state.nodes[at(node)] + state.input.seconds * velocity[at(node)]); };
    const Vec3 a = ahead(row.link), b = ahead(row.link + 1);
    const bool steel = row.against == Against::capsule;
    const auto nearest =
        steel ? geometry::closest_points(a, b, state.capsules[at(row.other)].a, state.capsules[at(row.other)].b)
              : geometry::closest_points(a, b, (*state.input.surface)[row.other]);
    const Vec3 normal = (nearest.on_a - nearest.on_b).stableNormalized();
    return normal.dot(row.normal) > most_turn ? normal : row.normal;
}

// On a tool or a wall, as the last step ended. What sticks does not go on, and without friction nothing would damp what
// rocks.
static bool slips_on_body(const Row& row) {
    constexpr double all = 0.99;
    return row.against != Against::thread && row.friction > 0 && row.normal_push > 0 &&
           row.tangent_push.norm() > all * row.friction * row.normal_push;
}

void ContactFinder::add_contact(State& state, std::vector<ContactConstraint>& contacts, Row& row) {
    const Row* const before = pressed_before(state, row);
    if (before && slips_on_body(*before)) row.normal = normal_ahead(state, row);
    if (!before && is_far(state, row)) return;
    if (ContactConstraint* const known = known_contact(state, contacts, row)) {
        if (before) push_as_before(*known, *before);
        return;
    }
    ContactConstraint& contact = contacts.emplace_back(&row);
    add_node(state, contact.pair, row.link, 1 - row.s);
    add_node(state, contact.pair, row.link + 1, row.s);
    if (row.against == Against::thread) {
        add_node(state, contact.pair, row.other, row.t - 1);
        add_node(state, contact.pair, row.other + 1, -row.t);
    }
    if (before) push_as_before(contact, *before);
}

// Thread goes on beyond either end of its link, so that it can turn there.
static bool is_inner(const State& state, const Row& row) {
    return !state.is_first(at(row.link)) && !state.is_last(at(row.link + 1));
}

// Where the links before and after it pressed on a rigid wall too, the thread's turn is spread over them as about a
// tool; where they did not, this link makes all of it, as at a rim. O(contacts of the last step).
static bool is_on_belt(const State& state, const Row& row) {
    if (row.against != Against::surface || is_on_soft_wall(state, row)) return false;
    const auto pressed = [&](int link) {
        return std::any_of(state.pressed.begin(), state.pressed.end(), [&](const Row& before) {
            return before.against == Against::surface && before.link == link && before.normal_push > 0;
        });
    };
    return pressed(row.link - 1) && pressed(row.link + 1);
}

// Drag that a polyline lacks about a tool or a rigid wall. Its links turn by an angle and touch with their middles:
// from the balance of its nodes pull grows over a link by (1 + q) / (1 - q) with q = k - k q^2 and k = friction
// sin(angle) / 2, so as if by friction times the angle's sine over the angle. The inverse of that to the sixth power of
// the sine, good to 1 % at 60 degrees, beyond which no more is made up for.
static double for_corners(const State& state, const Row& row, bool on_belt) {
    if (!is_inner(state, row) || !(row.against == Against::capsule || on_belt)) return 1;
    const auto tangent = [&](int link) { return along(state.nodes[at(link)], state.nodes[at(link) + 1]); };
    const double sine = std::max(0.0, 0.5 * (tangent(row.link - 1) - tangent(row.link + 1)).dot(row.normal)),
                 s2 = std::min(sine * sine, 0.75);
    return 1 + s2 * (1.0 / 6 + s2 * (3.0 / 40 + s2 * (15.0 / 336)));
}

// And drag that it has too much of at a rim: what turns by an angle a within one link is in balance at a
// point, where drag is friction times tan(a/2) of both pulls, and not the a/2 that a rope has all round. Good to 1 %
// for a friction of 0.2, up to a right angle, beyond which no more is taken off.
static double for_rims(const State& state, const Row& row, bool on_belt) {
    if (row.against != Against::surface || !is_inner(state, row) || on_belt) return 1;
    const auto tangent = [&](int link) { return along(state.nodes[at(link)], state.nodes[at(link) + 1]); };
    const Vec3 before = tangent(row.link - 1), after = tangent(row.link + 1);
    const double sine = before.cross(after).norm(), cosine = before.dot(after);
    if (cosine <= 0) return 0.25 * 3.14159265358979;
    return sine > 0 ? geometry::portable_atan2(sine, 1 + cosine) * (1 + cosine) / sine : 1;
}

double compliance_of_wall(const State& state, const Row& row) {
    return is_on_soft_wall(state, row) ? state.input.soft_compliance : 0;
}

// Where it would press and drag no more: out of a tool or a wall at once, strands apart as fast as leaves them room.
void ContactFinder::set_rest(const State& state, ContactConstraint& contact) {
    Row& row = *contact.row;
    row.normal_push = contact.push.dot(row.normal);
    const bool on_belt = is_on_belt(state, row);
    row.friction *= for_rims(state, row, on_belt);
    contact.friction = row.friction * for_corners(state, row, on_belt);
    contact.pair.force = contact.push;
    const double stiffness = state.rod.def().contact_stiffness(state.rest_length[0]),
                 soft = compliance_of_wall(state, row);
    contact.compliance = 1 / stiffness + soft;
    contact.rest =
        row.start +
        ((row.against == Against::thread ? row.target : row.thickness) - row.start.dot(row.normal)) * row.normal +
        (contact.push - row.normal_push * row.normal) / stiffness + soft * contact.began;
    if (row.normal_push > 0) add_rolling(state, row);
}

void ContactFinder::sort_by_distance(State& state) {
    nearest_rows_.clear();
    for (Row& row : state.rows) nearest_rows_.push_back(&row);
    std::sort(nearest_rows_.begin(), nearest_rows_.end(), [](const Row* a, const Row* b) {
        return a->distance != b->distance ? a->distance < b->distance : a < b;
    });
}

void ContactFinder::find(State& state, std::vector<ContactConstraint>& contacts) {
    contacts.clear();
    rolling_.clear();
    sort_by_distance(state);
    for (Row& row : state.pressed) row.is_there_still = false;
    for (Row* row : nearest_rows_) add_contact(state, contacts, *row);
    hand_on_between_triangles(state, contacts);
    for (ContactConstraint& contact : contacts) set_rest(state, contact);
    pairs_.clear();
    for (const ContactConstraint& contact : contacts) pairs_.push_back(contact.pair);
}

}  // namespace sim::thread::elastic
