package org.selectiverenderer.render.window;

import com.jogamp.nativewindow.NativeWindowException;
import com.jogamp.nativewindow.NativeWindowFactory;
import com.jogamp.nativewindow.WindowClosingProtocol.WindowClosingMode;
import com.jogamp.newt.Screen;
import com.jogamp.newt.event.WindowAdapter;
import com.jogamp.newt.event.WindowEvent;
import com.jogamp.newt.opengl.GLWindow;
import com.jogamp.opengl.GLCapabilities;
import com.jogamp.opengl.GLContext;
import com.jogamp.opengl.GLEventListener;
import com.jogamp.opengl.GLException;
import java.text.Normalizer;
import org.selectiverenderer.render.context.GlProfiles;

/** Opens and closes NEWT windows that the calling thread draws. */
final class NewtWindowFactory {
  private NewtWindowFactory() {}

  /** Returns the GL capabilities that a window of these options needs. */
  static GLCapabilities capabilities(WindowOptions options) {
    GLCapabilities wanted = new GLCapabilities(GlProfiles.core());
    wanted.setDepthBits(24);
    wanted.setStencilBits(8); // for the pattern of cross-fades
    wanted.setStereo(options.quadBuffered());
    if (options.samples() > 1) {
      wanted.setSampleBuffers(true);
      wanted.setNumSamples(options.samples());
    }
    return wanted;
  }

  /**
   * Creates a window whose input goes to a queue. It is not shown before {@link #show}.
   *
   * @param onClose called on a thread of NEWT when the user closes it
   */
  static GLWindow create(
      WindowOptions options,
      GLCapabilities wanted,
      InputQueue queue,
      Runnable onClose,
      GLEventListener drawing) {
    GLWindow window =
        options
            .monitor()
            .map(monitor -> GLWindow.create(Monitors.screen(monitor), wanted))
            .orElseGet(() -> GLWindow.create(wanted));
    window.setTitle(shown(options.title()));
    window.setSize(options.width(), options.height());
    options.monitor().ifPresent(monitor -> window.setPosition(monitor.x(), monitor.y()));
    window.setDefaultCloseOperation(WindowClosingMode.DO_NOTHING_ON_CLOSE);
    window.addWindowListener(queue);
    window.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowDestroyNotify(WindowEvent event) {
            onClose.run();
          }
        });
    window.addMouseListener(queue);
    window.addKeyListener(queue);
    window.addGLEventListener(drawing);
    // Otherwise NEWT's own thread would draw too, whenever the window system asks for a repaint.
    window.setExclusiveContextThread(Thread.currentThread());
    // All windows are drawn before any is shown, so that both eyes change together.
    window.setAutoSwapBufferMode(false);
    return window;
  }

  /**
   * Returns a title as the window system shows it: NEWT hands the bytes of UTF-8 to a call of X11
   * that takes them for Latin-1, so that other letters than those of ASCII would be wrong ones.
   */
  private static String shown(String title) {
    if (!NativeWindowFactory.getNativeWindowType(true).equals(NativeWindowFactory.TYPE_X11)) {
      return title;
    }
    String plain =
        Normalizer.normalize(title, Normalizer.Form.NFD).replaceAll("[^ -~]", "").strip();
    return plain.isEmpty() ? "Selective Renderer" : plain;
  }

  /**
   * Shows a window; frees it if that fails.
   *
   * @throws GLException if there is no such OpenGL
   */
  static void show(GLWindow window, WindowOptions options) {
    try {
      if (options.fullScreen()) {
        fill(window, options);
      }
      window.setVisible(true);
    } catch (GLException | NativeWindowException e) {
      window.destroy();
      throw e;
    }
  }

  /** Makes a window fill its monitor; returns whether it does. */
  static boolean fill(GLWindow window, WindowOptions options) {
    if (options.monitor().isEmpty()) {
      return window.setFullscreen(true);
    }
    Screen screen = window.getScreen();
    screen.addReference(); // The screen lists its monitors only while open.
    try {
      return window.setFullscreen(Monitors.device(screen, options.monitor().get()));
    } finally {
      Monitors.letGo(screen);
    }
  }

  /** Returns the pixels per unit of the desktop. */
  static float scale(GLWindow window) {
    return Math.max(1, window.getCurrentSurfaceScale(new float[2])[1]);
  }

  /**
   * Swaps the buffers of a window with its own context current: with another window's context
   * Mesa's software renderer shows a picture that is still being rasterised.
   */
  static void swap(GLWindow window) {
    GLContext context = window.getContext();
    if (context == null || context.makeCurrent() == GLContext.CONTEXT_NOT_CURRENT) {
      return; // It is being closed.
    }
    try {
      window.swapBuffers();
    } finally {
      context.release();
    }
  }

  /** Calls the drawing a last time, so that it can free its resources, and closes the window. */
  static void close(GLWindow window) {
    // The last display call frees the content's resources on this thread instead of NEWT's.
    window.setExclusiveContextThread(null);
    window.display();
    window.destroy();
  }
}
