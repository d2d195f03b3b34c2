# Writes the text of shaders into a C file: name.ext becomes shader_name_ext.
#   cmake -DOUT=shaders.c -DFILES=a.vert,b.frag -P embed.cmake
# SPDX-License-Identifier: MIT
string(REPLACE "," ";" FILES "${FILES}")
set(text "/* Made by embed.cmake. */\n#include \"shaders.h\"\n")
foreach(file IN LISTS FILES)
    get_filename_component(name "${file}" NAME)
    string(REPLACE "." "_" name "${name}")
    file(READ "${file}" bytes HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
    string(APPEND text "const char shader_${name}[] = {${bytes}0};\n")
endforeach()
file(WRITE "${OUT}" "${text}")
