package org.selectiverenderer.doctor.probe;

import java.lang.management.ManagementFactory;
import java.util.Locale;
import java.util.function.Consumer;
import org.selectiverenderer.doctor.Diagnosis;
import org.selectiverenderer.runtime.render.context.GlInfo;
import org.selectiverenderer.runtime.render.context.GlStart;
import org.selectiverenderer.runtime.render.context.GlUnavailableException;
import org.selectiverenderer.runtime.render.context.OffscreenContext;
import org.selectiverenderer.runtime.render.show.DriverSpeed;
import org.selectiverenderer.runtime.render.window.QuadBuffers;

/** OpenGL: the library that calls it, its driver, how fast that is. */
final class DrawingProbe {
  private DrawingProbe() {}

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
                  "the processor draws: if there is a graphics card, install its driver")
              : Diagnosis.ok("OpenGL", driver));
    } catch (GlUnavailableException e) {
      found.accept(Diagnosis.lacking("OpenGL", String.valueOf(e.getMessage()), ""));
    }
  }

  static void speed(Consumer<Diagnosis> found) {
    begin();
    try (DriverSpeed speed = new DriverSpeed()) {
      found.accept(
          Diagnosis.ok(
              "drawing speed",
              "%s million triangles/s, %s million pixels/s, unlit, by %s%s"
                  .formatted(
                      millions(speed.triangles()),
                      millions(speed.pixels()),
                      speed.info().software() ? "the processor" : "a graphics card",
                      busy() ? "; beside other work, so alone it may be faster" : "")));
    } catch (GlUnavailableException e) {
      found.accept(Diagnosis.lacking("drawing speed", "nothing can be drawn", "see OpenGL"));
    }
  }

  static void stereo(Consumer<Diagnosis> found) {
    begin();
    try (OffscreenContext context = OffscreenContext.open()) {
      found.accept(
          QuadBuffers.available()
              ? Diagnosis.ok("stereo buffers", "a left and a right one (run --display quad)")
              : Diagnosis.missing(
                  "stereo buffers",
                  context.info().renderer() + " has none",
                  "for --display quad take a professional graphics card and switch on stereo in its"
                      + " driver; the other displays need none"));
    } catch (GlUnavailableException e) {
      found.accept(Diagnosis.missing("stereo buffers", "nothing can be drawn", "see OpenGL"));
    }
  }

  /** Whether more wants to be computed than there are processors, over the last minute. */
  private static boolean busy() {
    return ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage()
        > Runtime.getRuntime().availableProcessors();
  }

  /** As a run begins: with native parts that are unpacked once. */
  private static void begin() {
    GlStart.begin(true).await();
  }

  /** Of three digits at least. */
  static String millions(double number) {
    double millions = number / 1e6;
    return String.format(
        Locale.ROOT, millions < 10 ? "%,.2f" : millions < 100 ? "%,.1f" : "%,.0f", millions);
  }
}
