/**
 * The texts of new scenes: an empty one, and a room with floor, walls, light and viewpoint.
 *
 * <p>In: sizes in metres. Out: X3D 4.0 in XML. Uses {@code base.decimal} and {@code base.markup}.
 */
@NullMarked
package org.selectiverenderer.authoring.creation;

import org.jspecify.annotations.NullMarked;
