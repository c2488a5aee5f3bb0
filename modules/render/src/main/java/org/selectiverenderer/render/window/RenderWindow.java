package org.selectiverenderer.render.window;

import com.jogamp.newt.MonitorDevice;
import com.jogamp.newt.event.KeyAdapter;
import com.jogamp.newt.event.KeyEvent;
import com.jogamp.newt.opengl.GLWindow;
import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLAutoDrawable;
import com.jogamp.opengl.GLCapabilities;
import com.jogamp.opengl.GLEventListener;
import com.jogamp.opengl.GLException;
import java.awt.AWTError;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.render.context.GlAvailability;
import org.selectiverenderer.render.context.GlUnavailableException;

/**
 * A window with its render loop. One thread, named {@code render}, opens the window, owns its
 * context, steps and draws frames at the display's refresh rate, and closes it. F11 toggles full
 * screen.
 */
public final class RenderWindow {
  private static final long IDLE_NANOS = 20_000_000;

  private final WindowOptions options;
  private final WindowContent source;
  private final InputListener listener;
  private final List<SideWindowSpec> sides;
  private final InputQueue queue = new InputQueue();
  private final AtomicBoolean closing = new AtomicBoolean();
  private final AtomicBoolean fullScreenWanted = new AtomicBoolean();
  private @Nullable Throwable failure;
  private long drawn;
  private boolean announced;
  private volatile boolean stopping;

  /**
   * Makes a window with side windows, whose input is heard too.
   *
   * @param sides windows opened after it and closed with it; closing one closes all, if the source
   *     allows it
   */
  public RenderWindow(
      WindowOptions options,
      WindowContent source,
      InputListener listener,
      List<SideWindowSpec> sides) {
    this.options = options;
    this.sides = List.copyOf(sides);
    this.source = source;
    this.listener = listener;
  }

  private void closeAsked() {
    // NEWT sends the same event when the program closes the windows.
    if (!stopping && source.closing()) {
      close();
    }
  }

  /** Ends the loop after the current frame; any thread. */
  public void close() {
    closing.set(true);
  }

  /**
   * Opens the window and shows frames until it is closed by the user, by {@link #close} or by the
   * source. Whatever happened, the window is gone and the thread has ended when this returns.
   * Called once.
   *
   * @throws GlUnavailableException if there is no display or no OpenGL 3.3
   * @throws RuntimeException the exception of the source or the listener
   * @throws InterruptedException if the waiting thread is interrupted; the window is closed
   */
  public void run() throws InterruptedException {
    GlAvailability.check()
        .ifPresent(
            reason -> {
              throw new GlUnavailableException(reason);
            });
    Thread thread = new Thread(this::loop, "render");
    thread.start();
    try {
      thread.join();
    } catch (InterruptedException e) {
      close();
      throw e;
    }
    if (failure instanceof RuntimeException exception) {
      throw exception;
    }
    if (failure != null) {
      throw new IllegalStateException("drawing failed: " + failure, failure);
    }
  }

  private void loop() {
    try {
      GLWindow window = openOrExplain();
      List<SideWindow> open = new ArrayList<>();
      try {
        for (SideWindowSpec side : sides) {
          open.add(new SideWindow(side, queue, this::closeAsked));
        }
        frames(window, open);
      } finally {
        stopping = true;
        open.forEach(SideWindow::close);
        NewtWindowFactory.close(window);
      }
    } catch (RuntimeException | Error e) {
      fail(e);
    }
  }

  private GLWindow openOrExplain() {
    try {
      return open();
    } catch (RuntimeException | LinkageError | AWTError e) {
      // JOGL asks AWT for the display's state unless Java runs headless, hence AWTError.
      throw new GlUnavailableException(
          "no window with OpenGL 3.3 can be opened: " + e.getMessage(), e);
    }
  }

  /** Keeps the first failure, because later ones are its consequences. */
  private void fail(Throwable e) {
    if (failure == null) {
      failure = e;
    } else if (failure != e) {
      failure.addSuppressed(e);
    }
  }

  private GLWindow open() {
    GLCapabilities wanted = NewtWindowFactory.capabilities(options);
    try {
      return open(wanted);
    } catch (GLException e) {
      if (!wanted.getSampleBuffers()) {
        throw e;
      }
      wanted.setSampleBuffers(false);
      return open(wanted);
    }
  }

  private GLWindow open(GLCapabilities wanted) {
    fullScreenWanted.set(options.fullScreen());
    GLWindow window =
        NewtWindowFactory.create(options, wanted, queue, this::closeAsked, new Drawing());
    if (!announced) {
      announced = true; // It is opened again without smoothed edges where there are none.
      source.opening();
    }
    NewtWindowFactory.show(window, options);
    window.addKeyListener(
        new KeyAdapter() {
          @Override
          public void keyPressed(KeyEvent event) {
            if (event.getKeySymbol() == KeyEvent.VK_F11 && !event.isAutoRepeat()) {
              fullScreenWanted.set(!fullScreenWanted.get());
            }
          }
        });
    window.requestFocus(false);
    return window;
  }

  private void frames(GLWindow window, List<SideWindow> open) {
    PointerConfinement keeper = new PointerConfinement(window);
    while (!closing.get() && failure == null) {
      queue.drain(listener);
      open.forEach(SideWindow::drain);
      if (!source.step()) {
        return;
      }
      if (window.isFullscreen() != fullScreenWanted.get()) {
        boolean now =
            fullScreenWanted.get()
                ? NewtWindowFactory.fill(window, options)
                : window.setFullscreen(false);
        fullScreenWanted.set(now);
        window.requestFocus(false);
      }
      keeper.keep(source.pointerKept());
      long before = drawn;
      window.display();
      for (SideWindow side : open) {
        side.draw();
      }
      if (drawn != before) {
        NewtWindowFactory.swap(window);
        for (SideWindow side : open) {
          side.swap();
        }
        source.submitted();
      } else {
        // A hidden or minimised window does not wait for the display's refresh.
        LockSupport.parkNanos(IDLE_NANOS);
      }
    }
  }

  /** Draws frames when NEWT calls from {@code display()} and {@code destroy()}. */
  private final class Drawing implements GLEventListener {
    private boolean started;

    @Override
    public void init(GLAutoDrawable drawable) {
      // NEWT may also call while the window becomes visible; the source is started with the first
      // frame.
      drawable.getGL().setSwapInterval(1);
    }

    @Override
    public void display(GLAutoDrawable drawable) {
      GL3 gl = drawable.getGL().getGL3();
      if (stopping) {
        stop(gl);
      } else if (failure == null) {
        try {
          frame(gl, drawable);
        } catch (RuntimeException | Error e) {
          fail(e);
        }
      }
    }

    private void frame(GL3 gl, GLAutoDrawable drawable) {
      int width = drawable.getSurfaceWidth();
      int height = drawable.getSurfaceHeight();
      if (!started) {
        started = true;
        source.start(gl);
        source.paced(new DisplayTiming(hertz(drawable), gl.getSwapInterval() != 0));
      }
      if (width > 0 && height > 0) {
        source.draw(gl, new FrameSize(width, height, scale(drawable)));
        drawn++;
      }
    }

    private static double hertz(GLAutoDrawable drawable) {
      MonitorDevice monitor = drawable instanceof GLWindow window ? window.getMainMonitor() : null;
      return monitor == null ? 0 : Math.max(0, monitor.getCurrentMode().getRefreshRate());
    }

    private void stop(GL3 gl) {
      if (started) {
        started = false;
        try {
          source.stop(gl);
        } catch (RuntimeException | Error e) {
          fail(e);
        }
      }
    }

    private float scale(GLAutoDrawable drawable) {
      return drawable instanceof GLWindow window ? NewtWindowFactory.scale(window) : 1;
    }

    @Override
    public void reshape(GLAutoDrawable drawable, int x, int y, int width, int height) {
      // Each frame asks for the size.
    }

    @Override
    public void dispose(GLAutoDrawable drawable) {
      // For a window that was destroyed before the last frame; the render thread waits.
      stop(drawable.getGL().getGL3());
    }
  }

  /**
   * Confines the pointer to a window and hides it while that is wanted. The window system may
   * refuse, for example while the window is not mapped yet or another program has grabbed the
   * pointer; then it is asked again. Belongs to the render thread.
   */
  private static final class PointerConfinement {
    /** Frames between two attempts. */
    private static final int PATIENCE = 15;

    private final GLWindow window;
    private boolean kept;
    private int waiting;

    PointerConfinement(GLWindow window) {
      this.window = window;
    }

    /** Confines or releases the pointer. */
    void keep(boolean wanted) {
      if (wanted == kept) {
        return;
      }
      if (wanted && waiting > 0) {
        waiting--;
        return;
      }
      window.confinePointer(wanted);
      kept = window.isPointerConfined();
      window.setPointerVisible(!kept);
      if (kept) {
        window.requestFocus(false); // This window hears the experimenter's keys.
      }
      waiting = PATIENCE;
    }
  }
}
