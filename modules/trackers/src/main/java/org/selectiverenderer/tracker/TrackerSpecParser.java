package org.selectiverenderer.tracker;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;

/** Parses the SPEC of a tracker; every error message shows an example. */
final class TrackerSpecParser {
  private final String text;
  private final String kind;
  private final String rest;

  /** An example of a serial port's name. */
  private final String port;

  /**
   * @param system the name of the operating system, as in {@code os.name}
   */
  TrackerSpecParser(String text, String system) {
    this.text = text;
    int colon = text.indexOf(':');
    kind = (colon < 0 ? text : text.substring(0, colon)).strip().toLowerCase(Locale.ROOT);
    rest = colon < 0 ? "" : text.substring(colon + 1).strip();
    port = serialPortExample(system);
  }

  private static String serialPortExample(String system) {
    String name = system.toLowerCase(Locale.ROOT);
    if (name.startsWith("windows")) {
      return "COM3";
    }
    return name.startsWith("mac") ? "/dev/cu.usbserial-10" : "/dev/ttyUSB0";
  }

  TrackerSpec parse() {
    return switch (kind) {
      case "none" -> none();
      case "intertrax2" -> new TrackerSpec.InterTrax2(serialPort(rest, "intertrax2:" + port));
      case "fastrak" -> fastrak();
      case "opentrack" -> opentrack();
      case "vrpn" -> vrpn();
      case "tcp" -> tcp();
      case "replay" -> replay();
      case "openxr" ->
          throw new IllegalArgumentException(
              "'"
                  + text
                  + "' is not a tracker: a headset brings its own tracker; leave --tracker out with"
                  + " run SCENE --display openxr (--head-log F.csv records its poses in"
                  + " F_tracker.csv)");
      default -> throw refusal("there is no tracker of the kind '" + kind + "'", kinds());
    };
  }

  private TrackerSpec none() {
    if (!rest.isEmpty()) {
      throw refusal("nothing may follow 'none'", "none");
    }
    return new TrackerSpec.None();
  }

  private TrackerSpec fastrak() {
    String example = "fastrak:" + port + "@9600";
    int at = rest.lastIndexOf('@');
    int baud =
        at < 0
            ? TrackerSpec.FASTRAK_BAUD
            : number(rest.substring(at + 1), 110, 4_000_000, "a speed in bits per second", example);
    return new TrackerSpec.Fastrak(
        serialPort(at < 0 ? rest : rest.substring(0, at), example), baud);
  }

  private TrackerSpec opentrack() {
    if (rest.isEmpty()) {
      return new TrackerSpec.OpenTrack(TrackerSpec.OPENTRACK_PORT);
    }
    int colon = portColon(rest);
    if (colon < 0) {
      return new TrackerSpec.OpenTrack(port(rest, "opentrack:4242"));
    }
    String example = "opentrack:*:4242";
    return new TrackerSpec.OpenTrack(
        host(rest.substring(0, colon), example), port(rest.substring(colon + 1), example));
  }

  private TrackerSpec vrpn() {
    String example = "vrpn:Tracker0@localhost:3883";
    int at = rest.indexOf('@');
    if (at <= 0) {
      throw refusal("the tracker's name and '@' are missing before the host", example);
    }
    String address = rest.substring(at + 1);
    int colon = portColon(address);
    return new TrackerSpec.Vrpn(
        rest.substring(0, at),
        host(colon < 0 ? address : address.substring(0, colon), example),
        colon < 0 ? TrackerSpec.VRPN_PORT : port(address.substring(colon + 1), example));
  }

  private TrackerSpec tcp() {
    String example = "tcp:localhost:5555";
    int colon = portColon(rest);
    if (colon < 0) {
      throw refusal("the port is missing", example);
    }
    return new TrackerSpec.Tcp(
        host(rest.substring(0, colon), example), port(rest.substring(colon + 1), example));
  }

  private TrackerSpec replay() {
    if (rest.isEmpty()) {
      throw refusal("the file is missing", "replay:head.csv");
    }
    try {
      return new TrackerSpec.Replay(Path.of(rest));
    } catch (InvalidPathException e) {
      throw refusal("'" + rest + "' cannot be the name of a file", "replay:head.csv");
    }
  }

  /**
   * Returns the index of the colon before the port, which is not within the brackets of an IPv6
   * address.
   */
  private static int portColon(String address) {
    int colon = address.lastIndexOf(':');
    return colon < address.lastIndexOf(']') ? -1 : colon;
  }

  private String host(String name, String example) {
    String host =
        name.startsWith("[") && name.endsWith("]") ? name.substring(1, name.length() - 1) : name;
    if (host.isBlank()) {
      throw refusal("the host is missing", example);
    }
    return host;
  }

  private String serialPort(String name, String example) {
    if (name.isBlank()) {
      throw refusal("the serial port is missing", example);
    }
    return name;
  }

  private int port(String digits, String example) {
    return number(digits, 1, 65535, "a port", example);
  }

  private int number(String digits, int least, int most, String what, String example) {
    try {
      int value = Integer.parseInt(digits);
      if (value >= least && value <= most) {
        return value;
      }
    } catch (NumberFormatException e) {
      // Reported below, as for a number out of range.
    }
    throw refusal("'%s' is not %s (%d to %d)".formatted(digits, what, least, most), example);
  }

  private String kinds() {
    return "intertrax2:%s, fastrak:%s@9600, opentrack:4242, vrpn:Tracker0@host:3883, tcp:host:port,"
            .formatted(port, port)
        + " replay:FILE.csv or none";
  }

  private IllegalArgumentException refusal(String reason, String example) {
    return new IllegalArgumentException(
        "'" + text + "' is not a tracker: " + reason + "; write it like " + example);
  }
}
