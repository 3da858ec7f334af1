// page.html, which the build puts into the library.
#pragma once

#include <string_view>

namespace orris {

/// With "/*CHART*/" where the data belong.
extern const std::string_view kPageTemplate;

}  // namespace orris
