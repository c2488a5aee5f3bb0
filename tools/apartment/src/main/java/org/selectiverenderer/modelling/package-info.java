/**
 * A toolkit for parametric solid modelling: solids (lathe, sweep, loft, extrusion with bevels) as
 * functions to closed triangle meshes, materials, exact polygon counts, and one X3D file per model.
 *
 * <p>Frame: metres, y up. Boxes, cylinders, lathes and plates stand on y = 0 and are centred on x
 * and z; balls and rings are centred on the origin. Triangles go counter-clockwise seen from
 * outside. A polygon is a triangle.
 *
 * <p>The same call gives the same bits on every machine: sines and cosines come from {@link
 * org.selectiverenderer.geometry.DegreeMath}, never from {@link java.lang.Math}.
 *
 * <p>In: dimensions. Out: {@link org.selectiverenderer.modelling.ParametricModel}s and X3D text.
 * Uses {@code geometry}, with its fonts for the outlines of letters, {@code x3d.write} and {@code
 * base.decimal}; no AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.modelling;

import org.jspecify.annotations.NullMarked;
