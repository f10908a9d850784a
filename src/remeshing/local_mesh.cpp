// Keeps a mesh under local operations by the stars of its points alone. Face neighbours cost more to keep than to
// search.
#include "remeshing/local_mesh.hpp"

#include "base/collect.hpp"
#include "base/shared_access.hpp"
#include "base/touched_array.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"
#include "mesh/shape_qualities.hpp"
#include "mesh/surface_points.hpp"

#include <algorithm>

namespace cleft
{
namespace
{

// Points or tetrahedra that a thread takes. The number changes the time alone.
constexpr int64_t kSlotsAtOnce = 1 << 14;
// Qualities are sines, at most 1.
constexpr double kUnknown = 2;  // no quality

// What is nearly flat may get another sign by the rounding of the map to the frame of a metric. So the sign is that of
// the tetrahedron itself.
double measured_quality(const std::array<Vec3, 4>& corners, const std::array<Vec3, 4>& mapped)
{
    constexpr double kSureSine = 1e-3;
    const double sine = shape_quality(mapped[0], mapped[1], mapped[2], mapped[3]);
    if (sine > kSureSine || orient_sign(corners[0], corners[1], corners[2], corners[3]) > 0)
        return sine;
    return std::min(sine, 0.0);
}

// The other two corners of a tetrahedron at the edge a b, in the order that makes a, b, c, d positive.
Hinge hinge(const Tet& v, int32_t t, int32_t a, int32_t b)
{
    CLEFT_ASSERT(has_corner(v, a) && has_corner(v, b));
    for (size_t e = 0; e < 6; ++e) {
        const int32_t from = v[kEdgeCorners[e][0]], to = v[kEdgeCorners[e][1]];
        if (!((from == a && to == b) || (from == b && to == a)))
            continue;
        // (edge, opposite) is an even permutation of the corners for every edge but (0, 2) and (1, 3).
        const bool even = e != 1 && e != 4;
        const int32_t c = v[kEdgeOpposite[e][even ? 0 : 1]], d = v[kEdgeOpposite[e][even ? 1 : 0]];
        return from == a ? Hinge{t, c, d} : Hinge{t, d, c};
    }
    return {t, -1, -1};
}

}  // namespace

LocalMesh::LocalMesh(Array<Vec3> points, Array<Tet> tets, Array<Material> material, const Run& run)
    : points_(std::move(points)),
      tets_(std::move(tets)),
      materials_(std::move(material)),
      stars_(tets_, points_.size(), run),
      quality_(array_with_room(run, tets_.size(), kUnknown))
{
    CLEFT_ASSERT(materials_.empty() || materials_.size() == tets_.size());
    freeze_hull(run);
}

LocalMesh::PointMetric LocalMesh::metric_at(const Vec3& x) const
{
    const Tensor log = measure_.log_at(x);
    return {log, exp(log)};
}

void LocalMesh::measure_by(const Measure& measure, const Run& run)
{
    measure_ = measure;
    quality_.assign(quality_.size(), kUnknown);
    metrics_.resize(points_.size());
    parallel_for(run, points_.count(), kSlotsAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t v = begin; v < end; ++v)
            metrics_[v] = metric_at(points_[v]);
    });
}

void LocalMesh::freeze_hull(const Run& run)
{
    frozen_.assign(points_.size(), 0);
    const Array<uint8_t> inside = points_inside(tets_, points_.size(), run);
    for (int32_t v = 0; v < point_count(); ++v) {
        if (inside[v])
            continue;
        for (const int32_t t : star(v))
            for (int corner = 0; corner < 4; ++corner) {
                const auto& f = kFaceCorners[corner];
                const int32_t a = tet(t)[f[0]], b = tet(t)[f[1]], c = tet(t)[f[2]];
                // Each face is looked at once, from its least point. A face with a corner inside cannot be on the hull,
                // which spares most searches for a neighbour.
                if (v != std::min({a, b, c}) || inside[a] || inside[b] || inside[c] || neighbour(t, corner) >= 0)
                    continue;
                const unsigned axes = hull_axes(point(a), point(b), point(c));
                for (const int32_t p : {a, b, c})
                    frozen_[p] = static_cast<uint8_t>(frozen_[p] | axes);
            }
    }
}

void LocalMesh::hold(const Array<int32_t>& points, bool until_whole)
{
    for (const int32_t v : points)
        frozen_[v] = static_cast<uint8_t>(kAllAxes | kHeld | (until_whole ? kWaits : 0));
}

bool LocalMesh::waits(int32_t t) const
{
    const Tet& corners = tet(t);
    return std::any_of(corners.begin(), corners.end(), [&](int32_t v) { return (frozen_[v] & kWaits) != 0; });
}

void LocalMesh::settle(const Array<int32_t>& tets)
{
    for (const int32_t t : tets)
        for (const int32_t v : tet(t))
            frozen_[v] |= kSettled;
}

int32_t LocalMesh::tet_at(int32_t v, int32_t w) const
{
    const auto tets = star(v);
    const auto* found = std::find_if(tets.begin(), tets.end(), [&](int32_t t) { return has_corner(tet(t), w); });
    return found == tets.end() ? -1 : *found;
}

int32_t LocalMesh::neighbour(int32_t t, int corner) const
{
    const auto& f = kFaceCorners[corner];
    const int32_t a = tet(t)[f[0]], b = tet(t)[f[1]], c = tet(t)[f[2]];
    // A star has some 24 tetrahedra. A table of neighbours, which every operation would have to update, took more time.
    for (const int32_t n : star(a))
        if (n != t && has_corner(tet(n), b) && has_corner(tet(n), c))
            return n;
    return -1;
}

bool LocalMesh::is_boundary(int32_t t, int corner) const
{
    const int32_t n = neighbour(t, corner);
    return n < 0 || material(n) != material(t);
}

void LocalMesh::ring(int32_t t, int corner_a, int corner_b, EdgeRing& out) const
{
    out.a = tet(t)[corner_a];
    out.b = tet(t)[corner_b];
    auto& left = out.unordered;
    left.clear();
    for (const int32_t n : star(out.a))
        if (has_corner(tet(n), out.b))
            left.push_back(hinge(tet(n), n, out.a, out.b));
    CLEFT_ASSERT(!left.empty());
    // It begins at the hinge that no other leads to, if there is one, else at t.
    auto first = std::find_if(left.begin(), left.end(), [&](const Hinge& h) { return h.tet == t; });
    for (auto h = left.begin(); h != left.end(); ++h)
        // So an open ring is walked from one hull face to the other, and never from its middle.
        if (std::none_of(left.begin(), left.end(), [&](const Hinge& before) { return before.d == h->c; }))
            first = h;
    out.points.clear();
    out.tets.clear();
    const int32_t start = first->c;
    int32_t end = start;
    while (first != left.end()) {
        out.points.push_back(first->c);
        out.tets.push_back(first->tet);
        end = first->d;
        *first = left.back();
        left.pop_back();
        first = std::find_if(left.begin(), left.end(), [&](const Hinge& h) { return h.c == end; });
    }
    out.closed = end == start;
    const bool is_held = !out.closed && (frozen_[out.a] & frozen_[out.b] & kHeld) != 0;
    out.whole = left.empty() && !is_held;
    if (!out.closed)
        out.points.push_back(end);
}

void LocalMesh::move(int32_t v, const Vec3& to)
{
    points_[v] = to;
    if (is_measured())
        metrics_[v] = metric_at(to);
    for (const int32_t t : star(v)) {
        quality_[t] = kUnknown;
        CLEFT_ASSERT(quality(tet(t)) > 0);
    }
}

int32_t LocalMesh::add_point(const Vec3& x, uint8_t frozen)
{
    CLEFT_ASSERT(x.allFinite());
    make_room(points_);
    points_.push_back(x);
    make_room(frozen_);
    frozen_.push_back(frozen);
    stars_.add_point();
    if (is_measured()) {
        make_room(metrics_);
        metrics_.push_back(metric_at(x));
    }
    return point_count() - 1;
}

void LocalMesh::replace(const Array<int32_t>& old_tets, const Array<Tet>& new_tets,
                        const Array<Material>& new_materials, Array<int32_t>& created)
{
    reserve(old_tets, new_tets.size(), created);
    refill(old_tets, new_tets, new_materials, created, 0);
    release(old_tets, new_tets.size());
}

// The slots of the old tetrahedra come first, which keeps neighbours together. Slots follow from the operations alone,
// so numbers are the same in every run.
void LocalMesh::reserve(const Array<int32_t>& old_tets, size_t new_count, Array<int32_t>& created)
{
    created.assign(old_tets.begin(), old_tets.begin() + std::min(old_tets.count(), static_cast<int64_t>(new_count)));
    while (created.size() < new_count)
        created.push_back(take_slot());
}

void LocalMesh::refill(const Array<int32_t>& old_tets, const Array<Tet>& new_tets, const Array<Material>& new_materials,
                       const Array<int32_t>& created, int worker)
{
    CLEFT_ASSERT(new_tets.size() == new_materials.size() && new_tets.size() == created.size());
    for (const int32_t t : old_tets) {
        CLEFT_ASSERT(alive(t));
        for (const int32_t v : tet(t))
            stars_.remove(v, t);
        tets_[t][0] = -1;
    }
    for (size_t i = 0; i < new_tets.size(); ++i) {
        const int32_t t = created[i];
        tets_[t] = new_tets[i];
        quality_[t] = kUnknown;
        if (!materials_.empty())
            materials_[t] = new_materials[i];
        for (const int32_t v : new_tets[i])
            stars_.add(v, t, worker);
    }
}

void LocalMesh::release(const Array<int32_t>& old_tets, size_t new_count)
{
    for (size_t i = new_count; i < old_tets.size(); ++i)
        free_slots_.push_back(old_tets[i]);
}

int32_t LocalMesh::take_slot()
{
    if (!free_slots_.empty()) {
        const int32_t t = free_slots_.back();
        free_slots_.pop_back();
        return t;
    }
    make_room(tets_);
    tets_.push_back({-1, -1, -1, -1});  // dead until it is filled
    make_room(quality_);
    quality_.push_back(kUnknown);
    if (!materials_.empty()) {
        make_room(materials_);
        materials_.push_back(0);
    }
    return slot_count() - 1;
}

double LocalMesh::quality(const Tet& corners) const
{
    if (!is_measured())
        return shape_quality(point(corners[0]), point(corners[1]), point(corners[2]), point(corners[3]));
    return measured_quality({point(corners[0]), point(corners[1]), point(corners[2]), point(corners[3])},
                            measured_corners(corners));
}

std::array<Vec3, 4> LocalMesh::measured_corners(const Tet& corners) const
{
    std::array<Vec3, 4> x;
    Tensor logs;
    for (size_t c = 0; c < 4; ++c) {
        x[c] = point(corners[c]);
        if (is_measured())
            logs = logs + log_metric(corners[c]);
    }
    return is_measured() ? measured(x, logs) : x;
}

double LocalMesh::quality_with(int32_t t, int32_t v, const Vec3& place, const Tensor& log_there) const
{
    std::array<Vec3, 4> x;
    Tensor logs = log_there;
    for (size_t c = 0; c < 4; ++c) {
        const int32_t w = tet(t)[c];
        x[c] = w == v ? place : point(w);
        if (w != v && is_measured())
            logs = logs + log_metric(w);
    }
    return is_measured() ? measured_quality(x, measured(x, logs)) : shape_quality(x[0], x[1], x[2], x[3]);
}

void LocalMesh::qualities_with(int32_t v, const Vec3& place, Array<double>& quality) const
{
    const Tensor log_there = is_measured() ? measure_.log_at(place) : Tensor();
    quality.clear();
    for (const int32_t t : star(v))
        quality.push_back(quality_with(t, v, place, log_there));
}

double LocalMesh::worst_with(int32_t v, const Vec3& place) const
{
    const Tensor log_there = is_measured() ? measure_.log_at(place) : Tensor();
    double worst = 1;
    for (const int32_t t : star(v))
        worst = std::min(worst, quality_with(t, v, place, log_there));
    return worst;
}

double LocalMesh::quality(int32_t t) const
{
    double known = load_shared(quality_[t]);
    if (known == kUnknown) {
        known = quality(tet(t));
        store_shared(quality_[t], known);
    }
    return known;
}

void LocalMesh::find_qualities(const Run& run) const
{
    // Slots of one thread are its own, so writing qualities takes no lock.
    parallel_for(run, slot_count(), kSlotsAtOnce, [&](int64_t begin, int64_t end) {
        if (is_measured()) {
            for (auto t = static_cast<int32_t>(begin); t < end; ++t)
                if (alive(t))
                    quality(t);
            return;
        }
        Foursome four;
        for (auto t = static_cast<int32_t>(begin); t < end; ++t)
            if (alive(t) && quality_[t] == kUnknown && four.add(t, tet(t), points_))
                four.measure(quality_);
        four.measure(quality_);
    });
}

double LocalMesh::worst(const Array<int32_t>& tets) const
{
    double least = 1;
    for (const int32_t t : tets)
        least = std::min(least, quality(t));
    return least;
}

LabelledMesh LocalMesh::take(const Run& run)
{
    LabelledMesh mesh;
    const auto used = collect<int32_t>(run, point_count(), kSlotsAtOnce, [&](int64_t begin, int64_t end, auto& list) {
        for (auto v = static_cast<int32_t>(begin); v < end; ++v)
            if (!star(v).empty())
                list.push_back(v);
    });
    mesh.points = array_with_room<Vec3>(run, used.size());
    Array<int32_t> number = array_with_room<int32_t>(run, points_.size());
    parallel_for(run, used.count(), kSlotsAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            mesh.points[i] = point(used[i]);
            number[used[i]] = static_cast<int32_t>(i);
        }
    });
    parallel_for(run, slot_count(), kSlotsAtOnce, [&](int64_t begin, int64_t end) {
        for (auto t = static_cast<int32_t>(begin); t < end; ++t)
            if (alive(t))
                for (int32_t& v : tets_[t])
                    v = number[v];
    });
    remove_dead_slots();
    mesh.tets = std::move(tets_);
    mesh.material = std::move(materials_);
    return mesh;
}

// Tetrahedra move down in their own array: a second one would double the peak of memory.
void LocalMesh::remove_dead_slots()
{
    int32_t kept = 0;
    while (kept < slot_count() && alive(kept))
        ++kept;
    for (int32_t t = kept; t < slot_count(); ++t)
        if (alive(t)) {
            tets_[kept] = tets_[t];
            if (!materials_.empty())
                materials_[kept] = materials_[t];
            ++kept;
        }
    tets_.resize(kept);
    if (!materials_.empty())
        materials_.resize(kept);
}

}  // namespace cleft
