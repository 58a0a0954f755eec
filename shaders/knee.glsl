// Light above this rolls off, and spreads: of what a picture shows as white, linear.
const float kKnee = 0.80;
