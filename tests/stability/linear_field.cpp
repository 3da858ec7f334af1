#include "linear_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orris::test {

double Rule::gain(int open) const { return alpha / 6 * std::pow(open, 1 / gamma); }

double Rule::roomGain(int n) const {
  return alpha / 6 * std::pow(6 * std::cos(std::numbers::pi / (n + 1)), 1 / gamma);
}

double Rule::corridorGain(int n) const {
  return alpha / 6 * std::pow(2 + 4 * std::cos(std::numbers::pi / (n + 1)), 1 / gamma);
}

LinearField::LinearField(int size, Rule rule)
    : size_(size), rule_(rule), powers_(size * size * size), kinds_(powers_.size(), Kind::Open) {}

size_t LinearField::index(glm::ivec3 cell) const {
  return (static_cast<size_t>(cell.y) * size_ + cell.z) * size_ + cell.x;
}

double LinearField::power(glm::ivec3 cell) const {
  const auto outside = [this](int i) { return i < 0 || i >= size_; };
  if (outside(cell.x) || outside(cell.y) || outside(cell.z)) return 0;
  return kinds_[index(cell)] == Kind::Solid ? 0 : powers_[index(cell)];
}

void LinearField::fill(const std::function<double(glm::ivec3)>& light) {
  forEachCell(size_, [&](glm::ivec3 cell) {
    if (kinds_[index(cell)] == Kind::Open)
      powers_[index(cell)] = std::pow(light(cell), rule_.gamma);
  });
}

void LinearField::setLamp(glm::ivec3 cell, double light) {
  kinds_[index(cell)] = Kind::Lamp;
  powers_[index(cell)] = std::pow(light, rule_.gamma);
}

void LinearField::step(int count) {
  const double share = std::pow(rule_.alpha / 6, rule_.gamma);
  for (; count > 0; --count) {
    std::vector<double> next = powers_;
    forEachCell(size_, [&](glm::ivec3 c) {
      if (kinds_[index(c)] != Kind::Open) return;
      double sum = 0;
      for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 offset(0);
        offset[axis] = 1;
        sum += power(c + offset) + power(c - offset);
      }
      next[index(c)] = share * sum;
    });
    powers_ = std::move(next);
  }
}

double LinearField::at(glm::ivec3 cell) const { return std::pow(power(cell), 1 / rule_.gamma); }

double LinearField::brightest() const {
  return std::pow(*std::max_element(powers_.begin(), powers_.end()), 1 / rule_.gamma);
}

void forEachCell(int size, const std::function<void(glm::ivec3)>& use) {
  for (int y = 0; y < size; ++y)
    for (int z = 0; z < size; ++z)
      for (int x = 0; x < size; ++x) use({x, y, z});
}

}  // namespace orris::test
