/**
 * Keeps a walkthrough within a budget of triangles or milliseconds: measures the versions of the
 * scene's objects, weighs the objects in every frame as the viewer sees them, and has the
 * controller show the versions that lose least.
 *
 * <p>In: a running world, the objects that the controller lets choose, a budget. Out: choices of
 * versions. Uses {@code control} with {@code control.budget}, {@code browser} but its renderer, and
 * {@code geometry}; {@code walkthrough} uses it.
 */
@NullMarked
package org.selectiverenderer.walkthrough.budget;

import org.jspecify.annotations.NullMarked;
