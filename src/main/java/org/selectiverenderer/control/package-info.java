/**
 * The selective rendering controller (thesis 4.3, Figs 48 and 49): which version of each object is
 * shown, as the viewer enters and leaves areas.
 *
 * <p>In: a browser seen through {@code org.web3d.x3d.sai} only, so that the controller runs
 * unchanged on Xj3D; of package {@code schema} the metadata vocabulary and {@link
 * org.selectiverenderer.schema.Activation}, the algorithm without a browser. Out: {@code
 * whichChoice} of Switch nodes, and {@link org.selectiverenderer.control.ControlEvent}s. May use
 * {@code schema} and {@code org.web3d.x3d.sai}; loads no AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.control;

import org.jspecify.annotations.NullMarked;
