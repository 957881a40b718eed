#include "renderer/methods/methods.h"

// THE list. The order is the order of tables and reports: the reference first, since every error is measured
// against it.
#define PLUME_METHODS(X) \
  X(reference)           \
  X(linked_list)         \
  X(tile_sorted)         \
  X(peel)                \
  X(peel_dual)           \
  X(sorted)              \
  X(kbuffer)             \
  X(abuffer)             \
  X(adaptive)            \
  X(aoit)                \
  X(mlab)                \
  X(stochastic)          \
  X(wboit)               \
  X(coloured)            \
  X(phenomenological)    \
  X(moments)             \
  X(wavelets)            \
  X(fourier)             \
  X(vboit)               \
  X(avboit)

namespace plume {

#define PLUME_DECLARE(id) std::unique_ptr<Method> make_##id();
PLUME_METHODS(PLUME_DECLARE)
#undef PLUME_DECLARE

std::unique_ptr<Method> make_method(std::string_view id) {
#define PLUME_MAKE(name) \
  if (id == #name) return make_##name();
  PLUME_METHODS(PLUME_MAKE)
#undef PLUME_MAKE
  return nullptr;
}

std::vector<std::string> method_ids() {
#define PLUME_NAME(id) #id,
  return {PLUME_METHODS(PLUME_NAME)};
#undef PLUME_NAME
}

}  // namespace plume
