/**
 * A scene under the controller, and the walking of a user through it.
 *
 * <p>In: a scene file, how it is rendered, frame times and a motion. Out: a stepped world, its time
 * line, what is wrong with the scene. Uses {@code app.timeline}, {@code control}, {@code runtime}
 * but its renderer, {@code schema}, {@code x3d} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.app.walk;

import org.jspecify.annotations.NullMarked;
