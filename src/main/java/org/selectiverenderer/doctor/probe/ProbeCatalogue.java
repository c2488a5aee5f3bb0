package org.selectiverenderer.doctor.probe;

import java.time.Duration;
import java.util.List;
import org.selectiverenderer.doctor.Probe;
import org.selectiverenderer.doctor.Probe.Place;

/** Lists all probes, in the order of the report. */
public final class ProbeCatalogue {
  private static final Duration SHORT = Duration.ofSeconds(20);

  /**
   * The timeout of probes in child processes: Java and a driver start within seconds, on a busy
   * machine more slowly.
   */
  private static final Duration LONG = Duration.ofSeconds(60);

  private ProbeCatalogue() {}

  /**
   * @param askPorts whether a tracker is searched at the serial ports, by commands that other
   *     devices receive too
   */
  public static List<Probe> all(boolean askPorts) {
    return List.of(
        new Probe("java", "Java", true, Place.HERE, SHORT, JavaProbe::run),
        new Probe("archive", "class archive", false, Place.HERE, SHORT, JavaProbe::archive),
        new Probe("system", "system", true, Place.HERE, SHORT, SystemProbe::run),
        new Probe("language", "language", true, Place.HERE, SHORT, SystemProbe::language),
        new Probe("places", "places to write", true, Place.HERE, SHORT, FoldersProbe::run),
        new Probe("display", "display", true, Place.APART, LONG, DisplayProbe::run),
        new Probe("opengl", "OpenGL", true, Place.APART, LONG, OpenGlProbe::run),
        new Probe("speed", "drawing speed", true, Place.ALONE, LONG, OpenGlProbe::speed),
        new Probe("stereo", "stereo buffers", false, Place.APART, LONG, OpenGlProbe::stereo),
        new Probe("windows", "Java's windows", true, Place.APART, LONG, AwtProbe::run),
        new Probe("fonts", "fonts", true, Place.APART, LONG, AwtProbe::fonts),
        new Probe("openxr", "OpenXR", false, Place.APART, LONG, HeadsetProbe::run),
        new Probe("serial", "serial ports", false, Place.APART, LONG, TrackerProbe::ports),
        askPorts
            ? new Probe("tracker", "InterTrax2", false, Place.APART, LONG, TrackerProbe::search)
            : new Probe("unasked", "InterTrax2", false, Place.HERE, SHORT, TrackerProbe::unasked),
        new Probe("lsl", "liblsl", false, Place.APART, LONG, LslAndSoundProbe::lsl),
        new Probe("sound", "sound", false, Place.APART, LONG, LslAndSoundProbe::sound));
  }
}
