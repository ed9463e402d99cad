# Names the sources of a room. They are compiled in groups, which from nothing takes a third of the
# time: so names in the unnamed namespaces of one room are unique. With -DCMAKE_UNITY_BUILD=OFF each
# file is compiled by itself, as packaging/lint reads it.
function(espalier_room target)
  target_sources(${target} PRIVATE ${ARGN})
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  file(RELATIVE_PATH room ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  string(REPLACE "/" "_" room ${room})
  set(atOnce 14)
  set(sources ${ARGN})
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(SORT sources)
  set(group 0)
  while(sources)
    list(SUBLIST sources 0 ${atOnce} together)
    set_source_files_properties(${together} TARGET_DIRECTORY ${target}
      PROPERTIES UNITY_GROUP ${room}_${group})
    list(REMOVE_ITEM sources ${together})
    math(EXPR group "${group} + 1")
  endwhile()
endfunction()
