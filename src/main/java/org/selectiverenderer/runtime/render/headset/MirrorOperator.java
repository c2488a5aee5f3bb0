package org.selectiverenderer.runtime.render.headset;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.tessellate.TextMesher;
import org.selectiverenderer.runtime.render.context.PictureCopy;
import org.selectiverenderer.runtime.render.context.Screenshot;
import org.selectiverenderer.runtime.render.show.OperatorPage;
import org.selectiverenderer.runtime.render.show.WorldHost;
import org.selectiverenderer.runtime.render.sketch.SketchPainter;
import org.selectiverenderer.runtime.render.window.FrameSize;
import org.selectiverenderer.runtime.render.window.SideSource;

/**
 * The operator's window beside the mirror: pages are made by the headset's thread, which owns what
 * they tell of, ten times a second, and drawn by the windows'.
 */
final class MirrorOperator implements SideSource {
  private static final long PAUSE = 100_000_000;

  /** A page and the size of the window that it was made for. */
  private record Made(OperatorPage page, FrameSize size, long number) {}

  private final Mirror mirror;
  private final PictureCopy picture = new PictureCopy();
  private final SketchPainter sketch = new SketchPainter(new TextMesher());
  private final AtomicReference<@Nullable Made> made = new AtomicReference<>();
  private volatile @Nullable FrameSize size;
  private volatile @Nullable Screenshot shot;
  private long last = System.nanoTime() - PAUSE;
  private long number;
  private long drawn = -1;
  private long copied;

  /** Reads the newest of its copies. */
  MirrorOperator(Mirror mirror) {
    this.mirror = mirror;
  }

  /** Makes the next page if it is time for one; on the headset's thread. */
  void update(WorldHost host) {
    FrameSize known = size;
    long now = System.nanoTime();
    if (known == null || now - last < PAUSE) {
      return;
    }
    last = now;
    Mirror.Copy copy = mirror.newest();
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
    gl.glClearColor(0.11f, 0.12f, 0.14f, 1);
    gl.glClear(GL.GL_COLOR_BUFFER_BIT);
    Made newest = made.get();
    if (newest == null) {
      return;
    }
    drawn = newest.number();
    Mirror.Copy copy = mirror.newest();
    OperatorPage page = newest.page();
    if (copy != null && page.width() > 0 && page.height() > 0) {
      if (copy.number() != copied) {
        copied = copy.number();
        picture.hold(copy.pixels(), copy.width(), copy.height());
      }
      int bottom = frame.height() - page.y() - page.height();
      picture.show(gl, page.x(), bottom, page.width(), page.height());
    }
    sketch.draw(gl, page.marks(), 0, 0, frame.width(), frame.height());
  }

  /** The window's last picture; null when there was none. */
  @Nullable Screenshot shot() {
    return shot;
  }

  @Override
  public void stop(GL3 gl) {
    FrameSize known = size;
    if (known != null) {
      draw(gl, known);
      shot = Screenshot.read(gl, known.width(), known.height());
    }
    picture.dispose(gl);
    sketch.dispose(gl);
  }
}
