package org.selectiverenderer.tracker;

import java.nio.file.Path;

/**
 * The SPEC of a tracker on the command line: its kind and its port or address. {@code toString}
 * returns it as typed.
 */
public sealed interface TrackerSpec {
  /** Default speed of the Fastrak. */
  int FASTRAK_BAUD = 9600;

  /** Default UDP port of opentrack. */
  int OPENTRACK_PORT = 4242;

  /** Default port of a VRPN server. */
  int VRPN_PORT = 3883;

  /**
   * Parses a SPEC.
   *
   * @throws IllegalArgumentException with a message that says what is wrong and shows an example
   */
  static TrackerSpec parse(String text) {
    return new TrackerSpecParser(text, System.getProperty("os.name", "")).parse();
  }

  /** No tracker: {@code none}. */
  record None() implements TrackerSpec {
    @Override
    public String toString() {
      return "none";
    }
  }

  /**
   * {@code intertrax2:/dev/ttyUSB0}.
   *
   * @param port device file of the serial port, or a name like COM3 on Windows; {@code auto} for
   *     the first port with an InterTrax2
   */
  record InterTrax2(String port) implements TrackerSpec {
    /** Returns whether the port is to be searched. */
    public boolean searched() {
      return port.equals("auto");
    }

    @Override
    public String toString() {
      return "intertrax2:" + port;
    }
  }

  /**
   * {@code fastrak:/dev/ttyUSB0@9600}: InterSense IS-300, 600 and 900, Polhemus Fastrak.
   *
   * @param baud speed of the device in bits per second
   */
  record Fastrak(String port, int baud) implements TrackerSpec {
    @Override
    public String toString() {
      return "fastrak:" + port + "@" + baud;
    }
  }

  /**
   * {@code opentrack:4242}: UDP datagrams of opentrack's "UDP over network" output.
   *
   * @param host address of this machine to listen on, {@code *} for all; empty for the loopback,
   *     which only programs on this machine reach
   */
  record OpenTrack(String host, int port) implements TrackerSpec {
    /** Creates a specification of an opentrack on this machine. */
    public OpenTrack(int port) {
      this("", port);
    }

    @Override
    public String toString() {
      return "opentrack:" + (host.isEmpty() ? port : address(host, port));
    }
  }

  /**
   * {@code vrpn:Tracker0@host:3883}.
   *
   * @param tracker name of the tracker at the server
   */
  record Vrpn(String tracker, String host, int port) implements TrackerSpec {
    @Override
    public String toString() {
      return "vrpn:" + tracker + "@" + address(host, port);
    }
  }

  /** {@code tcp:host:port}: lines of {@code yaw pitch roll} in degrees. */
  record Tcp(String host, int port) implements TrackerSpec {
    @Override
    public String toString() {
      return "tcp:" + address(host, port);
    }
  }

  /** The headset of {@code --display openxr}; not a SPEC that users type. */
  record Headset() implements TrackerSpec {
    @Override
    public String toString() {
      return "openxr";
    }
  }

  /** {@code replay:FILE.csv}: a recording by {@code track --output}, or a head log. */
  record Replay(Path file) implements TrackerSpec {
    @Override
    public String toString() {
      return "replay:" + file;
    }
  }

  /** Formats host and port, with an IPv6 address in brackets. */
  private static String address(String host, int port) {
    return (host.contains(":") ? "[" + host + "]" : host) + ":" + port;
  }
}
