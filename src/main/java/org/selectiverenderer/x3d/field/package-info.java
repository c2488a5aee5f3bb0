/**
 * The values of fields: their types, and text that is turned into them. Values are the plain Java
 * values that {@link org.selectiverenderer.x3d.field.FieldType} lists ({@code float[]} for MFVec3f,
 * and so on). They are shared, never copied, and nobody writes into an array that was handed over.
 *
 * <p>In: the text of a field. Out: its value, or what is wrong with the text. Uses {@code
 * base.problem} and FastDoubleParser.
 */
@NullMarked
package org.selectiverenderer.x3d.field;

import org.jspecify.annotations.NullMarked;
