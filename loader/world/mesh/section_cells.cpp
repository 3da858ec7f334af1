#include <orris/world/mesh/section_cells.h>

namespace orris {

SectionCells::SectionCells(const BlockWorld& blocks, glm::ivec3 origin) : origin_(origin) {
  for (int y = -1; y <= kSectionSize; ++y)
    for (int z = -1; z <= kSectionSize; ++z)
      for (int x = -1; x <= kSectionSize; ++x)
        states_[cellAt({x, y, z})] = std::uint16_t(blocks.indexAt(origin + glm::ivec3(x, y, z)));
}

}  // namespace orris
