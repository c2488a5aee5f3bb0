package org.selectiverenderer.render.headset;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.EyeView;
import org.selectiverenderer.browser.camera.MirroredEye;
import org.selectiverenderer.browser.camera.WorldSpacePanel;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.display.FadeOverlay;
import org.selectiverenderer.render.display.WindowSetup;
import org.selectiverenderer.render.display.WorldController;
import org.selectiverenderer.render.display.WorldDisplay;
import org.selectiverenderer.render.display.WorldRenderer;
import org.selectiverenderer.render.graphics2d.Graphics2dRenderer;
import org.selectiverenderer.render.window.InputEvent;
import org.selectiverenderer.render.window.RenderWindow;
import org.selectiverenderer.render.window.SideWindowSpec;
import org.selectiverenderer.x3d.tessellate.TextMesher;

/** Shows a world in a headset, and mirrors the headset's pictures to windows on the desktop. */
public final class HeadsetView implements WorldDisplay {
  /** The time between two polls while the headset shows nothing. */
  private static final long IDLE_NANOS = 20_000_000;

  private final WorldController host;
  private final HeadsetDisplay screen;
  private final WindowSetup stage;
  private final int samples;
  private final MirrorReadback mirror;
  private final MirrorWindow desk;
  private final @Nullable MirrorOperatorWindow operator;
  private final ConcurrentLinkedQueue<InputEvent> input = new ConcurrentLinkedQueue<>();
  private final ConcurrentLinkedQueue<InputEvent> operatorInput = new ConcurrentLinkedQueue<>();
  private final CountDownLatch begun = new CountDownLatch(1);
  private volatile boolean over;
  private volatile boolean windowsClosed;
  private volatile List<String> lines = List.of();
  private volatile @Nullable Throwable failure;
  private volatile @Nullable GlInfo info;
  private volatile @Nullable Screenshot last;

  /**
   * @param stage the windows on the desktop; their layout is the headset's own
   * @param screen the headset, opened and closed by the headset's thread
   * @param side which eyes the main window shows
   * @param samples per pixel of the eyes' pictures; 0 for no anti-aliasing
   */
  public HeadsetView(
      WindowSetup stage,
      WorldController host,
      HeadsetDisplay screen,
      MirroredEye side,
      int samples) {
    this.stage = stage;
    this.samples = samples;
    this.host = host;
    this.screen = screen;
    mirror = new MirrorReadback(side);
    desk = new MirrorWindow(mirror, host::opening, () -> lines, () -> over, host::closing);
    operator = stage.operator().isPresent() ? new MirrorOperatorWindow(mirror) : null;
  }

  @Override
  public void run() throws InterruptedException {
    Thread thread = new Thread(this::show, "headset");
    thread.start();
    begun.await();
    try {
      if (!over) {
        windows().run();
      }
    } finally {
      windowsClosed = true;
      thread.join();
    }
    Throwable broken = failure;
    if (broken instanceof RuntimeException exception) {
      throw exception;
    }
    if (broken != null) {
      throw new IllegalStateException("drawing failed: " + broken, broken);
    }
  }

  private RenderWindow windows() {
    List<SideWindowSpec> sides = new ArrayList<>();
    if (operator != null) {
      sides.add(
          new SideWindowSpec(
              stage.operator().orElseThrow(), operator, Optional.of(operatorInput::add)));
    }
    return new RenderWindow(stage.main(), desk, input::add, sides);
  }

  @Override
  public Optional<GlInfo> info() {
    return Optional.ofNullable(info);
  }

  @Override
  public Optional<Screenshot> lastPicture() {
    return Optional.ofNullable(last);
  }

  @Override
  public Optional<Screenshot> lastOperatorPicture() {
    return operator == null ? Optional.empty() : Optional.ofNullable(operator.shot());
  }

  /** Runs the thread {@code headset}. */
  private void show() {
    try (HeadsetContext context = HeadsetContext.open()) {
      GL3 gl = context.gl();
      info = GlInfo.of(gl);
      screen.open(context.handles());
      Frames frames = new Frames(gl);
      try {
        begun.countDown();
        frames.run();
      } finally {
        screen.close();
        frames.dispose();
      }
    } catch (RuntimeException | Error e) {
      failure = e;
    } finally {
      over = true;
      begun.countDown();
    }
  }

  private final class Frames {
    private final GL3 gl;
    private final WorldRenderer painter;
    private final StereoFramebuffer eyes = new StereoFramebuffer(samples);
    private final FadeOverlay veil = new FadeOverlay();
    private final Graphics2dRenderer panel = new Graphics2dRenderer(new TextMesher());
    private Optional<World> world = Optional.empty();
    private HeadsetDisplay.@Nullable Due size;
    private @Nullable World ready;

    Frames(GL3 gl) {
      this.gl = gl;
      painter = new WorldRenderer(screen.layout(), stage.style());
    }

    void run() {
      while (!windowsClosed) {
        drain();
        Optional<HeadsetDisplay.Due> due = screen.next();
        host.presented(screen.visible());
        world = host.step();
        if (host.finished() || screen.takeLeave() && host.closing()) {
          due.ifPresent(frame -> empty());
          return;
        }
        if (due.isEmpty()) {
          mirror.blacken();
          LockSupport.parkNanos(IDLE_NANOS);
        } else if (due.get().drawn() && world.isPresent()) {
          frame(due.get(), world.get());
        } else {
          empty();
        }
        lines = world.isPresent() ? host.overlay() : host.waiting();
        if (operator != null) {
          operator.update(host);
        }
      }
    }

    private void drain() {
      for (InputEvent event = input.poll(); event != null; event = input.poll()) {
        host.input(event);
      }
      for (InputEvent event = operatorInput.poll(); event != null; event = operatorInput.poll()) {
        host.operatorInput(event);
      }
    }

    /**
     * Submits a frame without a picture, because the runtime expects every frame that was waited
     * for.
     */
    private void empty() {
      screen.begin();
      screen.end(false);
    }

    private void frame(HeadsetDisplay.Due due, World shown) {
      size = due;
      screen.begin();
      if (shown != ready && host.readyAtOnce()) {
        painter.prepare(gl, shown);
        ready = shown;
      }
      OffscreenFramebuffer target = eyes.bind(gl, due.width(), due.height());
      FrameStatistics drawn = painter.paint(gl, shown, target.width(), target.height(), 1);
      veil.draw(gl, host.darkness(), target.width(), target.height());
      host.panels().forEach(page -> read(page, shown, target));
      eyes.resolve(gl);
      boolean both = true;
      for (int eye = 0; eye < 2; eye++) {
        OptionalInt texture = screen.texture(eye);
        both &= texture.isPresent();
        if (texture.isPresent()) {
          eyes.copy(gl, eye, texture.getAsInt());
        }
      }
      gl.glFlush();
      host.drawn(drawn);
      screen.end(both);
      host.submitted();
      mirror.frame(gl, target);
    }

    /** Draws a panel of text for both eyes. */
    private void read(WorldSpacePanel page, World shown, OffscreenFramebuffer target) {
      for (EyeView eye :
          screen.layout().views(shown, target.width(), target.height(), HeadsetDisplay.READING)) {
        panel.draw(gl, page, eye.camera());
      }
    }

    /** Frees everything, after taking a last picture of the view. */
    void dispose() {
      HeadsetDisplay.Due known = size;
      if (known != null && world.isPresent()) {
        OffscreenFramebuffer target = eyes.bind(gl, known.width(), known.height());
        if (stage.pictureSamples() > target.samples()) {
          last =
              painter
                  .picture(
                      gl, world.get(), target.width(), target.height(), 1, stage.pictureSamples())
                  .orElse(null);
        }
        if (last == null) {
          painter.paint(gl, world.get(), target.width(), target.height(), 1);
          last = target.read(gl);
        }
      }
      gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, 0);
      mirror.dispose(gl);
      veil.dispose(gl);
      panel.dispose(gl);
      eyes.dispose(gl);
      painter.dispose(gl);
    }
  }
}
