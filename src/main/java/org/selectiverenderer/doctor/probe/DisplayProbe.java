package org.selectiverenderer.doctor.probe;

import java.io.UncheckedIOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.doctor.Diagnosis;
import org.selectiverenderer.render.context.GlAvailability;
import org.selectiverenderer.render.window.MonitorMode;
import org.selectiverenderer.render.window.Monitors;

/** Checks the monitors. */
final class DisplayProbe {
  private DisplayProbe() {}

  static void run(Consumer<Diagnosis> found) {
    Optional<String> reason = GlAvailability.check();
    if (reason.isPresent()) {
      found.accept(Diagnosis.lacking("display", reason.get(), ""));
      return;
    }
    List<MonitorMode> modes;
    try {
      modes = Monitors.modes();
    } catch (UncheckedIOException e) {
      found.accept(Diagnosis.lacking("display", e.getCause().getMessage(), ""));
      return;
    }
    if (modes.isEmpty()) {
      found.accept(Diagnosis.lacking("display", "no monitor found", "connect a monitor"));
    }
    for (int index = 0; index < modes.size(); index++) {
      found.accept(
          Diagnosis.ok(
              "display",
              "monitor %d of %d: %s".formatted(index + 1, modes.size(), text(modes.get(index)))));
    }
    session().ifPresent(found);
  }

  static String text(MonitorMode mode) {
    return "%s, %s, scale %s"
        .formatted(
            mode.monitor(),
            mode.rate() > 0 ? String.format(Locale.ROOT, "%.4g Hz", mode.rate()) : "unknown rate",
            String.format(Locale.ROOT, "%.3g", mode.scale()));
  }

  private static Optional<Diagnosis> session() {
    String wayland = System.getenv().getOrDefault("WAYLAND_DISPLAY", "");
    return wayland.isEmpty()
        ? Optional.empty()
        : Optional.of(Diagnosis.ok("desktop", "Wayland, used through XWayland"));
  }
}
