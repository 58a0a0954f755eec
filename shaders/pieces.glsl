// Where the corners of a model's pieces are. All pieces lie in one buffer; their states are read by their numbers.
layout(location = 0) in vec3 a_position;  // piece, m, relative to its centre of mass
layout(location = 1) in vec3 a_normal;    // piece
layout(location = 2) in vec4 a_colour;    // sRGB-coded; w: 0 its own, 1 the layer's, 2 an inner face that was torn
layout(location = 3) in float a_piece;

uniform samplerBuffer u_states;  // four texels each: place in world m and scale; colour and opacity; body to world; velocity in world m/s and temperature, K
uniform int u_state;             // of the only piece drawn; -1: each its own

struct Placed {
  vec3 place, normal, centre, velocity;  // world
  vec4 colour;                           // the layer's, sRGB-coded, and opacity
  float scale;                           // 0 = not there
  float temperature;                     // K
};

Placed placedCorner() {
  int state = 4 * (u_state < 0 ? int(a_piece + 0.5) : u_state);
  vec4 at = texelFetch(u_states, state);
  vec4 q = texelFetch(u_states, state + 2);
  Placed out_corner;
  out_corner.centre = at.xyz;
  out_corner.scale = at.w;
  out_corner.colour = texelFetch(u_states, state + 1);
  vec4 moving = texelFetch(u_states, state + 3);
  out_corner.velocity = moving.xyz;
  out_corner.temperature = moving.w;
  out_corner.normal = rotated(q, a_normal);
  out_corner.place = at.xyz + at.w * rotated(q, a_position);
  return out_corner;
}
