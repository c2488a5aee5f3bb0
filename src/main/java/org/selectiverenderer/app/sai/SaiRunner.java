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
import org.selectiverenderer.browser.viewer.CameraPath;
import org.selectiverenderer.control.ControlEvent;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;
import org.selectiverenderer.walkthrough.timeline.TimelineText;
import org.web3d.x3d.sai.BrowserFactory;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.InvalidX3DException;
import org.web3d.x3d.sai.NotSupportedException;
import org.web3d.x3d.sai.X3DComponent;
import org.web3d.x3d.sai.X3DException;
import org.web3d.x3d.sai.X3DScene;

/**
 * Runs a scene with the selective controller in any X3D browser that implements the SAI: the
 * embedded browser, or Xj3D if its jars are first on the class path. The class depends on the SAI
 * and the controller only.
 */
public final class SaiRunner implements AutoCloseable {
  /**
   * The default browser parameters: without this one Xj3D does not start where it finds no OpenAL
   * or no sound device; other browsers ignore it.
   */
  private static final Map<String, Object> PARAMETERS = Map.of("Xj3D_DisableAudio", true);

  /**
   * The time in seconds that a browser may take to send its last events after the end of a path.
   */
  private static final double PATIENCE = 1;

  /** The time in seconds that a browser may take until it shows a scene that it has read. */
  private static final int BEGINNING = 60;

  /**
   * The system property that names the browser's factory class (X3D language bindings for Java).
   */
  private static final String FACTORY = "x3d.sai.factory.class";

  private volatile double begun = System.currentTimeMillis() / 1000.0;
  private volatile boolean shown;
  private volatile @Nullable SelectiveController controller;
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
   * Loads a scene into a browser and shows it.
   *
   * @param url absolute URL of the scene
   * @param parameters browser parameters in addition to the default ones
   * @param out receives the lines of the time line, on the thread of the browser
   * @param timeline receives the events of the scene, on the same thread
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
      runner.controller =
          new SelectiveController(
              browser,
              settings,
              runner::tell,
              problem ->
                  out.accept(problem.severity().name().toLowerCase(Locale.ROOT) + ": " + problem));
      X3DScene scene = read(browser, url);
      runner.shown = true; // Events before this line belong to the browser's empty initial scene.
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

  /** Creates the factory once more to find out why it failed, which Xj3D does not report. */
  private static Optional<Throwable> whyNoFactory() {
    try {
      Class.forName(System.getProperty(FACTORY)).getDeclaredConstructor().newInstance();
      return Optional.empty();
    } catch (ReflectiveOperationException | RuntimeException | LinkageError e) {
      return Optional.of(innermost(e));
    }
  }

  private static NotSupportedException withoutDisplay(HeadlessException cause) {
    return notStarted("it opens a window, but Java finds no display", cause);
  }

  private static NotSupportedException notStarted(String reason, Throwable cause) {
    NotSupportedException failure =
        new NotSupportedException("the browser does not start: " + reason);
    failure.initCause(cause); // Xj3D's exceptions have no constructor with a cause.
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
          new InvalidX3DException("the browser cannot read the scene: " + e);
      failure.initCause(e);
      throw failure;
    }
  }

  public ExternalBrowser browser() {
    return component.getBrowser();
  }

  /**
   * Moves the viewer along a path through the SAI in real time. The motion starts when the
   * controller has attached to the scene, which in some browsers is long after the scene was read;
   * from then on the time line counts from the start of the path.
   *
   * @param end ends the motion early when it reaches zero
   * @throws NotSupportedException if the browser does not show the scene in time
   */
  public void follow(CameraPath path, CountDownLatch end) throws InterruptedException {
    long latest = System.nanoTime() + TimeUnit.SECONDS.toNanos(BEGINNING);
    while (!started.await(SaiPathFollower.STEP_MS, TimeUnit.MILLISECONDS)) {
      if (end.getCount() == 0) {
        return;
      }
      if (System.nanoTime() - latest > 0) {
        throw new NotSupportedException(
            "the browser has read the scene, but has not shown it after " + BEGINNING + " s");
      }
    }
    SaiPathFollower walk = new SaiPathFollower(browser(), path);
    walk.begin(end);
    begun = System.currentTimeMillis() / 1000.0;
    walk.walk(end, PATIENCE);
  }

  /**
   * Writes an event to the time line. X3D counts seconds from 1970, the time line from the start.
   */
  private void tell(ControlEvent event) {
    TimelineEvent.ControllerEvent told =
        new TimelineEvent.ControllerEvent(Math.max(0, event.time() - begun), event);
    if (shown && event instanceof ControlEvent.Start) {
      started.countDown();
    }
    out.accept(text.line(told));
    SelectiveController known = controller;
    if (shown && known != null && event instanceof ControlEvent.Start) {
      known.idleRules().ifPresent(remark -> out.accept("warning: " + remark));
    }
    if (shown) {
      timeline.accept(told);
    }
  }

  /**
   * Shows the browser in a window, if it has a visual component.
   *
   * @param onClose called when the user closes it
   * @return whether there is a window
   * @throws NotSupportedException if there is no display
   */
  public boolean showWindow(Runnable onClose) {
    Optional<Component> picture = picture();
    picture.ifPresent(shown -> onEventThread(() -> window = frame(shown, onClose)));
    return picture.isPresent();
  }

  /**
   * Returns the browser's visual component. Xj3D's X3DComponent is a panel itself, whose
   * implementation is the canvas in it.
   */
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

  /** Shuts the browser down, which detaches the controller, and closes the window. */
  @Override
  public void close() {
    component.shutdown();
    JFrame shown = window;
    if (shown != null) {
      onEventThread(shown::dispose);
    }
  }
}
