package org.selectiverenderer.render.headset;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.selectiverenderer.render.context.CrossContextImage;
import org.selectiverenderer.render.display.TextOverlay;
import org.selectiverenderer.render.window.FrameSize;
import org.selectiverenderer.render.window.WindowContent;
import org.selectiverenderer.x3d.tessellate.TextMesher;

/**
 * The window on the desktop that mirrors the headset's picture, at the desktop's own frame rate.
 */
final class MirrorWindow implements WindowContent {
  private final MirrorReadback mirror;
  private final Runnable opening;
  private final Supplier<List<String>> lines;
  private final BooleanSupplier over;
  private final BooleanSupplier closing;
  private final CrossContextImage picture = new CrossContextImage();
  private final TextOverlay overlay = new TextOverlay(new TextMesher());
  private long shown;

  /**
   * @param opening called before the window is shown, on the thread that opens it
   * @param lines the text lines over the picture
   * @param over returns whether the run has ended
   * @param closing asked whether a window that the user closes may close; called by the window
   *     system's thread
   */
  MirrorWindow(
      MirrorReadback mirror,
      Runnable opening,
      Supplier<List<String>> lines,
      BooleanSupplier over,
      BooleanSupplier closing) {
    this.mirror = mirror;
    this.opening = opening;
    this.lines = lines;
    this.over = over;
    this.closing = closing;
  }

  @Override
  public void opening() {
    opening.run();
  }

  @Override
  public void start(GL3 gl) {
    // The picture is uploaded when there is one.
  }

  @Override
  public boolean step() {
    return !over.getAsBoolean();
  }

  @Override
  public boolean closing() {
    return closing.getAsBoolean();
  }

  @Override
  public void draw(GL3 gl, FrameSize size) {
    gl.glClearColor(0, 0, 0, 1);
    gl.glClear(GL.GL_COLOR_BUFFER_BIT);
    MirrorReadback.Copy copy = mirror.newest();
    if (copy != null) {
      if (copy.number() != shown) {
        shown = copy.number();
        picture.hold(copy.pixels(), copy.width(), copy.height());
      }
      double scale =
          Math.min(size.width() / (double) copy.width(), size.height() / (double) copy.height());
      int width = (int) Math.round(copy.width() * scale);
      int height = (int) Math.round(copy.height() * scale);
      picture.show(gl, (size.width() - width) / 2, (size.height() - height) / 2, width, height);
    }
    List<String> text = lines.get();
    if (!text.isEmpty()) {
      overlay.draw(gl, text, size.width(), size.height(), size.scale());
    }
  }

  @Override
  public void stop(GL3 gl) {
    overlay.dispose(gl);
    picture.dispose(gl);
  }
}
