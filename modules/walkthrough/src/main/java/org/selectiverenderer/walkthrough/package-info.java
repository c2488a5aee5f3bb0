/**
 * A loaded scene with its selective controller, and the user's navigation in it.
 *
 * <p>In: a scene file, the rendering settings, frame times and a motion. Out: a stepped world, its
 * time line, the problems of the scene. Uses {@code walkthrough.timeline}, {@code
 * walkthrough.budget}, {@code control}, {@code browser} but its renderer, {@code schema}, {@code
 * x3d} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.walkthrough;

import org.jspecify.annotations.NullMarked;
