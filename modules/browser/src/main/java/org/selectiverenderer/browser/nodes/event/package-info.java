/**
 * Nodes that answer an event with another event: interpolators, sequencers, filters and triggers
 * (X3D 4.0, clauses 19 and 30).
 *
 * <p>In: events. Out: events of the same time stamp. Uses {@code browser.scene}, {@code
 * x3d.catalogue}, {@code x3d.field} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.event;

import org.jspecify.annotations.NullMarked;
