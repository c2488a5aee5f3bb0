/**
 * Repairs of geometry that the validator finds faulty: normals are normalized, faces without area
 * are taken out; and equal points, which {@link
 * org.selectiverenderer.authoring.geometry.RepeatedPointsCheck} finds, are welded. Only the numbers
 * concerned change.
 *
 * <p>In: an element of a document. Out: edits. Uses {@code authoring}, {@code geometry}, {@code
 * x3d} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.authoring.geometry;

import org.jspecify.annotations.NullMarked;
