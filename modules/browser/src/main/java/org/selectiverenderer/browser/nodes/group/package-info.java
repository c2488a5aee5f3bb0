/**
 * Grouping nodes: they hold other nodes and decide which of them are shown and where (X3D 4.0,
 * clauses 10 and 23).
 *
 * <p>In: events. Out: children, transformations. Uses {@code browser.scene}, {@code
 * x3d.tessellate}, {@code x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.group;

import org.jspecify.annotations.NullMarked;
