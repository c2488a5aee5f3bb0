package org.selectiverenderer.doctor.probe;

import java.lang.management.ManagementFactory;
import java.util.Locale;
import java.util.function.Consumer;
import org.selectiverenderer.doctor.Diagnosis;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.render.context.GlPreloader;
import org.selectiverenderer.render.context.GlUnavailableException;
import org.selectiverenderer.render.context.OffscreenContext;
import org.selectiverenderer.render.display.DriverBenchmark;
import org.selectiverenderer.render.window.QuadBufferSupport;

/** Checks OpenGL: the Java binding, the driver and its speed. */
final class OpenGlProbe {
  private OpenGlProbe() {}

  static void run(Consumer<Diagnosis> found) {
    begin();
    try (OffscreenContext context = OffscreenContext.open()) {
      found.accept(
          Diagnosis.ok(
              "JOGL",
              "%s, its native parts load (%s)"
                  .formatted(GlInfo.binding(), System.getProperty("os.arch", "unknown"))));
      GlInfo info = context.info();
      String driver = "%s; %s; %s".formatted(info.renderer(), info.vendor(), info.version());
      found.accept(
          info.software()
              ? Diagnosis.warning(
                  "OpenGL",
                  driver,
                  "software rendering: if there is a graphics card, install its driver")
              : Diagnosis.ok("OpenGL", driver));
    } catch (GlUnavailableException e) {
      found.accept(Diagnosis.lacking("OpenGL", String.valueOf(e.getMessage()), ""));
    }
  }

  static void speed(Consumer<Diagnosis> found) {
    begin();
    try (DriverBenchmark speed = new DriverBenchmark()) {
      found.accept(
          Diagnosis.ok(
              "drawing speed",
              "%s million triangles/s, %s million pixels/s, unlit, by %s%s"
                  .formatted(
                      millions(speed.triangles()),
                      millions(speed.pixels()),
                      speed.info().software() ? "the processor" : "a graphics card",
                      busy() ? "; measured under other load, so it may be faster alone" : "")));
    } catch (GlUnavailableException e) {
      found.accept(Diagnosis.lacking("drawing speed", "nothing can be drawn", "see OpenGL"));
    }
  }

  static void stereo(Consumer<Diagnosis> found) {
    begin();
    try (OffscreenContext context = OffscreenContext.open()) {
      found.accept(
          QuadBufferSupport.available()
              ? Diagnosis.ok("stereo buffers", "left and right (for run --display quad)")
              : Diagnosis.missing(
                  "stereo buffers",
                  context.info().renderer() + " has none",
                  "--display quad needs a professional graphics card with stereo switched on in its"
                      + " driver; the other displays do not"));
    } catch (GlUnavailableException e) {
      found.accept(Diagnosis.missing("stereo buffers", "nothing can be drawn", "see OpenGL"));
    }
  }

  /** Returns whether the load of the last minute exceeds the number of processors. */
  private static boolean busy() {
    return ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage()
        > Runtime.getRuntime().availableProcessors();
  }

  /** Starts OpenGL as a run does, with native libraries that are unpacked once. */
  private static void begin() {
    GlPreloader.begin(true).await();
  }

  /** Formats millions with at least three digits. */
  static String millions(double number) {
    double millions = number / 1e6;
    return String.format(
        Locale.ROOT, millions < 10 ? "%,.2f" : millions < 100 ? "%,.1f" : "%,.0f", millions);
  }
}
