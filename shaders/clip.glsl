// What lies on the other side of the ground than the eye is cut off; the ground itself is painted behind everything.
uniform vec2 u_clip;  // x: 1 keeps what is above, -1 what is below, 0 everything; y: ground height, world m
uniform float u_ground;  // ground height at the burst, world m
uniform vec2 u_slope;    // its rise per metre along x and z: a burst on a hillside lies on a plane
uniform float u_fade;    // 1: soft forms fade towards the ground

float groundUnder(vec2 place) { return u_ground + dot(u_slope, place); }

float clipDistance(float y) { return u_clip.x == 0.0 ? 1.0 : u_clip.x * (y - u_clip.y); }
