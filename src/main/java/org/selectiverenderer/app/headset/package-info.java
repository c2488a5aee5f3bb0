/**
 * The headset of a run: passes the poses, eyes, input and events of {@code openxr} to the tracker,
 * the renderer, the navigation and the listener of the run.
 *
 * <pre>
 *   openxr.XrHeadset --pose--> tracker.pipeline.{@code HeadsetPoseTracker} --> hmd.TrackedMotion (in the step)
 *                    --eyes--> hmd.HeadsetLayout --> render.headset (both pictures)
 *                    --input-> HeadsetControllers --> walking, commands, answers
 *                    --news--> the run's listener: messages, time line, a session's journal
 * </pre>
 *
 * <p>{@link org.selectiverenderer.app.headset.HeadsetConnection} is found before anything opens, so
 * that a missing headset ends the run with one line. All else happens on the thread {@code
 * headset}, which steps the world. Code that asks the user something reads {@link
 * org.selectiverenderer.app.headset.ControllerCommand}s, and places its text by {@link
 * org.selectiverenderer.app.headset.PanelPlacement}. Uses {@code openxr}, {@code hmd}, {@code
 * tracker}, {@code browser} with its renderer and {@code study.headlog} for rooms.
 */
@NullMarked
package org.selectiverenderer.app.headset;

import org.jspecify.annotations.NullMarked;
