#include "core/surface/envelopes/least_at.h"

#include <utility>

namespace espalier {
namespace {

struct Vertex {
  Eigen::VectorXd at;
  double value;
};

/// A simplex, its best vertex first.
class Simplex {
public:
  Simplex(const std::function<double(const Eigen::VectorXd&)>& function,
          const Eigen::VectorXd& start, const Eigen::VectorXd& steps)
      : function_(function), steps_(steps) {
    add(start);
    for (Eigen::Index i = 0; i < start.size(); ++i)
      add(start + steps[i] * Eigen::VectorXd::Unit(start.size(), i));
    sort();
  }

  [[nodiscard]] const Eigen::VectorXd& best() const { return vertices_.front().at; }
  [[nodiscard]] int evaluations() const { return evaluations_; }

  [[nodiscard]] bool isSmall() const {
    for (const Vertex& vertex : vertices_)
      if (((vertex.at - best()).array() / steps_.array()).abs().maxCoeff() > 1e-7) return false;
    return true;
  }

  void step() {
    Vertex& worst = vertices_.back();
    Eigen::VectorXd middle = Eigen::VectorXd::Zero(worst.at.size());
    for (std::size_t i = 0; i + 1 < vertices_.size(); ++i)
      middle += vertices_[i].at / static_cast<double>(vertices_.size() - 1);
    const auto along = [&](double factor) { return seen(middle + factor * (worst.at - middle)); };
    const Vertex reflected = along(-1);
    if (reflected.value < vertices_.front().value) {
      const Vertex stretched = along(-2);
      worst = stretched.value < reflected.value ? stretched : reflected;
    } else if (reflected.value < vertices_[vertices_.size() - 2].value)
      worst = reflected;
    else {
      const Vertex drawn = along(reflected.value < worst.value ? -0.5 : 0.5);
      if (drawn.value < std::min(worst.value, reflected.value))
        worst = drawn;
      else
        shrink();
    }
    sort();
  }

private:
  [[nodiscard]] Vertex seen(const Eigen::VectorXd& at) {
    ++evaluations_;
    return {at, function_(at)};
  }
  void add(const Eigen::VectorXd& at) { vertices_.push_back(seen(at)); }
  void sort() { std::ranges::stable_sort(vertices_, {}, &Vertex::value); }
  void shrink() {
    for (std::size_t i = 1; i < vertices_.size(); ++i)
      vertices_[i] = seen((vertices_[i].at + best()) / 2);
  }

  const std::function<double(const Eigen::VectorXd&)>& function_;
  Eigen::VectorXd steps_;
  std::vector<Vertex> vertices_;
  int evaluations_ = 0;
};

} // namespace

Eigen::VectorXd leastAt(const std::function<double(const Eigen::VectorXd&)>& function,
                        const Eigen::VectorXd& start, const Eigen::VectorXd& steps, int most,
                        const Progress& progress) {
  Simplex simplex(function, start, steps);
  while (!simplex.isSmall() && simplex.evaluations() < most) {
    progress.check();
    simplex.step();
  }
  return simplex.best();
}

} // namespace espalier
