package org.selectiverenderer.app.run;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.app.headset.HeadsetConnection;
import org.selectiverenderer.app.settings.DisplaySettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.DisplayProfile;
import org.selectiverenderer.render.AntiAliasing;
import org.selectiverenderer.render.display.WindowSetup;
import org.selectiverenderer.render.display.WorldController;
import org.selectiverenderer.render.display.WorldDisplay;
import org.selectiverenderer.render.display.WorldWindow;
import org.selectiverenderer.render.headset.HeadsetView;
import org.selectiverenderer.render.window.Monitor;
import org.selectiverenderer.render.window.Monitors;
import org.selectiverenderer.render.window.QuadBufferSupport;
import org.selectiverenderer.render.window.WindowOptions;

/**
 * Creates the windows of a run by the monitors of the desktop. Where a monitor or the driver's quad
 * buffers are missing, both eyes are shown side by side in one window, and a message says so
 * ({@link #fitted}).
 */
final class RunWindowFactory {
  private static final int OPERATOR_WIDTH = 1120;
  private static final int OPERATOR_HEIGHT = 700;

  private final DisplaySettings settings;
  private final Consumer<String> message;
  private final String title;
  private final int samples;

  private RunWindowFactory(DisplaySettings settings, Path scene, Consumer<String> message) {
    this.settings = settings;
    this.message = message;
    title = settings.title().orElseGet(() -> scene.getFileName() + " - Selective Renderer");
    samples = settings.samples().orElseGet(AntiAliasing::forMotion);
  }

  /**
   * Creates the windows of a run.
   *
   * @param message receives messages about a display that is not available as requested
   */
  static WindowSetup of(RunSettings settings, Consumer<String> message) {
    RunWindowFactory stage =
        new RunWindowFactory(fitted(settings.display(), message), settings.scene().file(), message);
    return switch (stage.settings.presentation().mode()) {
      case DUAL -> stage.dual();
      case QUAD -> stage.quad();
      default -> stage.single();
    };
  }

  /**
   * Creates the screen of a run: its windows, or a headset with a mirror window.
   *
   * @param headset the headset if the settings ask for one
   * @param message receives messages about a display that is not available as requested
   */
  static WorldDisplay screen(
      RunSettings settings,
      Optional<HeadsetConnection> headset,
      WorldController host,
      Consumer<String> message) {
    WindowSetup windows = of(settings, message);
    if (headset.isEmpty()) {
      return new WorldWindow(windows, host);
    }
    WindowOptions main = windows.main();
    WindowSetup mirror =
        new WindowSetup(
            new WindowOptions(main.title(), main.width(), main.height(), 0, false),
            windows.layout(),
            windows.style(),
            Optional.empty(),
            windows.operator(),
            windows.pictureSamples());
    return new HeadsetView(
        mirror,
        host,
        headset.get(),
        settings.display().presentation().headset().orElseThrow().mirror(),
        main.samples());
  }

  /**
   * Returns the settings with a display that is available, in its real size.
   *
   * @param message receives messages about a display that is not available as requested
   */
  static RunSettings fitted(RunSettings settings, Consumer<String> message) {
    return settings.with(fitted(settings.display(), message));
  }

  private static DisplaySettings fitted(DisplaySettings settings, Consumer<String> message) {
    return switch (settings.presentation().mode()) {
      case DUAL -> fittedDual(settings, message);
      case QUAD -> fittedQuad(settings, message);
      default -> settings;
    };
  }

  private static DisplaySettings fittedDual(DisplaySettings settings, Consumer<String> message) {
    List<Monitor> monitors = Monitors.all();
    DisplayProfile profile = settings.presentation().geometry().profile();
    int most = Math.max(profile.leftScreen(), profile.rightScreen());
    if (profile.leftScreen() != profile.rightScreen() && most < monitors.size()) {
      Monitor left = monitors.get(profile.leftScreen());
      return settings.filling(2 * left.width(), left.height());
    }
    message.accept(
        ("--display dual needs monitors %d and %d, but there %s; both eyes are shown "
                + "side by side in a window instead")
            .formatted(
                profile.leftScreen(),
                profile.rightScreen(),
                monitors.size() == 1
                    ? "is only monitor 0, " + monitors.get(0)
                    : "are " + monitors.size() + ", counted from 0"));
    return sideBySide(settings);
  }

  private static DisplaySettings fittedQuad(DisplaySettings settings, Consumer<String> message) {
    if (QuadBufferSupport.available()) {
      return settings;
    }
    message.accept(
        "--display quad needs a driver with quad-buffered stereo, and this one has none; both"
            + " eyes are shown side by side in a window");
    return sideBySide(settings);
  }

  private static DisplaySettings sideBySide(DisplaySettings settings) {
    return settings.as(settings.presentation().as(DisplayMode.SIDE_BY_SIDE));
  }

  private WindowSetup single() {
    return new WindowSetup(
        new WindowOptions(title, settings.width(), settings.height(), samples, false),
        settings.presentation().layout(),
        settings.style(),
        Optional.empty(),
        operator(),
        settings.pictureSamples(samples));
  }

  private Optional<WindowOptions> operator() {
    if (!settings.operator()) {
      return Optional.empty();
    }
    return Optional.of(
        settings
            .operatorMonitor()
            .map(this::operatorOn)
            .orElseGet(
                () ->
                    new WindowOptions(
                        "Operator - " + title, OPERATOR_WIDTH, OPERATOR_HEIGHT, 0, false)));
  }

  private WindowOptions operatorOn(Monitor monitor) {
    return new WindowOptions(
        "Operator - " + title,
        Math.min(OPERATOR_WIDTH, monitor.width()),
        Math.min(OPERATOR_HEIGHT, monitor.height()),
        0,
        false,
        Optional.of(monitor),
        false);
  }

  private WindowSetup dual() {
    List<Monitor> monitors = Monitors.all();
    DisplayProfile profile = settings.presentation().geometry().profile();
    Monitor left = monitors.get(profile.leftScreen());
    Monitor right = monitors.get(profile.rightScreen());
    message.accept("left eye: monitor %s; right eye: monitor %s".formatted(left, right));
    return new WindowSetup(
        WindowOptions.filling(left, "Left eye - " + title, samples),
        settings.presentation().layout(),
        settings.style(),
        Optional.of(WindowOptions.filling(right, "Right eye - " + title, 0)),
        operatorBeside(monitors, left, right),
        settings.pictureSamples(samples));
  }

  /** Returns the operator's window on a monitor that shows no picture to an eye. */
  private Optional<WindowOptions> operatorBeside(
      List<Monitor> monitors, Monitor left, Monitor right) {
    if (!settings.operator()) {
      return Optional.empty();
    }
    Optional<Monitor> free =
        settings
            .operatorMonitor()
            .or(
                () ->
                    monitors.stream().filter(m -> !m.equals(left) && !m.equals(right)).findFirst());
    if (free.isEmpty()) {
      message.accept("the operator's window needs a third monitor, so it is not opened");
    }
    return free.map(this::operatorOn);
  }

  private WindowSetup quad() {
    WindowSetup stage = single();
    return new WindowSetup(
        stage.main().withQuadBuffers(),
        stage.layout(),
        stage.style(),
        Optional.empty(),
        stage.operator(),
        samples); // Only the window's own framebuffer has two buffers to draw into.
  }
}
