/**
 * Recipes of the furniture that makes the rooms look lived in, beside the objects of the thesis's
 * tables. Each class builds one piece in one version, with few polygons: a {@link
 * org.selectiverenderer.modelling.ParametricModel} in metres that is centred on x and shows its
 * front to +z. Pieces that stand are on y = 0 and centred on z; pieces that hang on a wall have
 * their back at z = 0.
 *
 * <p>No piece is of a kind that the experiment's recognition lists ask for, whether the rooms have
 * it or not: no second book or reading lamp, no armchair, no coat stand. Uses {@code
 * apartment.materials}, {@code apartment.textures}, {@code modelling}, {@code geometry} and {@code
 * geometry.mesh}.
 */
@NullMarked
package org.selectiverenderer.apartment.furniture;

import org.jspecify.annotations.NullMarked;
