package org.selectiverenderer.app;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.hmd.DisplayMode;
import org.selectiverenderer.hmd.DisplayProfile;
import org.selectiverenderer.hmd.Presentation;
import org.selectiverenderer.runtime.render.AntiAliasing;
import org.selectiverenderer.runtime.render.Stage;
import org.selectiverenderer.runtime.render.window.Monitor;
import org.selectiverenderer.runtime.render.window.Monitors;
import org.selectiverenderer.runtime.render.window.QuadBuffers;
import org.selectiverenderer.runtime.render.window.WindowOptions;

/**
 * Chooses the windows of a run by what the desktop has. Where a monitor or the driver's quad
 * buffers are missing, both eyes are shown side by side in one window, and that is said.
 */
final class WindowStage {
  private static final int OPERATOR_WIDTH = 1120;
  private static final int OPERATOR_HEIGHT = 700;

  private final RunSettings settings;
  private final Consumer<String> message;
  private final String title;
  private final int samples;

  private WindowStage(RunSettings settings, Consumer<String> message) {
    this.settings = settings;
    this.message = message;
    title = settings.scene().getFileName() + " - Selective Renderer";
    samples = settings.samples().orElseGet(AntiAliasing::forMotion);
  }

  /**
   * The windows.
   *
   * @param message hears what is not as asked for
   */
  static Stage of(RunSettings settings, Consumer<String> message) {
    WindowStage stage = new WindowStage(settings, message);
    Presentation shown = settings.presentation();
    return switch (shown.mode()) {
      case DUAL -> stage.dual(shown);
      case QUAD -> stage.quad(shown);
      default -> stage.single(shown, settings.width(), settings.height());
    };
  }

  private Stage single(Presentation shown, int width, int height) {
    return new Stage(
        new WindowOptions(title, width, height, samples, false),
        shown.layout(),
        Optional.empty(),
        operator());
  }

  private Optional<WindowOptions> operator() {
    return settings.operator()
        ? Optional.of(
            new WindowOptions("Operator - " + title, OPERATOR_WIDTH, OPERATOR_HEIGHT, 0, false))
        : Optional.empty();
  }

  private Stage dual(Presentation shown) {
    List<Monitor> monitors = Monitors.all();
    DisplayProfile profile = shown.geometry().profile();
    int most = Math.max(profile.leftScreen(), profile.rightScreen());
    if (profile.leftScreen() == profile.rightScreen() || most >= monitors.size()) {
      message.accept(
          "--display dual needs monitors %d and %d, but there %s; both eyes are shown side by side in a window"
              .formatted(
                  profile.leftScreen(),
                  profile.rightScreen(),
                  monitors.size() == 1
                      ? "is only monitor 0, " + monitors.get(0)
                      : "are " + monitors.size() + ", counted from 0"));
      return sideBySide(shown);
    }
    Monitor left = monitors.get(profile.leftScreen());
    Monitor right = monitors.get(profile.rightScreen());
    message.accept("left eye: monitor %s; right eye: monitor %s".formatted(left, right));
    return new Stage(
        WindowOptions.filling(left, "Left eye - " + title, samples),
        shown.layout(),
        Optional.of(WindowOptions.filling(right, "Right eye - " + title, 0)),
        operatorBeside(monitors, left, right));
  }

  /** The operator looks at a monitor that is no eye's. */
  private Optional<WindowOptions> operatorBeside(
      List<Monitor> monitors, Monitor left, Monitor right) {
    if (!settings.operator()) {
      return Optional.empty();
    }
    Optional<Monitor> free =
        monitors.stream().filter(m -> !m.equals(left) && !m.equals(right)).findFirst();
    if (free.isEmpty()) {
      message.accept("there is no third monitor for the operator's window; it stays closed");
    }
    return free.map(
        monitor ->
            new WindowOptions(
                "Operator - " + title,
                Math.min(OPERATOR_WIDTH, monitor.width()),
                Math.min(OPERATOR_HEIGHT, monitor.height()),
                0,
                false,
                Optional.of(monitor),
                false));
  }

  private Stage quad(Presentation shown) {
    if (!QuadBuffers.available()) {
      message.accept(
          "--display quad needs a driver with quad-buffered stereo, and this one has none; both"
              + " eyes are shown side by side in a window");
      return sideBySide(shown);
    }
    Stage stage = single(shown, settings.width(), settings.height());
    return new Stage(
        stage.main().withQuadBuffers(), stage.layout(), Optional.empty(), stage.operator());
  }

  private Stage sideBySide(Presentation shown) {
    Presentation instead = shown.as(DisplayMode.SIDE_BY_SIDE);
    return single(instead, instead.width(), instead.height());
  }
}
