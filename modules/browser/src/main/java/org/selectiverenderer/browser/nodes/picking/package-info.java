/**
 * Pick sensors (X3D 4.0, clause 38): nodes that report the shapes that a geometry of theirs
 * intersects.
 *
 * <p>In: fields, and what {@code browser.picking} found. Out: events. Uses {@code browser.scene},
 * {@code x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.picking;

import org.jspecify.annotations.NullMarked;
