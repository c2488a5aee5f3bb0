/**
 * When and how the versions of objects give way to others, as the viewer sees them.
 *
 * <p>In: a stepped world and a {@link org.selectiverenderer.schema.SwitchTransition}. Out: whether
 * a Switch may change now, what is seen of the change, and the cross-fades of the world's instance
 * tree. All of it follows from the world alone, without a picture, so that runs with and without
 * rendering decide alike. Uses {@code control}, {@code schema}, {@code geometry.mesh} and of {@code
 * browser} the world, its layers, cameras, instances and rays.
 */
@NullMarked
package org.selectiverenderer.walkthrough.transition;

import org.jspecify.annotations.NullMarked;
