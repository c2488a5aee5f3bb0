/**
 * The best versions for a budget: which version of each object to show, so that the loss of quality
 * is least while the triangles, or the milliseconds of a frame, stay within a budget.
 *
 * <p>It is a multiple-choice knapsack problem: of each object exactly one version, each with a cost
 * in triangles and a loss. {@link org.selectiverenderer.control.budget.MultipleChoiceKnapsack}
 * solves it from frame to frame; {@link org.selectiverenderer.control.budget.VersionLoss} says what
 * a version loses; {@link org.selectiverenderer.control.budget.FrameTimeRegulator} turns
 * milliseconds into triangles.
 *
 * <p>In: costs, losses and weights as numbers. Out: the number of a version for each object. Pure
 * arithmetic without a browser; uses no other package of the program.
 */
@NullMarked
package org.selectiverenderer.control.budget;

import org.jspecify.annotations.NullMarked;
