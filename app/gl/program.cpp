#include "app/gl/program.h"

#include "app/gl/shader_sources.h"

#include <algorithm>
#include <string>
#include <utility>

namespace npsee::gl {
namespace {

constexpr int kMaxIncludeDepth = 4;

const ShaderSource* findSource(std::string_view name) {
  for (const ShaderSource& source : shaderSources())
    if (source.name == name) return &source;
  return nullptr;
}

/// Text of a shader file with its include lines replaced.
Expected<std::string> expanded(std::string_view name, int depth = 0) {
  const ShaderSource* source = findSource(name);
  if (source == nullptr || depth > kMaxIncludeDepth)
    return fail(ErrorKind::graphics, "the program holds no shader " + std::string(name) + ".", "Build npsee anew; its build is incomplete.");
  constexpr std::string_view kInclude = "#include \"";
  std::string out;
  std::string_view rest = source->text;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    if (!line.starts_with(kInclude)) {
      out.append(line).append(1, '\n');
      continue;
    }
    const std::string_view file = line.substr(kInclude.size(), line.rfind('"') - kInclude.size());
    auto inner = expanded(file, depth + 1);
    if (!inner) return inner;
    out += *inner;
  }
  return out;
}

std::string logOf(GLuint object, bool program) {
  char log[2048] = {};
  GLsizei length = 0;
  if (program) glGetProgramInfoLog(object, sizeof log, &length, log);
  else glGetShaderInfoLog(object, sizeof log, &length, log);
  std::string text(log, static_cast<std::size_t>(length));
  while (!text.empty() && (text.back() == '\n' || text.back() == '\0')) text.pop_back();
  // One message is one line.
  std::ranges::replace(text, '\n', ';');
  return text;
}

constexpr const char* kRemedy = "The driver has to offer OpenGL 3.3 core; LIBGL_ALWAYS_SOFTWARE=1 selects Mesa's software driver.";

Expected<GLuint> compileShader(GLenum type, std::string_view file) {
  auto text = expanded(file);
  if (!text) return tl::unexpected<Error>(text.error());
  // Mesa remembers by its text alone that a shader compiled, and believes it also where that text now is the wrong kind of shader;
  // it then fails while linking, on memory it has freed. A mark for each kind keeps them apart.
  *text += type == GL_VERTEX_SHADER ? "// vertex\n" : "// fragment\n";
  const GLuint shader = glCreateShader(type);
  const char* data = text->data();
  const GLint length = static_cast<GLint>(text->size());
  glShaderSource(shader, 1, &data, &length);
  glCompileShader(shader);
  GLint done = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done == GL_TRUE) return shader;
  const std::string log = logOf(shader, false);
  glDeleteShader(shader);
  return fail(ErrorKind::graphics, "shader " + std::string(file) + " does not compile: " + log, kRemedy);
}

}  // namespace

Expected<Program> Program::fromFiles(std::string_view vertex_file, std::string_view fragment_file) {
  const auto vertex = compileShader(GL_VERTEX_SHADER, vertex_file);
  if (!vertex) return tl::unexpected<Error>(vertex.error());
  const auto fragment = compileShader(GL_FRAGMENT_SHADER, fragment_file);
  if (!fragment) {
    glDeleteShader(*vertex);
    return tl::unexpected<Error>(fragment.error());
  }
  Program out;
  out.name_ = glCreateProgram();
  glAttachShader(out.name_, *vertex);
  glAttachShader(out.name_, *fragment);
  glLinkProgram(out.name_);
  // Marked for deletion; they live as long as the program.
  glDeleteShader(*vertex);
  glDeleteShader(*fragment);
  GLint done = GL_FALSE;
  glGetProgramiv(out.name_, GL_LINK_STATUS, &done);
  if (done != GL_TRUE)
    return fail(ErrorKind::graphics, "shaders " + std::string(vertex_file) + " and " + std::string(fragment_file) + " do not link: " + logOf(out.name_, true), kRemedy);
  return out;
}

Expected<void> Program::load(std::string_view vertex_file, std::string_view fragment_file) {
  auto program = fromFiles(vertex_file, fragment_file);
  if (!program) return tl::unexpected<Error>(program.error());
  *this = std::move(*program);
  return {};
}

Program::~Program() {
  if (name_ != 0) glDeleteProgram(name_);
}
Program::Program(Program&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
Program& Program::operator=(Program&& other) noexcept {
  std::swap(name_, other.name_);
  return *this;
}

void Program::set(const char* uniform, int value) const { glUniform1i(glGetUniformLocation(name_, uniform), value); }
void Program::set(const char* uniform, float value) const { glUniform1f(glGetUniformLocation(name_, uniform), value); }
void Program::set(const char* uniform, float x, float y) const { glUniform2f(glGetUniformLocation(name_, uniform), x, y); }
void Program::set(const char* uniform, float x, float y, float z) const { glUniform3f(glGetUniformLocation(name_, uniform), x, y, z); }
void Program::set(const char* uniform, float x, float y, float z, float w) const { glUniform4f(glGetUniformLocation(name_, uniform), x, y, z, w); }
void Program::setMatrix(const char* uniform, const float (&column_major)[16]) const {
  glUniformMatrix4fv(glGetUniformLocation(name_, uniform), 1, GL_FALSE, column_major);
}

}  // namespace npsee::gl
