/**
 * Geospatial coordinates (X3D 4.0, clause 25): conversion between geodetic, UTM and geocentric
 * coordinates on the standard's ellipsoids and scene coordinates.
 *
 * <p>In: coordinates as geospatial nodes give them, in the order of their {@code geoSystem}. Out:
 * metres in double precision, geocentric or, with a GeoOrigin, relative to it. Meshes are stored in
 * floats relative to a local origin, since geocentric floats would be too coarse and make the
 * picture jitter.
 *
 * <p>Uses {@code x3d.catalogue} and JOML.
 */
@NullMarked
package org.selectiverenderer.x3d.geodesy;

import org.jspecify.annotations.NullMarked;
