/**
 * Tries shader programs of scenes in a child process before this process compiles them. A graphics
 * driver compiles what it is given within the process that asks, without limits: macros or
 * functions that double forty times take all memory, loops run without end, and a fault of the
 * driver ends the process.
 *
 * <p>{@link org.selectiverenderer.render.trial.ShaderTrialProcess} starts the child, gives it the
 * texts, and limits its time and memory; {@link org.selectiverenderer.render.trial.ShaderTrialMain}
 * is the child's main class. Uses {@code base.platform}, {@code render.gpu}, {@code render.glsl},
 * {@code render.context} and JOGL.
 */
@NullMarked
package org.selectiverenderer.render.trial;

import org.jspecify.annotations.NullMarked;
