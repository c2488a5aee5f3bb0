/**
 * A toolkit for parametric models: forms as functions to closed triangle meshes, looks, exact
 * polygon counts, and one X3D file per model.
 *
 * <p>Frame: metres, y up. Boxes, cylinders, lathes and plates stand on y = 0 and are centred on x
 * and z; balls and rings are centred on the origin. Triangles go counter-clockwise seen from
 * outside. A polygon is a triangle.
 *
 * <p>The same call gives the same bits on every machine: sines and cosines come from {@link
 * org.selectiverenderer.modelling.Degrees}, never from {@link java.lang.Math}.
 *
 * <p>In: numbers. Out: {@link org.selectiverenderer.modelling.Model}s and X3D text. Uses {@code
 * x3d.geometry} for the outlines of letters, nothing else of the other packages, no AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.modelling;

import org.jspecify.annotations.NullMarked;
