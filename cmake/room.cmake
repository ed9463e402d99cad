# espalier_rooms(TARGET FOLDER...): the sources of a room are those in its folder. They are compiled in
# groups (19 s for 14 files of core/mtg, one by one 34 s): so names in the unnamed namespaces of one
# room are unique. With -DCMAKE_UNITY_BUILD=OFF each file is compiled by itself, as packaging/lint
# reads it.
function(espalier_rooms target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  foreach(folder IN LISTS ARGN)
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp ${folder}/*.h)
    target_sources(${target} PRIVATE ${sources})
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    string(MAKE_C_IDENTIFIER ${folder} room)
    set(group 0)
    while(sources)
      list(SUBLIST sources 0 14 together)
      list(REMOVE_ITEM sources ${together})
      set_source_files_properties(${together} PROPERTIES UNITY_GROUP ${room}_${group})
      math(EXPR group "${group} + 1")
    endwhile()
  endforeach()
endfunction()
