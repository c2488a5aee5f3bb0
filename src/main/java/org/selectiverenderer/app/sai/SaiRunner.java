package org.selectiverenderer.app.sai;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.HeadlessException;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.lang.reflect.InvocationTargetException;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import javax.swing.JFrame;
import javax.swing.WindowConstants;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.timeline.TimelineEvent;
import org.selectiverenderer.app.timeline.TimelineText;
import org.selectiverenderer.control.ControlEvent;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.runtime.viewer.CameraPath;
import org.web3d.x3d.sai.BrowserFactory;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.InvalidX3DException;
import org.web3d.x3d.sai.NotSupportedException;
import org.web3d.x3d.sai.X3DComponent;
import org.web3d.x3d.sai.X3DException;
import org.web3d.x3d.sai.X3DScene;

/**
 * A scene under the controller in whatever browser the SAI finds: the embedded one, or Xj3D with
 * its jars first on the class path. Names nothing but the SAI and the controller.
 */
public final class SaiRunner implements AutoCloseable {
  /**
   * What browsers are told unless the user says otherwise: Xj3D does not start where it finds no
   * OpenAL or no device for sounds; other browsers do not look at it.
   */
  private static final Map<String, Object> PARAMETERS = Map.of("Xj3D_DisableAudio", true);

  /** How long a browser may take to tell of the end of a path, in seconds. */
  private static final double PATIENCE = 1;

  /** How long a browser may take until it shows a scene that it has read, in seconds. */
  private static final int BEGINNING = 60;

  /** Of the standard: the system property that names the browser's factory. */
  private static final String FACTORY = "x3d.sai.factory.class";

  private volatile double begun = System.currentTimeMillis() / 1000.0;
  private volatile boolean shown;
  private final CountDownLatch started = new CountDownLatch(1);
  private final X3DComponent component;
  private final TimelineText text = new TimelineText();
  private final Consumer<String> out;
  private final Consumer<TimelineEvent> timeline;
  private @Nullable JFrame window;

  private SaiRunner(
      X3DComponent component, Consumer<String> out, Consumer<TimelineEvent> timeline) {
    this.component = component;
    this.out = out;
    this.timeline = timeline;
  }

  /**
   * Shows a scene.
   *
   * @param url full address of the scene
   * @param parameters for the browser, in addition to those that it needs
   * @param out takes the time line line by line, on the thread of the browser
   * @param timeline takes the events of the scene, on the same thread
   * @throws org.web3d.x3d.sai.X3DException if there is no browser, it does not start, or the scene
   *     cannot be read
   */
  public static SaiRunner open(
      String url,
      SelectiveController.Settings settings,
      Map<String, Object> parameters,
      Consumer<String> out,
      Consumer<TimelineEvent> timeline) {
    SaiRunner runner = new SaiRunner(component(parameters), out, timeline);
    try {
      ExternalBrowser browser = runner.browser();
      out.accept("browser: " + browser.getName() + " " + browser.getVersion());
      new SelectiveController(
          browser,
          settings,
          runner::tell,
          problem ->
              out.accept(problem.severity().name().toLowerCase(Locale.ROOT) + ": " + problem));
      X3DScene scene = read(browser, url);
      runner.shown = true; // Before it a browser shows an empty scene, which is no one's.
      browser.replaceWorld(scene);
      return runner;
    } catch (RuntimeException | Error e) {
      runner.close();
      throw e;
    }
  }

  private static X3DComponent component(Map<String, Object> parameters) {
    Map<String, Object> all = new HashMap<>(PARAMETERS);
    all.putAll(parameters);
    try {
      return BrowserFactory.createX3DComponent(all);
    } catch (HeadlessException e) {
      throw withoutDisplay(e);
    } catch (NullPointerException e) { // what Xj3D does when it finds no factory
      if (System.getProperty(FACTORY) == null) {
        throw notStarted(
            "the system property " + FACTORY + " names its factory, but is not set", e);
      }
      throw notStarted(whyNoFactory().map(Throwable::toString).orElse(e.toString()), e);
    } catch (LinkageError e) { // a jar or a library of the browser is missing or does not fit
      throw notStarted(innermost(e).toString(), e);
    }
  }

  /** Xj3D keeps to itself why it has no factory: here it is made once more to find out. */
  private static Optional<Throwable> whyNoFactory() {
    try {
      Class.forName(System.getProperty(FACTORY)).getDeclaredConstructor().newInstance();
      return Optional.empty();
    } catch (ReflectiveOperationException | RuntimeException | LinkageError e) {
      return Optional.of(innermost(e));
    }
  }

  private static NotSupportedException withoutDisplay(HeadlessException cause) {
    return notStarted("it shows a window, and Java finds no display", cause);
  }

  private static NotSupportedException notStarted(String reason, Throwable cause) {
    NotSupportedException failure =
        new NotSupportedException("the browser does not start: " + reason);
    failure.initCause(cause); // Xj3D's exceptions have no constructor for it.
    return failure;
  }

  private static Throwable innermost(Throwable failure) {
    Throwable innermost = failure;
    while (innermost.getCause() != null) {
      innermost = innermost.getCause();
    }
    return innermost;
  }

  private static X3DScene read(ExternalBrowser browser, String url) {
    try {
      return browser.createX3DFromURL(new String[] {url});
    } catch (X3DException e) {
      throw e;
    } catch (RuntimeException e) { // Xj3D's own kinds, of a profile that it lacks for instance
      InvalidX3DException failure =
          new InvalidX3DException("the browser does not read the scene: " + e);
      failure.initCause(e);
      throw failure;
    }
  }

  public ExternalBrowser browser() {
    return component.getBrowser();
  }

  /**
   * Moves the viewer along a path through the SAI, at the pace of the clock on the wall. It begins
   * when the scene is under control, which in some browsers is long after it was read; from there
   * on the time line counts from the beginning of the path.
   *
   * @param end ends it early when it reaches zero
   * @throws NotSupportedException if the browser does not begin with the scene
   */
  public void follow(CameraPath path, CountDownLatch end) throws InterruptedException {
    long latest = System.nanoTime() + TimeUnit.SECONDS.toNanos(BEGINNING);
    while (!started.await(SaiWalk.STEP_MS, TimeUnit.MILLISECONDS)) {
      if (end.getCount() == 0) {
        return;
      }
      if (System.nanoTime() - latest > 0) {
        throw new NotSupportedException(
            "the browser has read the scene, but has not shown it after " + BEGINNING + " s");
      }
    }
    SaiWalk walk = new SaiWalk(browser(), path);
    walk.begin(end);
    begun = System.currentTimeMillis() / 1000.0;
    walk.walk(end, PATIENCE);
  }

  /** X3D counts seconds from 1970, the time line from the start. */
  private void tell(ControlEvent event) {
    TimelineEvent.Told told = new TimelineEvent.Told(Math.max(0, event.time() - begun), event);
    if (shown && event instanceof ControlEvent.Start) {
      started.countDown();
    }
    out.accept(text.line(told));
    if (shown) {
      timeline.accept(told);
    }
  }

  /**
   * Puts the browser into a window, if it is one for windows.
   *
   * @param onClose called when the user closes it
   * @return whether there is a window
   * @throws NotSupportedException if there is no display for it
   */
  public boolean showWindow(Runnable onClose) {
    Optional<Component> picture = picture();
    picture.ifPresent(shown -> onEventThread(() -> window = frame(shown, onClose)));
    return picture.isPresent();
  }

  /** Of Xj3D the component is a panel itself, and its implementation the canvas in it. */
  private Optional<Component> picture() {
    if (component instanceof Component panel) {
      return Optional.of(panel);
    }
    return component.getImplementation() instanceof Component implementation
        ? Optional.of(implementation)
        : Optional.empty();
  }

  private static JFrame frame(Component shown, Runnable onClose) {
    JFrame frame = new JFrame("Selective Renderer");
    shown.setPreferredSize(new Dimension(1024, 768));
    frame.add(shown);
    frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
    frame.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosing(WindowEvent event) {
            onClose.run();
          }
        });
    frame.pack();
    frame.setVisible(true);
    return frame;
  }

  private static void onEventThread(Runnable task) {
    try {
      EventQueue.invokeAndWait(task);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (InvocationTargetException e) {
      if (e.getCause() instanceof HeadlessException headless) {
        throw withoutDisplay(headless);
      }
      throw new IllegalStateException(e.getCause());
    }
  }

  /** Ends the browser, which lets the controller go, and closes the window. */
  @Override
  public void close() {
    component.shutdown();
    JFrame shown = window;
    if (shown != null) {
      onEventThread(shown::dispose);
    }
  }
}
