#include "core/io/qsm/qsm.h"

#include "core/base/text.h"
#include "core/skeleton/axes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace espalier {
namespace {

class Builder {
public:
  Builder(const Qsm& qsm, const std::string& file) : qsm_(qsm), file_(file) {}

  Imported<Skeleton> build() {
    if (qsm_.cylinders.empty())
      throw ShownError(
          {espalier::Shown::tr("holds no cylinders: export it again"), {}, FilePlace{file_}});
    for (std::size_t i = 0; i < qsm_.cylinders.size(); ++i)
      check(i);
    link();
    addNodes();
    addNotes();
    return std::move(result_);
  }

private:
  using Place = std::array<double, 3>;

  /// @param sentence  with %1 for the number of the cylinder, then %2 ... for the values
  [[noreturn]] void fail(std::size_t i, const char* sentence,
                         std::vector<std::string> values = {}) const {
    FilePlace where{file_};
    if (const std::size_t line = qsm_.cylinders[i].line; line > 0) where.line = line;
    values.insert(values.begin(), std::to_string(i + 1));
    throw ShownError({sentence, std::move(values), std::move(where)});
  }

  void check(std::size_t i) const {
    const QsmCylinder& cylinder = qsm_.cylinders[i];
    if (!cylinder.start.allFinite() || !cylinder.end.allFinite() ||
        !std::isfinite(cylinder.radius) || !std::isfinite(cylinder.startRadius.value_or(0)))
      fail(i, espalier::Shown::tr("cylinder %1 has a value that is not finite"));
    if (cylinder.radius < 0 || cylinder.startRadius.value_or(0) < 0)
      fail(i, espalier::Shown::tr("cylinder %1 has a negative radius"));
    if (cylinder.parent > qsm_.cylinders.size())
      fail(i,
           espalier::Shown::tr("cylinder %1 is attached to cylinder %2, and there are %3: the "
                               "table is cut short or damaged"),
           {std::to_string(cylinder.parent), std::to_string(qsm_.cylinders.size())});
  }

  void link() {
    children_.resize(qsm_.cylinders.size() + 1);
    for (std::size_t i = 0; i < qsm_.cylinders.size(); ++i)
      children_[qsm_.cylinders[i].parent].push_back(i + 1);
  }

  void addNodes() {
    std::vector<std::size_t> order;
    std::vector<std::optional<NodeId>> nodes(qsm_.cylinders.size() + 1);
    for (const std::size_t root : children_[0]) {
      nodes[root] = addRootCylinder(root);
      order.push_back(root);
    }
    for (std::size_t next = 0; next < order.size(); ++next)
      for (const std::size_t child : children_[order[next]]) {
        nodes[child] = add(child, *nodes[order[next]], edgeOf(child, order[next]));
        order.push_back(child);
      }
    for (std::size_t i = 0; i < qsm_.cylinders.size(); ++i)
      if (!nodes[i + 1])
        fail(i, espalier::Shown::tr("cylinder %1 is among its own ancestors: correct its parent"));
  }

  NodeId add(std::size_t number, NodeId parent, EdgeType edge) {
    const QsmCylinder& cylinder = qsm_.cylinders[number - 1];
    return result_.value.add({cylinder.end, cylinder.radius, parent, edge});
  }

  NodeId addRootCylinder(std::size_t number) {
    const QsmCylinder& cylinder = qsm_.cylinders[number - 1];
    const Place start = {cylinder.start.x(), cylinder.start.y(), cylinder.start.z()};
    if (cylinder.start == cylinder.end && !cylinder.startRadius)
      return result_.value.add({cylinder.start, cylinder.radius, std::nullopt});
    const auto [root, isNew] = roots_.emplace(start, NodeId{});
    if (isNew)
      root->second = result_.value.add(
          {cylinder.start, cylinder.startRadius.value_or(cylinder.radius), std::nullopt});
    const bool continues = qsm_.hasOrders ? cylinder.order == 0 : isNew;
    return add(number, root->second, continues ? EdgeType::successor : EdgeType::branching);
  }

  EdgeType edgeOf(std::size_t number, std::size_t parent) {
    const QsmCylinder& child = qsm_.cylinders[number - 1];
    const QsmCylinder& carrier = qsm_.cylinders[parent - 1];
    const double gap = (child.start - carrier.end).norm();
    if (gap > carrier.radius) {
      ++distant_;
      widestGap_ = std::max(widestGap_, gap);
    }
    bool continues = children_[parent].front() == number;
    if (qsm_.hasExtensions)
      continues = carrier.extension == number;
    else if (qsm_.hasBranches)
      continues = carrier.branch == child.branch;
    return continues ? EdgeType::successor : EdgeType::branching;
  }

  void addNotes() {
    if (!qsm_.hasExtensions && !qsm_.hasBranches)
      note({espalier::Shown::tr(
          "does not say which cylinder continues another: the first in the file is taken")});
    if (distant_ > 0)
      note({distant_ == 1
                ? espalier::Shown::tr(
                      "1 cylinder begins farther than its radius from the end of the one that "
                      "bears it, by up to %2; the edge begins at that end nevertheless")
                : espalier::Shown::tr(
                      "%1 cylinders begin farther than its radius from the end of the one that "
                      "bears it, by up to %2; the edge begins at that end nevertheless"),
            {std::to_string(distant_), plainDecimal(widestGap_)}});
    std::size_t astray = 0;
    for (std::size_t i = 0; i < qsm_.cylinders.size(); ++i) {
      const std::uint32_t extension = qsm_.cylinders[i].extension;
      if (extension > qsm_.cylinders.size() ||
          (extension > 0 && qsm_.cylinders[extension - 1].parent != i + 1))
        ++astray;
    }
    if (astray > 0)
      note({astray == 1
                ? espalier::Shown::tr("1 extension is a cylinder that is not attached to the one "
                                      "it should extend, and is passed over")
                : espalier::Shown::tr("%1 extensions are cylinders that are not attached to the "
                                      "ones they should extend, and are passed over"),
            {std::to_string(astray)}});
  }
  void note(ShownMessage what) {
    what.where = FilePlace{file_};
    result_.notes.push_back(std::move(what));
  }

  const Qsm& qsm_;
  const std::string& file_;
  Imported<Skeleton> result_;
  std::vector<std::vector<std::size_t>> children_; // by number; those without a parent under 0
  std::map<Place, NodeId> roots_;
  std::size_t distant_ = 0;
  double widestGap_ = 0; // [L]
};

} // namespace

Eigen::Vector3d qsmEnd(const Eigen::Vector3d& start, const Eigen::Vector3d& axis, double length) {
  const double norm = axis.norm();
  return norm > 0 ? Eigen::Vector3d(start + axis * (length / norm)) : start;
}

Imported<Skeleton> skeletonOf(const Qsm& qsm, const std::string& file) {
  return Builder(qsm, file).build();
}

Qsm qsmOf(const Skeleton& skeleton) {
  Qsm qsm{.cylinders = {}, .hasExtensions = true, .hasBranches = true, .hasOrders = true};
  const std::vector<int> order = orders(skeleton);
  std::vector<std::uint32_t> numbers(skeleton.idEnd()); // cylinders by node; 0: none
  std::uint32_t branch = 0;
  for (const Axis& axis : axes(skeleton)) {
    ++branch;
    std::uint32_t previous = 0;
    for (const NodeId id : axis) {
      const Node& node = skeleton[id];
      if (!node.parent) {
        if (skeleton.children(id).empty()) // a node alone
          qsm.cylinders.push_back({.radius = node.radius,
                                   .start = node.position,
                                   .end = node.position,
                                   .branch = branch});
        continue;
      }
      const Node& parent = skeleton[*node.parent];
      QsmCylinder cylinder{.radius = node.radius, .start = parent.position, .end = node.position};
      cylinder.parent = numbers[indexOf(*node.parent)];
      cylinder.branch = branch;
      cylinder.order = static_cast<std::uint32_t>(order[indexOf(id)]);
      cylinder.startRadius = parent.radius;
      qsm.cylinders.push_back(cylinder);
      numbers[indexOf(id)] = static_cast<std::uint32_t>(qsm.cylinders.size());
      if (previous > 0) qsm.cylinders[previous - 1].extension = numbers[indexOf(id)];
      previous = numbers[indexOf(id)];
    }
  }
  return qsm;
}

} // namespace espalier
