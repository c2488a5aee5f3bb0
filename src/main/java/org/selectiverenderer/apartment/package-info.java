/**
 * The apartment of the thesis (chapter 5): a kitchen, a lounge with a sofa sub-area, an office with
 * a desk and a bookcase sub-area, as files that a generator writes.
 *
 * <p>In: recipes ({@code kitchen}, {@code lounge}, {@code office}) and a floor plan ({@code plan}).
 * Out: {@code scenes/apartment.x3d} and what it inlines. Uses {@code modelling}, {@code schema},
 * {@code polygon} and {@code x3d}, no AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.apartment;

import org.jspecify.annotations.NullMarked;
