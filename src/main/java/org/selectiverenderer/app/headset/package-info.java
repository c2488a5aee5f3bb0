/**
 * A headset in a run: what {@code openxr} knows of it, taken to where it belongs.
 *
 * <pre>
 *   openxr.XrHeadset --pose--> tracker.live.HandedTracker --> hmd.TrackedMotion (in the step)
 *                    --eyes--> hmd.HeadsetLayout --> runtime.render.headset (both pictures)
 *                    --input-> HeadsetHands --> walking, commands, answers
 *                    --news--> the run's listener: messages, time line, a session's journal
 * </pre>
 *
 * <p>{@link org.selectiverenderer.app.headset.HeadsetLink} is found before anything opens, so that
 * a headset that is not there ends the run with one line. All else happens on the thread {@code
 * headset}, which steps the world. Whoever asks the user something reads {@link
 * org.selectiverenderer.app.headset.HeadsetAnswer}s, and has what is to be read stand where {@link
 * org.selectiverenderer.app.headset.PanelPlace} says. Uses {@code openxr}, {@code hmd}, {@code
 * tracker}, {@code runtime} with its renderer and {@code experiment.headlog} for rooms.
 */
@NullMarked
package org.selectiverenderer.app.headset;

import org.jspecify.annotations.NullMarked;
