package org.selectiverenderer.runtime.render;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.render.context.GlInfo;
import org.selectiverenderer.runtime.render.context.Screenshot;
import org.selectiverenderer.runtime.render.window.FrameSize;
import org.selectiverenderer.runtime.render.window.FrameSource;
import org.selectiverenderer.runtime.render.window.InputEvent;
import org.selectiverenderer.runtime.render.window.RenderWindow;
import org.selectiverenderer.runtime.render.window.WindowOptions;
import org.selectiverenderer.x3d.geometry.TextMesher;

/** A window onto a world. Its render thread is the one that steps the world. */
public final class WorldWindow {
  private final WorldHost host;
  private final RenderWindow window;
  private volatile @Nullable Screenshot last;
  private volatile @Nullable GlInfo info;

  public WorldWindow(WindowOptions options, WorldHost host) {
    this.host = host;
    Frames frames = new Frames();
    window = new RenderWindow(options, frames, frames::input);
  }

  /**
   * Shows the world until the user closes the window or the host is finished.
   *
   * @throws org.selectiverenderer.runtime.render.context.GlUnavailableException if there is no
   *     display or no OpenGL 3.3
   * @throws InterruptedException if the waiting thread is interrupted; the window is closed
   */
  public void run() throws InterruptedException {
    window.run();
  }

  /** What draws; empty before the window opened. */
  public Optional<GlInfo> info() {
    return Optional.ofNullable(info);
  }

  /** The last picture of the world, without the overlay; empty when it was never drawn. */
  public Optional<Screenshot> lastPicture() {
    return Optional.ofNullable(last);
  }

  private final class Frames implements FrameSource {
    private final WorldPainter painter = new WorldPainter(ViewLayout.MONO);
    private final Overlay overlay = new Overlay(new TextMesher());
    private final PointerTracker pointer = new PointerTracker();
    private Optional<World> world = Optional.empty();
    private @Nullable FrameSize size;

    void input(InputEvent event) {
      host.input(event);
      if (world.isPresent() && size != null) {
        pointer.input(event, world.get(), size);
      }
    }

    @Override
    public void start(GL3 gl) {
      info = GlInfo.of(gl);
    }

    @Override
    public boolean step() {
      world = host.step();
      return !host.finished();
    }

    @Override
    public void draw(GL3 gl, FrameSize frame) {
      size = frame;
      if (world.isEmpty()) {
        gl.glClearColor(0, 0, 0, 1);
        gl.glClear(GL.GL_COLOR_BUFFER_BIT);
        overlay.draw(
            gl, List.of("Loading the scene ..."), frame.width(), frame.height(), frame.scale());
        return;
      }
      Drawn drawn = painter.paint(gl, world.get(), frame.width(), frame.height());
      List<String> lines = host.overlay();
      if (!lines.isEmpty()) {
        overlay.draw(gl, lines, frame.width(), frame.height(), frame.scale());
      }
      host.drawn(drawn);
    }

    @Override
    public void stop(GL3 gl) {
      if (world.isPresent() && size != null) {
        painter.paint(gl, world.get(), size.width(), size.height());
        last = Screenshot.read(gl, size.width(), size.height());
      }
      overlay.dispose(gl);
      painter.dispose(gl);
    }
  }
}
