/**
 * Script nodes of a running scene: what they receive goes to the program that {@code
 * runtime.script} runs for them.
 *
 * <p>In: events. Out: calls of a program. Uses {@code runtime.scene} and {@code x3d}.
 */
@NullMarked
package org.selectiverenderer.runtime.nodes.script;

import org.jspecify.annotations.NullMarked;
