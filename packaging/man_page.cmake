# cmake -DPROGRAM=FILE -DOUTPUT=FILE -P man_page.cmake: writes the manual page of the program from
# what its --help and those of its subcommands say.
function(ask output)
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\\" "\\e" text "${text}")
  string(REPLACE "-" "\\-" text "${text}")
  string(REGEX REPLACE "(^|\n)([.'])" "\\1\\\\&\\2" text "${text}")
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

ask(version --version)
string(REGEX REPLACE "[^ ]+ ([^\n]*)\n" "\\1" version "${version}")
ask(help --help)
set(page ".TH ESPALIER 1 \"\" \"Espalier ${version}\" \"User Commands\"
.SH NAME
espalier \\- from a laser scan of a plant to its skeleton
.SH SYNOPSIS
.B espalier
[\\fIFILE\\fR ...]
.br
.B espalier
\\fISUBCOMMAND\\fR [\\fIOPTION\\fR ...]
.SH DESCRIPTION
Without a subcommand it opens the editor, on the files given. With one it needs no display.
.PP
.nf
${help}.fi
.SH SUBCOMMANDS
")
string(REGEX MATCHALL "\n  [a-z]+  " names "${help}")
foreach(name IN LISTS names)
  string(STRIP "${name}" name)
  ask(text ${name} --help)
  string(APPEND page ".SS ${name}\n.nf\n${text}.fi\n")
endforeach()
file(WRITE ${OUTPUT} "${page}")
