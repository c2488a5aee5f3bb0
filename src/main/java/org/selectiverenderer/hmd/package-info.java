/**
 * Head-mounted displays: what each eye of a display sees, and the viewer under a head tracker.
 *
 * <p>In: a display profile (built in or one's own as JSON), the interpupillary distance, the
 * scene's unit, a tracker's orientation. Out: per eye a frustum and a place, as cameras for {@code
 * runtime.render}; the viewer's motion for {@code runtime}. The geometry is plain arithmetic
 * without GL: {@link org.selectiverenderer.hmd.EyeGeometry} is its heart. All lengths of a display
 * are metres or, where named so, millimetres; angles of files and options are degrees.
 *
 * <p>Uses {@code runtime}, {@code runtime.navigation}, {@code runtime.render}, {@code tracker} and
 * {@code x3d}; makes no GL call itself.
 */
@NullMarked
package org.selectiverenderer.hmd;

import org.jspecify.annotations.NullMarked;
