/**
 * The behaviour of geospatial nodes (X3D 4.0, clause 25): groups, viewpoints, sensors and
 * interpolators whose positions are geographic coordinates. {@code geometry.geo} converts these.
 *
 * <p>In and out: events, as in the packages beside it. Uses {@code runtime.nodes.bind}, {@code
 * runtime.nodes.event}, {@code runtime.nodes.group}, {@code runtime.nodes.sensor}, {@code
 * runtime.scene}, {@code geometry.geo}, {@code geometry.tessellate}, {@code x3d.catalogue} and
 * {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes.geospatial;

import org.jspecify.annotations.NullMarked;
