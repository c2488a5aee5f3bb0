package org.selectiverenderer.render.display;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.PointingDeviceState;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.ViewLayout;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.render.context.CrossContextImage;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.window.DisplayTiming;
import org.selectiverenderer.render.window.FrameSize;
import org.selectiverenderer.render.window.InputEvent;
import org.selectiverenderer.render.window.RenderWindow;
import org.selectiverenderer.render.window.SideWindowContent;
import org.selectiverenderer.render.window.SideWindowSpec;
import org.selectiverenderer.render.window.WindowContent;
import org.selectiverenderer.x3d.tessellate.TextMesher;

/** Shows a world in windows. Their render thread is the one that steps the world. */
public final class WorldWindow implements WorldDisplay {
  private final WorldController host;
  private final WindowSetup stage;
  private final RenderWindow window;
  private final @Nullable OperatorWindow operator;
  private volatile @Nullable Screenshot last;
  private volatile @Nullable GlInfo info;
  private volatile @Nullable DisplayTiming timing;
  private volatile long uploads;

  public WorldWindow(WindowSetup stage, WorldController host) {
    this.host = host;
    this.stage = stage;
    CrossContextImage right = new CrossContextImage();
    List<SideWindowSpec> sides = new ArrayList<>();
    stage
        .rightEye()
        .ifPresent(
            options ->
                sides.add(
                    new SideWindowSpec(options, new RightEyeContent(right), Optional.empty())));
    operator = stage.operator().isPresent() ? new OperatorWindow(host) : null;
    if (operator != null) {
      sides.add(
          new SideWindowSpec(stage.operator().get(), operator, Optional.of(host::operatorInput)));
    }
    Frames frames = new Frames(right);
    window = new RenderWindow(stage.main(), frames, frames::input, sides);
  }

  @Override
  public void run() throws InterruptedException {
    window.run();
  }

  @Override
  public Optional<GlInfo> info() {
    return Optional.ofNullable(info);
  }

  @Override
  public Optional<DisplayTiming> timing() {
    return Optional.ofNullable(timing);
  }

  @Override
  public Optional<Screenshot> lastPicture() {
    return Optional.ofNullable(last);
  }

  @Override
  public Optional<Screenshot> lastOperatorPicture() {
    return operator == null ? Optional.empty() : Optional.ofNullable(operator.shot());
  }

  /** Returns the number of meshes and textures uploaded up to the last frame. */
  long uploads() {
    return uploads;
  }

  private final class Frames implements WindowContent {
    private final WorldRenderer painter = new WorldRenderer(stage.layout(), stage.style());
    private final DualWindowFramebuffer eyes = new DualWindowFramebuffer(stage.main().samples());
    private final boolean split = stage.rightEye().isPresent();
    private final TextOverlay overlay = new TextOverlay(new TextMesher());
    private final FadeOverlay veil = new FadeOverlay();
    private final PointerForwarder pointer = new PointerForwarder();
    private final CrossContextImage right;
    private Optional<World> world = Optional.empty();
    private @Nullable World ready;
    private @Nullable FrameSize size;

    Frames(CrossContextImage right) {
      this.right = right;
    }

    void input(InputEvent event) {
      host.input(event);
      // In stereo the pointer has no defined position in the scene.
      if (world.isPresent() && size != null && stage.layout() == ViewLayout.MONO) {
        pointer.input(event, world.get(), size);
      }
    }

    @Override
    public void opening() {
      host.opening();
    }

    @Override
    public void start(GL3 gl) {
      info = GlInfo.of(gl);
    }

    @Override
    public void paced(DisplayTiming told) {
      timing = told;
    }

    @Override
    public boolean step() {
      world = host.step();
      return !host.finished();
    }

    @Override
    public boolean pointerKept() {
      return host.pointerKept();
    }

    @Override
    public boolean closing() {
      return host.closing();
    }

    @Override
    public void draw(GL3 gl, FrameSize frame) {
      size = frame;
      if (world.isEmpty()) {
        black(gl, frame);
        List<String> waiting = host.waiting();
        if (!waiting.isEmpty()) {
          overlay.draw(gl, waiting, frame.width(), frame.height(), frame.scale());
        }
        return;
      }
      if (world.get() != ready && host.readyAtOnce()) {
        painter.prepare(gl, world.get());
        ready = world.get();
      }
      FrameStatistics drawn = paint(gl, world.get(), frame);
      uploads = painter.uploads();
      mirror(gl, frame);
      List<String> lines = host.overlay();
      if (!lines.isEmpty()) {
        overlay.draw(gl, lines, frame.width(), frame.height(), frame.scale());
      }
      host.drawn(drawn);
    }

    /** Draws black for both eyes and the operator's copy. */
    private void black(GL3 gl, FrameSize frame) {
      int[] bound = new int[1];
      gl.glGetIntegerv(GL.GL_FRAMEBUFFER_BINDING, bound, 0);
      if (split) {
        eyes.bind(gl, frame.width(), frame.height());
      }
      gl.glClearColor(0, 0, 0, 1);
      gl.glClear(GL.GL_COLOR_BUFFER_BIT);
      if (split) {
        eyes.split(gl, bound[0], right);
      }
      mirror(gl, frame);
    }

    private FrameStatistics paint(GL3 gl, World shown, FrameSize frame) {
      if (!split) {
        FrameStatistics drawn =
            painter.paint(gl, shown, frame.width(), frame.height(), frame.scale());
        darken(gl, frame.width(), frame.height());
        page(gl, shown, frame.width(), frame.height());
        return drawn;
      }
      int[] bound = new int[1];
      gl.glGetIntegerv(GL.GL_FRAMEBUFFER_BINDING, bound, 0);
      eyes.bind(gl, frame.width(), frame.height());
      FrameStatistics drawn =
          painter.paint(gl, shown, 2 * frame.width(), frame.height(), frame.scale());
      darken(gl, 2 * frame.width(), frame.height());
      page(gl, shown, 2 * frame.width(), frame.height());
      eyes.split(gl, bound[0], right);
      return drawn;
    }

    private void page(GL3 gl, World shown, int width, int height) {
      host.page().ifPresent(page -> painter.page(gl, shown, width, height, page));
    }

    private void darken(GL3 gl, int width, int height) {
      veil.draw(gl, host.darkness(), width, height);
    }

    private void mirror(GL3 gl, FrameSize frame) {
      if (operator == null || !operator.due()) {
        return;
      }
      if (split) {
        int[] bound = new int[1];
        gl.glGetIntegerv(GL.GL_FRAMEBUFFER_BINDING, bound, 0);
        eyes.read(gl);
        operator.take(gl, 2 * frame.width(), frame.height());
        gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, bound[0]);
      } else {
        operator.take(gl, frame.width(), frame.height());
      }
    }

    @Override
    public void submitted() {
      if (world.isPresent()) {
        host.submitted();
      }
    }

    /** Draws a picture with more samples than the window has, if the settings ask for more. */
    private Optional<Screenshot> smooth(GL3 gl, World shown, FrameSize frame) {
      int samples = stage.pictureSamples();
      int[] drawn = {stage.main().samples()};
      if (!split) {
        gl.glGetIntegerv(GL.GL_SAMPLES, drawn, 0); // A driver may give fewer than asked for.
      }
      if (samples <= drawn[0] || host.darkness() > 0) {
        return Optional.empty();
      }
      int width = (split ? 2 : 1) * frame.width();
      return painter.picture(gl, shown, width, frame.height(), frame.scale(), samples);
    }

    @Override
    public void stop(GL3 gl) {
      if (world.isPresent() && size != null) {
        last = smooth(gl, world.get(), size).orElse(null);
        if (last == null) {
          paint(gl, world.get(), size);
          if (split) {
            eyes.read(gl);
          }
          last = Screenshot.read(gl, (split ? 2 : 1) * size.width(), size.height());
        }
      }
      overlay.dispose(gl);
      veil.dispose(gl);
      eyes.dispose(gl);
      painter.dispose(gl);
    }
  }

  /** The content of the right eye's window: shows each picture that was copied for it. */
  private static final class RightEyeContent implements SideWindowContent {
    private final CrossContextImage picture;

    RightEyeContent(CrossContextImage picture) {
      this.picture = picture;
    }

    @Override
    public boolean wanted() {
      return !picture.isEmpty();
    }

    @Override
    public void draw(GL3 gl, FrameSize size) {
      gl.glClearColor(0, 0, 0, 1);
      gl.glClear(GL.GL_COLOR_BUFFER_BIT);
      // As large as possible with its aspect ratio, since the monitors of the two eyes may differ.
      double scale =
          Math.min(
              size.width() / (double) picture.width(), size.height() / (double) picture.height());
      int width = (int) Math.round(picture.width() * scale);
      int height = (int) Math.round(picture.height() * scale);
      picture.show(gl, (size.width() - width) / 2, (size.height() - height) / 2, width, height);
    }

    @Override
    public void stop(GL3 gl) {
      picture.dispose(gl);
    }
  }

  /**
   * Forwards the mouse to the world: the view ray under the pointer, and whether the button is
   * pressed.
   */
  private static final class PointerForwarder {
    private static final int LEFT = 1;

    private boolean pressed;

    /** Handles an event of a window that the world's view of that size fills. */
    void input(InputEvent event, World world, FrameSize size) {
      if (event instanceof InputEvent.MotionInput motion) {
        point(world, size, motion.x(), motion.y());
      } else if (event instanceof InputEvent.ButtonInput button && button.button() == LEFT) {
        pressed = button.pressed();
        point(world, size, button.x(), button.y());
      } else if (event instanceof InputEvent.FocusLost) {
        pressed = false;
        world.point(PointingDeviceState.AWAY);
      }
    }

    private void point(World world, FrameSize size, int x, int y) {
      double half = Math.tan(world.viewer().fieldOfView() / 2);
      double smaller = Math.min(size.width(), size.height());
      double right = (2 * (x + 0.5) - size.width()) / smaller * half;
      double up = (size.height() - 2 * (y + 0.5)) / smaller * half;
      double aspect = size.width() / (double) size.height();
      world.point(
          new PointingDeviceState(Optional.of(new Vector3d(right, up, -1)), pressed, aspect));
    }
  }
}
