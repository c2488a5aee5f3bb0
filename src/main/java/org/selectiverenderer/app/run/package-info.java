/**
 * The run loop. A {@link org.selectiverenderer.app.run.SceneRun} is one frame after the other:
 * input, then {@code World.step} with the controller in it, then a picture, then what is recorded
 * of it. Windows, pictures without a window, {@code simulate} and the steps of a session all go
 * through it; what differs are its parts:
 *
 * <ul>
 *   <li>the destination of its frames: a {@link org.selectiverenderer.app.run.FrameTarget}, which
 *       calls it once for each frame;
 *   <li>its timing: a {@link org.selectiverenderer.app.clock.TimingMode};
 *   <li>its guide: a {@link org.selectiverenderer.app.run.RunController}, the user or the step of a
 *       session;
 *   <li>its listener: a {@link org.selectiverenderer.app.run.RunListener}.
 * </ul>
 *
 * <p>A run goes through the states of {@link org.selectiverenderer.app.run.SceneRun.State}, in that
 * order.
 *
 * <p>In: {@link org.selectiverenderer.app.settings.RunSettings}. Out: frames, a time line, a head
 * log, figures, the last pictures. Uses all of {@code app} but {@code session} and {@code sai},
 * {@code hmd}, {@code tracker}, {@code browser} with its renderer and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.app.run;

import org.jspecify.annotations.NullMarked;
