/**
 * Field types, and the parser of field values. Values are plain Java values as listed in {@link
 * org.selectiverenderer.x3d.field.FieldType} ({@code float[]} for MFVec3f, and so on). Arrays are
 * shared, not copied, and must not be modified; a node may keep a large one as a {@link
 * org.selectiverenderer.x3d.field.PackedArray}.
 *
 * <p>In: the text of a field. Out: its value, and the errors in the text. Uses {@code base.problem}
 * and FastDoubleParser.
 */
@NullMarked
package org.selectiverenderer.x3d.field;

import org.jspecify.annotations.NullMarked;
