/**
 * Places on the earth (X3D 4.0, clause 25): geodetic, UTM and geocentric coordinates on the
 * standard's ellipsoids, and where they lie in a scene.
 *
 * <p>In: coordinates as geospatial nodes give them, in the order of their {@code geoSystem}. Out:
 * metres in double precision, geocentric or, with a GeoOrigin, about that. Scene coordinates of
 * nodes without an origin are geocentric; what is drawn is kept as floats about a point of its own
 * ({@code geometry.tessellate.GeoAnchor}), so that nothing trembles.
 *
 * <p>Uses {@code x3d.catalogue} and JOML.
 */
@NullMarked
package org.selectiverenderer.geometry.geo;

import org.jspecify.annotations.NullMarked;
