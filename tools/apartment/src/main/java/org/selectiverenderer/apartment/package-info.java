/**
 * The generator of the thesis's apartment (chapter 5): a kitchen, a lounge with a sofa sub-area, an
 * office with a desk and a bookcase sub-area, as X3D files.
 *
 * <p>In: recipes ({@code kitchen}, {@code lounge}, {@code office}, {@code furniture}), the rooms
 * ({@code frame}), what covers them and is outside ({@code pictures}), a floor plan ({@code plan})
 * and what the thesis says of the objects ({@code facts}). Out: the files of {@code versions} and
 * {@code scene}: {@code scenes/apartment.x3d} and what it inlines. Uses {@code modelling}, {@code
 * geometry.mesh} and {@code base.files}; the packages within also {@code polygon}, {@code schema}
 * and {@code x3d}. No AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.apartment;

import org.jspecify.annotations.NullMarked;
