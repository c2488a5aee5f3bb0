/**
 * Bindable nodes, of which one of a kind is bound at a time, and the binding stacks (X3D 4.0,
 * 7.2.2).
 *
 * <p>In: set_bind, added and removed nodes. Out: the bound Viewpoint, NavigationInfo and
 * backgrounds. Uses {@code browser.nodes.group}, {@code browser.scene}, {@code x3d.catalogue} and
 * {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.bindable;

import org.jspecify.annotations.NullMarked;
