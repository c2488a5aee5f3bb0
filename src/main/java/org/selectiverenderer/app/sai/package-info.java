/**
 * Runs a scene with the selective controller in any browser that implements the Scene Access
 * Interface.
 *
 * <p>In: the URL of a scene. Out: its time line, a window. May use {@code control}, {@code
 * walkthrough.timeline}, {@code browser.viewer} for recorded paths and {@code org.web3d.x3d.sai}
 * only, so that it runs on Xj3D.
 */
@NullMarked
package org.selectiverenderer.app.sai;

import org.jspecify.annotations.NullMarked;
