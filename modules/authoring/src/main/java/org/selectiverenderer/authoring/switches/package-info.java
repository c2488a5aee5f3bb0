/**
 * Edits of Switches: wrapping a node in a Switch, adding, removing and reordering its choices, and
 * unwrapping it. The metadata of a choice moves with the choice, and the initially shown choice
 * stays shown.
 *
 * <p>In: a document, a Switch or a node. Out: edits, not yet performed. Uses {@code authoring},
 * {@code authoring.enrichment}, {@code authoring.nodes}, {@code authoring.structure} and {@code
 * x3d}.
 */
@NullMarked
package org.selectiverenderer.authoring.switches;

import org.jspecify.annotations.NullMarked;
