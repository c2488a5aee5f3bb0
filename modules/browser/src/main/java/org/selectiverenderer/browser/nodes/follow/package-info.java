/**
 * Followers: nodes whose value gradually approaches a destination (X3D 4.0, clause 39).
 *
 * <p>{@link org.selectiverenderer.browser.nodes.follow.FollowerNode} is the common base class;
 * {@link org.selectiverenderer.browser.nodes.follow.ChaserResponse} and {@link
 * org.selectiverenderer.browser.nodes.follow.DamperResponse} are the two kinds of response, which
 * compute in a {@link org.selectiverenderer.browser.nodes.follow.FollowerValueSpace}. A node type
 * combines a response with a value space.
 *
 * <p>In: destinations, frames. Out: {@code value_changed}. At rest a follower is not updated per
 * frame. Uses {@code nodes.sensor}, {@code browser.scene}, {@code x3d.catalogue}, {@code x3d.field}
 * and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.follow;

import org.jspecify.annotations.NullMarked;
