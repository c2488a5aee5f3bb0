/**
 * The two versions of an object: the recipe refined to the polygon count of the thesis's table, and
 * its reduction by the polygon count process (thesis 4.2).
 *
 * <p>In: a {@link org.selectiverenderer.modelling.ParametricModel} and two counts. Out: files'
 * text. Uses {@code modelling}, {@code polygon}, {@code geometry.mesh}, {@code x3d} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.apartment.versions;

import org.jspecify.annotations.NullMarked;
