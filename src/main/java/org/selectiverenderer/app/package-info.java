/**
 * Puts the parts together: a walk-through of a scene with its controller, clock, time line and
 * figures. What {@code run}, {@code simulate} and {@code bench} share.
 *
 * <p>In: a scene file and settings. Out: frames, a time line, figures. May use every package but
 * {@code cli}.
 */
@NullMarked
package org.selectiverenderer.app;

import org.jspecify.annotations.NullMarked;
