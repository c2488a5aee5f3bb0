/**
 * Rules of geometry, SR2xx: indices, counts, coordinates, normals. Geometry is not tessellated for
 * these rules.
 *
 * <p>In: {@code FileContext}, whose nodes still have their coordinates. Out: findings. Uses {@code
 * validation}, {@code geometry}, {@code x3d} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.validation.geometry;

import org.jspecify.annotations.NullMarked;
