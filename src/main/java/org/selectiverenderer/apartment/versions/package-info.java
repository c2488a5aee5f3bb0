/**
 * The two versions of an object: the recipe brought to the table's polygons, and what the polygon
 * count process (thesis 4.2) makes of it.
 *
 * <p>In: a {@link org.selectiverenderer.modelling.Model} and two counts. Out: files' text. Uses
 * {@code modelling}, {@code polygon} and {@code x3d}.
 */
@NullMarked
package org.selectiverenderer.apartment.versions;

import org.jspecify.annotations.NullMarked;
