package org.selectiverenderer.tracker;

import java.nio.file.Path;

/** Which tracker, and where: the SPEC of the command line. {@code toString} writes it as typed. */
public sealed interface TrackerSpec {
  /** Of the Fastrak as delivered. */
  int FASTRAK_BAUD = 9600;

  /** Where opentrack sends to unless told otherwise. */
  int OPENTRACK_PORT = 4242;

  /** Where a VRPN server listens unless told otherwise. */
  int VRPN_PORT = 3883;

  /**
   * Reads a SPEC.
   *
   * @throws IllegalArgumentException with a sentence that names what is wrong and shows an example
   */
  static TrackerSpec parse(String text) {
    return new TrackerSpecParser(text).parse();
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
   * @param port a serial port's device, or COM3 on Windows; {@code auto} for the first that answers
   */
  record InterTrax2(String port) implements TrackerSpec {
    /** Whether its port is to be found. */
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
   * @param baud the speed that the device is set to, bits per second
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
   * @param port to listen on, on all interfaces
   */
  record OpenTrack(int port) implements TrackerSpec {
    @Override
    public String toString() {
      return "opentrack:" + port;
    }
  }

  /**
   * {@code vrpn:Tracker0@host:3883}.
   *
   * @param tracker its name at the server
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

  /** The headset that shows the pictures, by {@code --display openxr}; nobody types it. */
  record Headset() implements TrackerSpec {
    @Override
    public String toString() {
      return "openxr";
    }
  }

  /** {@code replay:FILE.csv}: what {@code track --output} or a head log recorded. */
  record Replay(Path file) implements TrackerSpec {
    @Override
    public String toString() {
      return "replay:" + file;
    }
  }

  /** Host and port as one writes them; an IPv6 address in brackets. */
  private static String address(String host, int port) {
    return (host.contains(":") ? "[" + host + "]" : host) + ":" + port;
  }
}
