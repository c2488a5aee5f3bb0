/**
 * Interpolators along splines: those of X3D 4.0, 19.4.9 to 19.4.12, and of the NURBS component
 * (27.4).
 *
 * <p>In: fractions. Out: values. Uses {@code browser.nodes.event}, {@code browser.scene}, {@code
 * geometry.nurbs}, {@code x3d.tessellate}, {@code x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.spline;

import org.jspecify.annotations.NullMarked;
