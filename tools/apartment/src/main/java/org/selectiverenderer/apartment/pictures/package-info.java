/**
 * Pictures that cover surfaces of the apartment, and what is seen out of its windows: computed from
 * formulas and numbered noise, pixel by pixel, the same on every machine.
 *
 * <p>A surface's picture is a tile: its right edge goes on at its left, its upper at its lower. Its
 * mean share of light is what a plain colour of the same surface throws back, so that a room is as
 * bright with it as without. Frame: pixels from the upper left corner; formulas take metres of the
 * surface, x to the right and y up.
 *
 * <p>In: nothing. Out: {@link org.selectiverenderer.apartment.pictures.SurfacePicture}s by file
 * name. Uses {@code base.picture}.
 */
@NullMarked
package org.selectiverenderer.apartment.pictures;

import org.jspecify.annotations.NullMarked;
