# The one place where warnings are chosen; they are errors in every preset.
add_library(espalier_warnings INTERFACE)
add_library(espalier::warnings ALIAS espalier_warnings)
target_compile_options(espalier_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Wold-style-cast
  -Woverloaded-virtual -Wunused -Wno-sign-conversion -Wno-missing-field-initializers -Werror)
