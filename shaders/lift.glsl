// The simulator's particles are points that rest at the height of the ground. What is drawn has a size, so it is lifted
// until its lowest corner is at most slightly in the soil.
uniform vec3 u_hull[8];        // corners of the form at size 1
uniform int u_hull_count;      // 0: a ball
uniform float u_lift_limit;    // largest lift as a fraction of the size

// Lift in metres for a particle at a height above the ground; up is the world's up direction seen from the body.
float liftOf(float above, float size, vec3 up) {
  float reach = u_hull_count == 0 ? 0.5 : 0.0;
  for (int i = 0; i < u_hull_count; ++i) reach = max(reach, -dot(up, u_hull[i]));
  float wanted = min(reach, u_lift_limit) * size;
  // Particles that sink through the ground (no collision) lose their lift as they go, without a jump.
  return above >= 0.0 ? max(wanted - above, 0.0) : max(wanted + above, 0.0);
}

// Second row of the rotation matrix: the world's up in body coordinates.
vec3 upInBody(vec4 q) {
  return vec3(2.0 * (q.x * q.y + q.w * q.z), 1.0 - 2.0 * (q.x * q.x + q.z * q.z), 2.0 * (q.y * q.z - q.w * q.x));
}
