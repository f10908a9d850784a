// Finds the tangent of a tie from the gradients of its indicator functions, and projects trial positions back onto it.
#include "improving/tie_constraint.hpp"

#include "volume/tie.hpp"

namespace cleft
{

void TieConstraint::set(const LocalMesh& mesh, const Array<int32_t>& tets, const Vec3& x, const Vec3& home,
                        uint8_t frozen, double reach, double tolerance)
{
    const auto materials = materials_of(tets, mesh.materials());
    too_many_ = !materials;
    materials_ = materials.value_or(MaterialSet());
    home_ = home;
    frozen_ = frozen;
    reach_ = reach;
    tolerance_ = tolerance;
    tangent_ = free_axes(frozen);
    // With a tolerance the point may leave its tie, so the directions across it stay free.
    if (is_at_interface() && tolerance == 0)
        find_tangent(x);
}

// Takes the gradients of the differences of the indicators out of the free directions, one after the other.
void TieConstraint::find_tangent(const Vec3& x)
{
    // Three equations leave no direction: the point of four materials stays.
    if (too_many_ || materials_.size() > 3) {
        tangent_.setZero();
        return;
    }
    volume_.sample_gradient(x, samples_);
    const auto gradient = [&](Material m) {
        const int i = samples_.find(m);
        return i < 0 ? Vec3(0, 0, 0) : samples_.gradient[i];
    };
    for (int i = 1; i < materials_.size(); ++i) {
        const Vec3 difference = gradient(materials_[i]) - gradient(materials_[0]);
        const Vec3 normal = tangent_ * difference;
        // The two ties hardly cross, or the wall runs along the tie. The direction between them would be rounding
        // error.
        if (!(normal.norm() > 1e-3 * difference.norm())) {
            tangent_.setZero();
            return;
        }
        tangent_ -= normal.normalized() * normal.normalized().transpose();
    }
}

bool TieConstraint::project(Vec3& x)
{
    if (!is_at_interface())
        return true;
    // A tie further away than half of an edge belongs to another part of the interface.
    const auto on_tie =
        too_many_ ? std::nullopt : project_to_tie(volume_, x, x, materials_, frozen_, 0.5 * reach_, samples_);
    // Without a tolerance no place off the tie is taken: interfaces must not drift pass by pass.
    if (!on_tie && tolerance_ == 0)
        return false;
    const Vec3 middle = on_tie.value_or(home_);
    const double distance = (x - middle).norm();
    if (distance > tolerance_)
        x = middle + (tolerance_ / distance) * (x - middle);
    return true;
}

}  // namespace cleft
