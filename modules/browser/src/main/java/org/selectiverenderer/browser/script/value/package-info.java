/**
 * Field values as scripts see them (ISO/IEC 19777-1; VRML97, annex C): objects such as {@code
 * SFVec3f} and {@code MFNode} with their constructors, properties and methods.
 *
 * <p>An object that stands for a field's value has an owner: when a script changes it in place, as
 * in {@code translation_changed.x = 1}, the field has changed. That takes the same short time
 * whatever the size of the value, which is taken from the object when it is sent. Assignment copies
 * the value; the value of an event that a script receives has no owner.
 *
 * <p>In and out: values as {@link org.selectiverenderer.x3d.field.FieldType} represents them, and
 * those of scripts. Uses Rhino, {@code browser.scene}, {@code x3d.field}, {@code x3d.catalogue} and
 * JOML. All of it belongs to the thread that steps the world.
 */
@NullMarked
package org.selectiverenderer.browser.script.value;

import org.jspecify.annotations.NullMarked;
