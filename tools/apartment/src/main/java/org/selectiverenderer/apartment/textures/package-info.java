/**
 * Procedural textures of the apartment's surfaces and of the landscape outside its windows:
 * computed pixel by pixel from formulas and seeded noise, the same on every machine.
 *
 * <p>A surface's texture is a seamless tile: its right edge continues at its left, its upper edge
 * at its lower. Its mean reflectance is that of the plain colour of the same surface, so that a
 * room is as bright with textures as without. Frame: pixels from the upper left corner; formulas
 * take metres of the surface, x to the right and y up.
 *
 * <p>In: nothing. Out: {@link org.selectiverenderer.apartment.textures.TextureImage}s by file name.
 * Uses {@code formats.image}.
 */
@NullMarked
package org.selectiverenderer.apartment.textures;

import org.jspecify.annotations.NullMarked;
