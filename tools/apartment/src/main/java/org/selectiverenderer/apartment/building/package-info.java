/**
 * The building elements of the rooms, which the thesis calls frame objects (5.2): walls, floors,
 * ceilings, doors, windows, skirting, light switches, lamps.
 *
 * <p>In: the floor plan. Out: one model per room, in the room's own coordinates (see {@code plan}).
 * Uses {@code apartment.plan}, {@code apartment.textures}, {@code modelling}, {@code
 * geometry.mesh}, {@code x3d.write}, {@code base.decimal} and {@code formats.image}.
 */
@NullMarked
package org.selectiverenderer.apartment.building;

import org.jspecify.annotations.NullMarked;
