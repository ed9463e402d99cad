# cmake -DSOURCE=FOLDER -DVERSION=0.1.0 -DOUTPUT=FOLDER -P version.cmake writes which version this is
# into files of OUTPUT, where it changed: the one of the project at its tag ("0.1.0"), else with the
# time and name of the commit, which sorts before it ("0.1.0~20261126.1720.g9204e9d") until it is
# tagged, and behind it later ("0.1.0+20261201.0930.gd5c1e2f"); ".changed" if sources are not as they
# were committed. Without git, the one of the project.
set(ESPALIER_VERSION ${VERSION})
set(ESPALIER_RELEASE stable)
set(ENV{TZ} UTC)
find_program(GIT git)

function(ask_git output)
  execute_process(COMMAND ${GIT} -C ${SOURCE} ${ARGN}
    RESULT_VARIABLE status OUTPUT_VARIABLE answer ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT status EQUAL 0)
    set(answer "")
  endif()
  set(${output} "${answer}" PARENT_SCOPE)
endfunction()

if(GIT)
  ask_git(top rev-parse --show-toplevel)
  file(REAL_PATH ${SOURCE} source)
endif()
if(top AND top STREQUAL source) # and not the repository of another, around it
  ask_git(commit log -1 --abbrev=7 --format=%cd.g%h --date=format-local:%Y%m%d.%H%M)
  ask_git(date log -1 --format=%cd --date=format-local:%Y-%m-%d)
  ask_git(time log -1 --format=%cD)
  ask_git(isTagged describe --exact-match --tags --match v${VERSION})
  ask_git(isReleased tag --list v${VERSION})
  ask_git(changes status --porcelain --untracked-files=no)
  if(NOT isTagged)
    set(ESPALIER_RELEASE development)
    string(APPEND ESPALIER_VERSION "~${commit}")
    if(isReleased)
      string(REPLACE "~" "+" ESPALIER_VERSION "${ESPALIER_VERSION}")
    endif()
  endif()
  if(changes)
    string(APPEND ESPALIER_VERSION ".changed")
  endif()
else() # as old as the newest that is said of it
  file(TIMESTAMP ${SOURCE}/CHANGELOG.md date "%Y-%m-%d" UTC)
  file(TIMESTAMP ${SOURCE}/CHANGELOG.md time "%a, %d %b %Y %H:%M:%S +0000" UTC)
endif()
set(ESPALIER_DATE ${date})
set(ESPALIER_TIME ${time})

configure_file(${SOURCE}/app/about/version.cpp.in ${OUTPUT}/version.cpp @ONLY)
configure_file(${SOURCE}/packaging/desktop/org.espalier.Espalier.metainfo.xml.in
  ${OUTPUT}/org.espalier.Espalier.metainfo.xml @ONLY)
configure_file(${SOURCE}/packaging/debian/changelog.in ${OUTPUT}/changelog.Debian @ONLY)
file(CONFIGURE OUTPUT ${OUTPUT}/version.txt CONTENT "${ESPALIER_VERSION}\n")
