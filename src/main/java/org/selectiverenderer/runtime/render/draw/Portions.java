package org.selectiverenderer.runtime.render.draw;

import com.jogamp.opengl.GL3;

/**
 * Hands a frame to a software renderer in portions. Such a renderer gathers what is drawn until it
 * is told to go on; then other threads of its own fill the pixels, while the vertices of the next
 * portion are worked on here. The pixels are the same. A graphics card begins by itself.
 *
 * <p>What was measured (llvmpipe, 2 cores, busy): with 306,000 triangles in view a frame took 0.66
 * of the time by the clock, with 55,000 0.92, in the same time of processors; with 15,000 and
 * 26,000 the difference was less than the noise. Smaller portions brought no more, as every one has
 * its price.
 */
final class Portions {
  /** Indices of a portion at most: 20,000 triangles. */
  static final long MOST = 3 * 20_000;

  /** A frame of fewer indices is not worth dividing into two. */
  static final long LEAST = 3 * 10_000;

  private final boolean software;
  private long portion = MOST;
  private long gathered;

  /**
   * @param software whether a processor draws
   */
  Portions(boolean software) {
    this.software = software;
  }

  /** So many indices are going to be drawn for an eye: two portions or more. */
  void begin(long indices) {
    portion = indices < LEAST ? MOST : Math.min(MOST, (indices + 1) / 2);
  }

  /** So many indices were drawn. */
  void drawn(GL3 gl, long indices) {
    gathered += indices;
    if (software && gathered >= portion) {
      end(gl);
    }
  }

  /** What was drawn may be filled: more follows, such as the other eye's. */
  void end(GL3 gl) {
    if (software && gathered > 0) {
      gl.glFlush();
    }
    gathered = 0;
  }
}
