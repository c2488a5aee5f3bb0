/**
 * Runs the programs of Scripts in ECMAScript (X3D 4.0, clause 29; ISO/IEC 19777-1; VRML97, annex
 * C).
 *
 * <p>{@link org.selectiverenderer.runtime.script.Scripts} has the Scripts of a world. Each becomes
 * a {@code RunningScript} with globals of its own ({@code ScriptScope}: the node's fields), which
 * all share one {@code Engine}: Rhino with the standard objects, those of {@code value}, and {@code
 * Browser}. The engine is made for the first Script of a world; a world without any never loads
 * Rhino.
 *
 * <p>A script reaches the scene and nothing else: no Java, no files but those that its scene may
 * name, no network. Time, memory and depth of a call are limited; {@code docs/scripts.md} says how.
 *
 * <p>In: events that Scripts receive, frames. Out: events into the cascade, problems. What a
 * function assigns is sent when it has ended. Uses Rhino, {@code runtime.nodes.script}, {@code
 * runtime.loading}, {@code runtime.scene}, {@code x3d} and {@code base.problem}. All of it belongs
 * to the thread that steps the world.
 */
@NullMarked
package org.selectiverenderer.runtime.script;

import org.jspecify.annotations.NullMarked;
