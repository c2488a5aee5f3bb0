/**
 * Head-mounted displays: the frustum of each eye, and the motion of the viewer by a head tracker.
 *
 * <p>In: a display profile (built in or the user's own as JSON), the interpupillary distance, the
 * scene's unit of length, a tracker's poses. Out: per eye a frustum and a position, as cameras of
 * {@code browser.camera}; a test pattern as flat graphics; the viewer's motion for {@code browser}.
 * The geometry is computed without GL, mainly in {@link
 * org.selectiverenderer.apparatus.EyeGeometry}. All lengths of a display are metres or, where named
 * so, millimetres; angles of files and options are degrees.
 *
 * <p>The pose of the head is read in the frame step ({@link
 * org.selectiverenderer.hmd.HeadTrackedMotion}), so that sensors are evaluated for the same view
 * that is drawn; the step of a frame begins when the previous frame has been submitted.
 *
 * <p>Uses {@code tracker}, {@code browser} but its renderer, {@code formats.json} for the profiles
 * and {@code base.problem}; makes no GL call.
 */
@NullMarked
package org.selectiverenderer.hmd;

import org.jspecify.annotations.NullMarked;
