/**
 * Followers: nodes whose value goes gradually to a destination (X3D 4.0, clause 39).
 *
 * <p>{@link org.selectiverenderer.runtime.nodes.follow.FollowerNode} is what all have in common;
 * {@link org.selectiverenderer.runtime.nodes.follow.ChaserResponse} and {@link
 * org.selectiverenderer.runtime.nodes.follow.DamperResponse} are the two ways to get there, over
 * the values that a {@link org.selectiverenderer.runtime.nodes.follow.FollowSpace} knows. A node
 * type is one of each.
 *
 * <p>In: destinations, frames. Out: {@code value_changed}. At rest none looks at frames. Uses
 * {@code nodes.sensor}, {@code runtime.scene}, {@code x3d.catalogue}, {@code x3d.field} and {@code
 * base.problem}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes.follow;

import org.jspecify.annotations.NullMarked;
