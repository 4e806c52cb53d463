#pragma once
#include <Eigen/Core>
#include <cmath>

namespace app::hands {

/// Critically damped low pass of second order for ways that come in jerks: all that goes in comes out, a little later.
template <int n>
class Smooth {
  public:
    using Vector = Eigen::Matrix<double, n, 1>;

    /// Puts in a way, in any unit.
    void add(const Vector& way) { left_ += way; }
    /// What comes out in the next `seconds`, by a time constant of `tau` [s]; 0: all at once. Exactly zero once it has
    /// come to rest.
    Vector next(double seconds, double tau) {
        if (left_.isZero(0) && speed_.isZero(0)) return Vector::Zero();
        const Vector before = left_;
        constexpr double unseen = 1e-6;  // of a pixel or a notch
        if (tau <= 0 || (left_.cwiseAbs().maxCoeff() < unseen && speed_.cwiseAbs().maxCoeff() * tau < unseen)) {
            drop();
            return before;
        }
        const double decay = std::exp(-seconds / tau);
        const Vector rise = speed_ + left_ / tau;  // of the exact solution (left + rise t) e^(-t / tau)
        left_ = (left_ + rise * seconds) * decay;
        speed_ = (speed_ - rise * (seconds / tau)) * decay;
        return before - left_;
    }
    /// Forgets what has not come out.
    void drop() { left_.setZero(), speed_.setZero(); }

  private:
    Vector left_ = Vector::Zero(), speed_ = Vector::Zero();  // what has not come out, and its rate
};

}  // namespace app::hands
