/**
 * What picking sensors meet (X3D 4.0, clause 38).
 *
 * <p>{@link org.selectiverenderer.runtime.pick.Picking} asks in every frame whether something has
 * moved since a sensor last looked; only then a {@link org.selectiverenderer.runtime.pick.Picker},
 * made of the sensor's geometry, tries the shapes below the sensor's targets that may be picked: by
 * their boxes first, then, if that is asked, by their meshes.
 *
 * <p>In: sensors, the instance tree. Out: what each sensor meets, told to the sensor. Uses {@code
 * runtime.instance}, {@code runtime.collide}, {@code runtime.nodes.pick}, {@code
 * runtime.nodes.group}, {@code runtime.scene} and {@code geometry}. Belongs to the thread that
 * steps the world.
 */
@NullMarked
package org.selectiverenderer.runtime.pick;

import org.jspecify.annotations.NullMarked;
