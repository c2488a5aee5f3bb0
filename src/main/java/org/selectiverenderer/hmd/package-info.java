/**
 * Head-mounted displays: what each eye of a display sees, and the viewer under a head tracker.
 *
 * <p>In: a display profile (built in or one's own as JSON), the interpupillary distance, the
 * scene's unit, a tracker's orientation. Out: per eye a frustum and a place, as cameras of {@code
 * runtime.camera}; a check pattern as marks; the viewer's motion for {@code runtime}. The geometry
 * is plain arithmetic without GL: {@link org.selectiverenderer.hmd.EyeGeometry} is its heart. All
 * lengths of a display are metres or, where named so, millimetres; angles of files and options are
 * degrees.
 *
 * <p>The pose of the head is read in the frame step ({@link
 * org.selectiverenderer.hmd.TrackedMotion}), so that sensors see what is drawn; the step of a frame
 * begins when the frame before is on its way.
 *
 * <p>Uses {@code tracker}, {@code runtime} but its renderer, {@code base.json} for the profiles and
 * {@code base.problem}; makes no GL call.
 */
@NullMarked
package org.selectiverenderer.hmd;

import org.jspecify.annotations.NullMarked;
