/**
 * Repairs of geometry that the validator finds faulty: normals are normalized, faces without area
 * are taken out. Only the numbers concerned change.
 *
 * <p>In: an element of a document. Out: edits. Uses {@code authoring}, {@code geometry}, {@code
 * x3d} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.authoring.geometry;

import org.jspecify.annotations.NullMarked;
