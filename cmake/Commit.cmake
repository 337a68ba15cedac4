# Writes OUTPUT, the definition of vigil::client::commit() (src/client/measure/commit.h), if it says something new. Run at every
# build: a new commit compiles one small file and links again, and nothing else.
execute_process(COMMAND git --git-dir=${SOURCE}/.git --work-tree=${SOURCE} describe --always --dirty --abbrev=12
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed OR commit STREQUAL "")
  set(commit "unknown")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT
"#include \"client/measure/commit.h\"

namespace vigil::client {

std::string_view commit() {
    return \"${commit}\";
}

} // namespace vigil::client
")
