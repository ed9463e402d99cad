# The one place where warnings are chosen; they are errors in every preset.
add_library(espalier_warnings INTERFACE)
add_library(espalier::warnings ALIAS espalier_warnings)
# Without -Wmaybe-uninitialized: GCC 12 takes the empty part of a std::optional for a mistake when it
# optimizes or instruments much (GCC bug 80635). Clang does not know that name.
target_compile_options(espalier_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Wold-style-cast
  -Woverloaded-virtual -Wunused -Wno-sign-conversion -Wno-missing-field-initializers -Werror
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
  # Files that are compiled together are included, and private types of theirs are taken for those of
  # a header.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wno-subobject-linkage>)
