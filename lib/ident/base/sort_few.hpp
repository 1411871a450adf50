// Sorting in place where a few elements are all there is.
#pragma once

#include <algorithm>

namespace ident {

/// Least first; equal ones may change places. std::sort would want two kilobytes of
/// stack. Cost: a comparison for each pair.
template <class Iterator, class Less>
void sort_few(Iterator begin, Iterator end, Less less) {
  for (; begin != end; ++begin) {
    std::iter_swap(begin, std::min_element(begin, end, less));
  }
}

}  // namespace ident
