/**
 * Placement of nodes: moving, turning and scaling them, aligning and distributing several, grouping
 * and ungrouping.
 *
 * <p>{@link org.selectiverenderer.authoring.placement.Placement} says which Transform places a
 * node, or that a new one has to be put around it; {@link
 * org.selectiverenderer.authoring.placement.TransformPose} are the five fields of a Transform and
 * what moves, turns and scales them; {@link
 * org.selectiverenderer.authoring.placement.PlacementEdits} writes a pose with few decimals, {@link
 * org.selectiverenderer.authoring.placement.PoseField} reads what an author types of one, {@link
 * org.selectiverenderer.authoring.placement.Arrangement} computes where aligned and distributed
 * boxes go, {@link org.selectiverenderer.authoring.placement.GroupEdits} groups and ungroups.
 *
 * <p>In: a document, nodes, and the bounds that a running scene has found for them. Out: edits, not
 * yet performed. Uses {@code authoring}, {@code authoring.area}, {@code authoring.nodes}, {@code
 * x3d} and {@code geometry}.
 */
@NullMarked
package org.selectiverenderer.authoring.placement;

import org.jspecify.annotations.NullMarked;
