#pragma once

#include <npsee/fragments.h>

#include <vector>

namespace npsee::fragments {

/// Makes closed shells of triangles in any state: equal points become one, facets that meet along an edge are turned one way and belong
/// together (where more than two meet, those with the same inside), holes are closed with torn facets, what is inside out is turned. Shells
/// that enclose nothing are left out, so there may be none.
std::vector<Solid> shellsOf(Solid surface);

/// Facets that are joined by edges, each group as a surface of its own, in the order of their first facets.
std::vector<Solid> joinedParts(const Solid& surface);

}  // namespace npsee::fragments
