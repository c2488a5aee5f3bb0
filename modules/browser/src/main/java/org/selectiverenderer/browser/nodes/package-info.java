/**
 * The behaviour of X3D node types: one class each, found through the {@link
 * org.selectiverenderer.browser.nodes.NodeFactory}. A node type without such a class is represented
 * by a plain node, which stores and forwards events.
 *
 * <p>In: events, and the state of a frame (time, viewer). Out: events. This package only maps node
 * types to classes; the classes are in
 *
 * <ul>
 *   <li>{@code group} grouping nodes: Transform, Switch, LOD, Inline ...
 *   <li>{@code bind} bindable nodes: Viewpoint, NavigationInfo, Background ...
 *   <li>{@code sensor} sensors that each frame updates: of time, of the viewer's position, of the
 *       pointing device
 *   <li>{@code drag} drag sensors
 *   <li>{@code key} key device sensors
 *   <li>{@code follow} values that follow a destination: chasers and dampers
 *   <li>{@code script} Scripts, whose programs {@code browser.script} runs
 *   <li>{@code shader} shaders, whose programs the GPU runs
 *   <li>{@code geo} geospatial nodes
 *   <li>{@code layout} nodes whose layout depends on the picture
 *   <li>{@code hanim} humanoids: skeletons and their skin
 *   <li>{@code particle} particle systems
 *   <li>{@code pick} pick sensors
 *   <li>{@code shape} instanced shapes and generated cube maps
 *   <li>{@code sound} sounds and movies
 *   <li>{@code spline} interpolators along splines
 *   <li>{@code event} interpolators, sequencers, filters and triggers
 * </ul>
 *
 * <p>Uses these, {@code browser.scene}, {@code x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes;

import org.jspecify.annotations.NullMarked;
