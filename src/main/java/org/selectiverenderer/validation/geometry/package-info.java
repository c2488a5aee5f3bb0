/**
 * Rules of geometry, SR2xx: indices, counts, coordinates, normals. In: {@code FileView}, whose
 * nodes still have their coordinates; nothing is tessellated. Uses {@code validation} and {@code
 * x3d}.
 */
@NullMarked
package org.selectiverenderer.validation.geometry;

import org.jspecify.annotations.NullMarked;
