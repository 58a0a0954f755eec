# Turns the shader files into one C++ source, so that the program runs from anywhere.
# Called at build time: cmake -DOUT=FILE "-DFILES=A;B" -P EmbedShaders.cmake
set(text "#include \"app/gl/shader_sources.h\"\n\nnamespace npsee::gl {\nnamespace {\nconstexpr ShaderSource kSources[] = {\n")
foreach(file IN LISTS FILES)
  get_filename_component(name "${file}" NAME)
  file(READ "${file}" source)
  string(APPEND text "{\"${name}\", R\"glsl(${source})glsl\"},\n")
endforeach()
string(APPEND text "};\n}  // namespace\n\nstd::span<const ShaderSource> shaderSources() { return kSources; }\n\n}  // namespace npsee::gl\n")
file(WRITE "${OUT}" "${text}")
