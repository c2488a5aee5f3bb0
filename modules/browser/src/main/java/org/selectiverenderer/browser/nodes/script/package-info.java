/**
 * Script nodes of a running scene: their input events go to the programs that {@code
 * browser.script} runs.
 *
 * <p>In: events. Out: calls of a program. Uses {@code browser.scene} and {@code x3d}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.script;

import org.jspecify.annotations.NullMarked;
