// The programs of a loaded pack. Copies of the list share them: switching one option leaves most
// programs of a pack as they are, and their texts are large.
#pragma once

#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace orris {

struct ProgramSource;

class ProgramList {
 public:
  using Pointer = std::shared_ptr<const ProgramSource>;

  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = ProgramSource;
    using difference_type = std::ptrdiff_t;
    using pointer = const ProgramSource*;
    using reference = const ProgramSource&;
    Iterator() = default;
    explicit Iterator(const Pointer* at) : at_(at) {}
    reference operator*() const { return **at_; }
    pointer operator->() const { return at_->get(); }
    Iterator& operator++() { return ++at_, *this; }
    Iterator operator++(int) { return Iterator(at_++); }
    bool operator==(const Iterator&) const = default;

   private:
    const Pointer* at_ = nullptr;
  };

  void push_back(Pointer program) { programs_.push_back(std::move(program)); }
  std::size_t size() const { return programs_.size(); }
  bool empty() const { return programs_.empty(); }
  const ProgramSource& operator[](std::size_t index) const { return *programs_[index]; }
  const ProgramSource& at(std::size_t index) const { return *programs_.at(index); }
  const Pointer& share(std::size_t index) const { return programs_[index]; }
  Iterator begin() const { return Iterator(programs_.data()); }
  Iterator end() const { return Iterator(programs_.data() + programs_.size()); }
  /// -1 for a program that is not of this list.
  int indexOf(const ProgramSource* program) const {
    for (std::size_t i = 0; i < programs_.size(); ++i) {
      if (programs_[i].get() == program) return static_cast<int>(i);
    }
    return -1;
  }

 private:
  std::vector<Pointer> programs_;
};

}  // namespace orris
