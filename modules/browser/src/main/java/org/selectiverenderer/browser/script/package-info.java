/**
 * Runs the ECMAScript programs of Script nodes (X3D 4.0, clause 29; ISO/IEC 19777-1; VRML97, annex
 * C).
 *
 * <p>{@link org.selectiverenderer.browser.script.ScriptScheduler} schedules the Scripts of a world.
 * Each becomes a {@link org.selectiverenderer.browser.script.RunningScript} with a global scope of
 * its own ({@link org.selectiverenderer.browser.script.ScriptScope}: the node's fields); all share
 * one {@link org.selectiverenderer.browser.script.RhinoEngine}: Rhino with the standard objects,
 * those of {@code value}, and {@code Browser}. The engine is made for the first Script of a world;
 * a world without Scripts never loads Rhino.
 *
 * <p>Scripts are sandboxed: they can access the scene, but no Java classes, no files except those
 * that their scene may name, and no network. Time, memory and depth of a call are limited, as
 * {@code docs/scripts.md} describes.
 *
 * <p>In: events that Scripts receive, frames. Out: events into the cascade, problems. The values
 * that a function assigns are sent when it has ended. Uses Rhino, {@code browser.nodes.script},
 * {@code browser.loading}, {@code browser.scene}, {@code x3d} and {@code base.problem}. All of it
 * belongs to the thread that steps the world.
 */
@NullMarked
package org.selectiverenderer.browser.script;

import org.jspecify.annotations.NullMarked;
