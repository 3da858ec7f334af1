// What theory says of the propagation: with y = I^gamma the published rule is the linear diffusion
// y' = (alpha/6)^gamma * sum of the open neighbours' y, here in doubles.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <vector>

namespace orris::test {

struct Rule {
  double alpha = 2.43902, gamma = 2.2;
  /// Gain of one step in a uniform field where `open` neighbours are open.
  double gain(int open) const;
  /// Gain in the middle of an n^3 room with black walls, whose slowest shape is a product of sines.
  double roomGain(int n) const;
  /// The same between the walls of an endless corridor n x n wide.
  double corridorGain(int n) const;
};

/// A cube of cells, dark and open at first; beyond it all is dark.
class LinearField {
 public:
  explicit LinearField(int size, Rule rule = {});
  /// Light of the open cells.
  void fill(const std::function<double(glm::ivec3)>& light);
  void setSolid(glm::ivec3 cell) { kinds_[index(cell)] = Kind::Solid; }
  void setLamp(glm::ivec3 cell, double light);
  void removeLamp(glm::ivec3 cell) { kinds_[index(cell)] = Kind::Open; }
  void step(int count = 1);
  double at(glm::ivec3 cell) const;  ///< light; 0 in solid cells
  double brightest() const;
  int size() const { return size_; }

 private:
  enum class Kind : char { Open, Solid, Lamp };
  size_t index(glm::ivec3 cell) const;
  double power(glm::ivec3 cell) const;

  int size_;
  Rule rule_;
  std::vector<double> powers_;
  std::vector<Kind> kinds_;
};

/// Calls `use` for every cell of a cube.
void forEachCell(int size, const std::function<void(glm::ivec3)>& use);

}  // namespace orris::test
