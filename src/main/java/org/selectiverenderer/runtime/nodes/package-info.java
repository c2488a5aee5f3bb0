/**
 * The behaviour of X3D node types: one class each, found through the {@link
 * org.selectiverenderer.runtime.nodes.NodeFactory}. A node type that is not listed there is kept in
 * the scene as a plain node.
 *
 * <p>In: events, and what a frame knows (time, viewer). Out: events. Uses {@code x3d} and {@code
 * runtime.scene}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes;

import org.jspecify.annotations.NullMarked;
