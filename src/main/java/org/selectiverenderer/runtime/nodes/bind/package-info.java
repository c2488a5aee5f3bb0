/**
 * Nodes of which one of a kind is bound at a time, and the stacks of the bound ones (X3D 4.0,
 * 7.2.2).
 *
 * <p>In: set_bind, scenes that come and go. Out: the bound Viewpoint, NavigationInfo and
 * backgrounds. Uses {@code runtime.nodes.group}, {@code runtime.scene}, {@code x3d.catalogue} and
 * {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes.bind;

import org.jspecify.annotations.NullMarked;
