/**
 * Field values as scripts see them (ISO/IEC 19777-1; VRML97, annex C): objects such as {@code
 * SFVec3f} and {@code MFNode} with their constructors, properties and methods.
 *
 * <p>An object that stands for a field's value knows its holder: when a script changes it in place,
 * as in {@code translation_changed.x = 1}, the field has changed. Assigning copies; what a script
 * was handed as the value of an event is nobody's.
 *
 * <p>In: values as {@link org.selectiverenderer.x3d.field.FieldType} represents them, and those of
 * scripts. Out: the other. Uses Rhino, {@code runtime.scene}, {@code x3d.field}, {@code
 * x3d.catalogue} and JOML. All of it belongs to the thread that steps the world.
 */
@NullMarked
package org.selectiverenderer.runtime.script.value;

import org.jspecify.annotations.NullMarked;
