/**
 * Recipes of the furniture that makes the rooms look lived in, beside the objects of the thesis's
 * tables. Each class makes one piece in one version, with few polygons: a function of nothing to a
 * {@link org.selectiverenderer.modelling.ParametricModel} in metres that is centred on x and shows
 * its front to +z. What stands is on y = 0 and centred on z; what hangs on a wall has its back at z
 * = 0.
 *
 * <p>No piece is of a kind that the experiment's recognition lists ask for, neither one that the
 * rooms have nor one that they have not: no second book or lamp to read by, no armchair, no coat
 * stand. Uses {@code apartment.looks}, {@code apartment.pictures}, {@code modelling}, {@code
 * geometry} and {@code geometry.mesh}.
 */
@NullMarked
package org.selectiverenderer.apartment.furniture;

import org.jspecify.annotations.NullMarked;
