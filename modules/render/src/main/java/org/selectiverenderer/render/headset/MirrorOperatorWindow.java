package org.selectiverenderer.render.headset;

import com.jogamp.opengl.GL3;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.display.OperatorPage;
import org.selectiverenderer.render.display.OperatorPageRenderer;
import org.selectiverenderer.render.display.WorldController;
import org.selectiverenderer.render.window.FrameSize;
import org.selectiverenderer.render.window.SideWindowContent;

/**
 * The operator's window of a headset run. Its pages are made by the headset's thread, which owns
 * the data that they show, ten times a second, and are drawn by the windows' thread.
 */
final class MirrorOperatorWindow implements SideWindowContent {
  private static final long PAUSE = 100_000_000;

  /** A page, and the size of the window that it was made for. */
  private record Made(OperatorPage page, FrameSize size, long number) {}

  private final MirrorReadback mirror;
  private final OperatorPageRenderer canvas = new OperatorPageRenderer();
  private final AtomicReference<@Nullable Made> made = new AtomicReference<>();
  private volatile @Nullable FrameSize size;
  private volatile @Nullable Screenshot shot;
  private long last = System.nanoTime() - PAUSE;
  private long number;
  private long drawn = -1;
  private long copied;

  /** Makes a window that shows the newest copies of a mirror. */
  MirrorOperatorWindow(MirrorReadback mirror) {
    this.mirror = mirror;
  }

  /** Makes the next page if it is time for it; on the headset's thread. */
  void update(WorldController host) {
    FrameSize known = size;
    long now = System.nanoTime();
    if (known == null || now - last < PAUSE) {
      return;
    }
    last = now;
    MirrorReadback.Copy copy = mirror.newest();
    made.set(
        new Made(
            host.operatorPage(
                known.width(),
                known.height(),
                copy == null ? 1 : copy.width(),
                copy == null ? 1 : copy.height()),
            known,
            ++number));
  }

  @Override
  public boolean wanted() {
    Made newest = made.get();
    return size == null || newest != null && newest.number() != drawn;
  }

  @Override
  public void draw(GL3 gl, FrameSize frame) {
    size = frame;
    canvas.clear(gl);
    Made newest = made.get();
    if (newest == null) {
      return;
    }
    drawn = newest.number();
    MirrorReadback.Copy copy = mirror.newest();
    if (copy != null && copy.number() != copied) {
      copied = copy.number();
      canvas.picture().hold(copy.pixels(), copy.width(), copy.height());
    }
    canvas.paint(gl, frame, newest.page(), copy != null);
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
