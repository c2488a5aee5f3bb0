/**
 * The behaviour of geospatial nodes (X3D 4.0, clause 25): groups, viewpoints, sensors and
 * interpolators whose positions are geographic coordinates. {@code x3d.geodesy} converts these.
 *
 * <p>In and out: events, as in the packages beside it. Uses {@code browser.nodes.bindable}, {@code
 * browser.nodes.event}, {@code browser.nodes.group}, {@code browser.nodes.sensor}, {@code
 * browser.scene}, {@code x3d.geodesy}, {@code x3d.tessellate}, {@code x3d.catalogue} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.geospatial;

import org.jspecify.annotations.NullMarked;
