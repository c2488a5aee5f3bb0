/**
 * The behaviour of X3D node types: one class each, found through the {@link
 * org.selectiverenderer.runtime.nodes.NodeFactory}. A node type that is not listed there is kept in
 * the scene as a plain node, which keeps and passes on events.
 *
 * <p>In: events, and what a frame knows (time, viewer). Out: events. This package only knows which
 * class is whose; the classes are in
 *
 * <ul>
 *   <li>{@code group} what holds other nodes: Transform, Switch, LOD, Inline ...
 *   <li>{@code bind} what one of a kind is bound at a time: Viewpoint, NavigationInfo, Background
 *       ...
 *   <li>{@code sensor} what a frame drives: time, the viewer's place, the pointing device
 *   <li>{@code drag} what dragging with the pointing device becomes
 *   <li>{@code key} what is typed
 *   <li>{@code follow} values that follow a destination: chasers and dampers
 *   <li>{@code script} Scripts, whose programs {@code runtime.script} runs
 *   <li>{@code shader} shaders, whose programs the card runs
 *   <li>{@code geo} what is placed on the earth
 *   <li>{@code layout} what is placed and measured in the picture
 *   <li>{@code hanim} figures: skeletons and their skin
 *   <li>{@code particle} particle systems
 *   <li>{@code pick} what says which shapes a geometry meets
 *   <li>{@code shape} shapes that make their own mesh: many copies of one
 *   <li>{@code sound} clips of sound, and where they are heard
 *   <li>{@code spline} interpolators along smooth curves
 *   <li>{@code event} what answers events by events: interpolators, sequencers, triggers
 * </ul>
 *
 * <p>Uses these, {@code runtime.scene}, {@code x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes;

import org.jspecify.annotations.NullMarked;
