# Adds the sources of the methods in a room of core: those whose header a table of methods includes.
# So a method is named once, in its table.
function(espalier_methods room)
  foreach(table clean contract surface_contract skeleton colonization path shape repair radius)
    set(file ${PROJECT_SOURCE_DIR}/core/pipeline/${table}_methods.cpp)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(STRINGS ${file} includes REGEX "^#include \"core/${room}/")
    foreach(include ${includes})
      string(REGEX REPLACE ".*/([a-z0-9_]+)\\.h\"" "\\1.cpp" source ${include})
      target_sources(espalier_core PRIVATE ${source})
    endforeach()
  endforeach()
endfunction()
