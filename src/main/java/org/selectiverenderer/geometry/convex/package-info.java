/**
 * Convex bodies and whether two of them meet.
 *
 * <p>In: boxes, balls, cylinders, cones, and points whose hull is meant. Out: yes or no. A body is
 * only asked which of its points lies farthest in a direction. Uses nothing of ours.
 */
@NullMarked
package org.selectiverenderer.geometry.convex;

import org.jspecify.annotations.NullMarked;
