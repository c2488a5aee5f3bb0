/**
 * The floor plan: rooms, walls, and where the objects stand (thesis Figs 55, 65, 74).
 *
 * <p>Frame: metres, x to the east, y up, z to the south; the floor is y = 0 here and {@link
 * org.selectiverenderer.apartment.plan.Room#FLOOR} in the world. In: models. Out: their positions.
 * Uses {@code modelling}, {@code geometry}, {@code geometry.mesh} and {@code base.decimal}.
 */
@NullMarked
package org.selectiverenderer.apartment.plan;

import org.jspecify.annotations.NullMarked;
