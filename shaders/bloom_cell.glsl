// Mean of what is too bright over a cell, and a mark that it was taken; beyond the picture it is dark.
void main() {
  ivec2 corner = ivec2(gl_FragCoord.xy) * u_cell, last = min(corner + u_cell - 1, ivec2(u_last));
  vec3 sum = vec3(0.0);
  for (int y = corner.y; y <= last.y; ++y)
    for (int x = corner.x; x <= last.x; ++x) sum += tooBright(sceneAt(ivec2(x, y)));
  o_colour = vec4(sum / float(u_cell * u_cell), 1.0);
}
