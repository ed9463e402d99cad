# The sources of a room are those in its folder. They are compiled in groups (19 s for 14 files of
# core/mtg, one by one 34 s): so names in the unnamed namespaces of one room are unique. With
# -DCMAKE_UNITY_BUILD=OFF each file is compiled by itself, as packaging/lint reads it.
function(espalier_room target)
  file(GLOB sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.cpp *.h)
  target_sources(${target} PRIVATE ${sources})
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  file(RELATIVE_PATH room ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  string(REPLACE "/" "_" room ${room})
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  set(group 0)
  while(sources)
    list(SUBLIST sources 0 14 together)
    set_source_files_properties(${together} TARGET_DIRECTORY ${target}
      PROPERTIES UNITY_GROUP ${room}_${group})
    list(REMOVE_ITEM sources ${together})
    math(EXPR group "${group} + 1")
  endwhile()
endfunction()
