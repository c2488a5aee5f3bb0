/**
 * The apartment's scenes as X3D text: rooms, objects as Switches of Inlines, sensors, metadata
 * (thesis Figs 73 to 78), lights, viewpoints; the practice scene; the recorded walk.
 *
 * <p>In: placed objects and what the thesis says of them. Out: text, the same every time. Uses
 * {@code apartment.facts}, {@code apartment.building}, {@code apartment.textures}, {@code
 * apartment.plan}, {@code modelling}, {@code schema}, {@code geometry}, {@code x3d.write} and
 * {@code base.decimal}.
 */
@NullMarked
package org.selectiverenderer.apartment.scene;

import org.jspecify.annotations.NullMarked;
