/**
 * Versions of an object in a scene: the step of thesis 4.2 that replaces an object by a Switch of
 * Inlines.
 *
 * <p>In: a scene's file, an object's DEF name, goals. Out: a plan of what would be written, and the
 * files. Uses {@code polygon.model}, {@code polygon.simplify} and {@code x3d}.
 */
@NullMarked
package org.selectiverenderer.polygon.versions;

import org.jspecify.annotations.NullMarked;
