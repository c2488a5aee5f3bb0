/**
 * Script nodes of a running scene: their input events go to the programs that {@code
 * runtime.script} runs.
 *
 * <p>In: events. Out: calls of a program. Uses {@code runtime.scene} and {@code x3d}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes.script;

import org.jspecify.annotations.NullMarked;
