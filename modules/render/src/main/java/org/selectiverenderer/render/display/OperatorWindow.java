package org.selectiverenderer.render.display;

import com.jogamp.opengl.GL3;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.render.context.CrossContextImage;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.window.FrameSize;
import org.selectiverenderer.render.window.SideWindowContent;

/**
 * The content of the operator's window: a copy of the participant's picture and the host's page. It
 * is updated ten times a second only, so that it hardly slows down the participant's frames.
 */
final class OperatorWindow implements SideWindowContent {
  private static final long PAUSE = 100_000_000;

  private final WorldController host;
  private final OperatorPageRenderer canvas = new OperatorPageRenderer();
  private long last = System.nanoTime() - PAUSE;
  private boolean due;
  private @Nullable FrameSize size;
  private @Nullable Screenshot shot;

  OperatorWindow(WorldController host) {
    this.host = host;
  }

  /** Returns whether it is time for the next copy. */
  boolean due() {
    return System.nanoTime() - last >= PAUSE;
  }

  /** Copies the framebuffer that is bound for reading, in the participant's context. */
  void take(GL3 gl, int width, int height) {
    canvas.picture().take(gl, 0, 0, width, height);
    last = System.nanoTime();
    due = true;
  }

  @Override
  public boolean wanted() {
    return due;
  }

  @Override
  public void draw(GL3 gl, FrameSize frame) {
    due = false;
    size = frame;
    canvas.clear(gl);
    CrossContextImage picture = canvas.picture();
    OperatorPage page =
        host.operatorPage(frame.width(), frame.height(), picture.width(), picture.height());
    canvas.paint(gl, frame, page, true);
  }

  /** Returns the window's last picture; null when there was none. */
  @Nullable Screenshot shot() {
    return shot;
  }

  @Override
  public void stop(GL3 gl) {
    FrameSize known = size;
    shot = canvas.end(gl, known, () -> draw(gl, known));
  }
}
