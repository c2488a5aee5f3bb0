package org.selectiverenderer.tracker.net;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.pipeline.PoseSink;
import org.selectiverenderer.tracker.pipeline.PoseSource;

/**
 * A VRPN client (Taylor et al., VRST 2001), protocol version 07, for sensor 0 of one tracker.
 *
 * <p>The client sends a datagram with its own address and a TCP port; the server connects back to
 * that port, both send a cookie with their version, and the server sends messages. As the client
 * names no UDP port, records come over the same connection. The port is open on the one address
 * that leads to the server, and other hosts that connect are sent away. Not tested with a server of
 * the VRPN project.
 */
public final class VrpnSource implements PoseSource {
  /** Interval in nanoseconds after which the datagram, which may be lost, is sent again. */
  private static final long ASK_AGAIN = TimeUnit.MILLISECONDS.toNanos(500);

  private static final long GIVE_UP = TimeUnit.MILLISECONDS.toNanos(1600);

  private final String tracker;
  private final String host;
  private final int port;
  private @Nullable InetSocketAddress server;
  private @Nullable ServerSocket listening;
  private @Nullable Socket socket;

  /**
   * @param tracker name of the tracker at the server
   */
  public VrpnSource(String tracker, String host, int port) {
    this.tracker = tracker;
    this.host = host;
    this.port = port;
  }

  @Override
  public void open() throws TrackerException {
    server = TcpConnector.address(host, port);
    try (DatagramSocket way = new DatagramSocket()) {
      way.connect(server); // Sends nothing, but selects the local address.
      listening = new ServerSocket(0, 0, way.getLocalAddress());
      listening.setSoTimeout(PoseSink.PATIENCE_MS);
    } catch (IOException e) {
      throw new TrackerException("no TCP port can be opened here: " + e.getMessage(), e);
    }
  }

  @Override
  public void read(PoseSink intake) throws IOException {
    Socket from = accept(intake);
    if (from == null) {
      return;
    }
    socket = from;
    TcpConnector.prepare(from);
    from.getOutputStream().write(VrpnCookie.OURS.bytes());
    VrpnStream stream = new VrpnStream(from.getInputStream(), intake);
    VrpnCookie theirs = VrpnCookie.read(stream);
    if (intake.closed()) {
      return;
    }
    theirs.check(host);
    intake.connected();
    new VrpnMessageReader(tracker, stream, intake).read();
  }

  /** Asks the server to connect back; returns null if the tracker is being closed. */
  private @Nullable Socket accept(PoseSink intake) throws IOException {
    InetSocketAddress to = server;
    ServerSocket back = listening;
    if (to == null || back == null) {
      throw new TrackerException("there is no connection to " + host);
    }
    try (DatagramSocket asking = new DatagramSocket()) {
      asking.connect(to); // Answers from elsewhere are not received.
      byte[] question = question(back.getInetAddress(), back.getLocalPort());
      List<InetAddress> callers = List.of(InetAddress.getAllByName(host));
      long begin = System.nanoTime();
      long next = begin;
      while (!intake.closed()) {
        long now = System.nanoTime();
        if (now - begin > GIVE_UP) {
          throw silent();
        }
        if (now - next >= 0) {
          ask(asking, question);
          next = now + ASK_AGAIN;
        }
        try {
          Socket caller = back.accept();
          if (callers.contains(caller.getInetAddress())) {
            return caller;
          }
          SocketCloser.quietly(caller); // Not the server: whoever else found the port.
        } catch (SocketTimeoutException e) {
          // The server has not connected yet.
        }
      }
    }
    return null;
  }

  private static byte[] question(InetAddress own, int port) {
    return (own.getHostAddress() + " " + port + "\0").getBytes(StandardCharsets.US_ASCII);
  }

  private void ask(DatagramSocket asking, byte[] question) throws TrackerException {
    try {
      asking.send(new DatagramPacket(question, question.length));
    } catch (IOException e) { // ICMP port unreachable, for the previous datagram.
      throw silent();
    }
  }

  private TrackerException silent() {
    return new TrackerException(
        "no VRPN server answers at "
            + host
            + ", port "
            + port
            + " (is it running, and can it connect back to this machine?)");
  }

  @Override
  public boolean placed() {
    return true;
  }

  @Override
  public void close() {
    SocketCloser.quietly(socket);
    SocketCloser.quietly(listening);
    socket = null;
    listening = null;
  }

  /**
   * The cookie that both sides of a VRPN connection send first: {@code vrpn: ver. 07.38 0}, padded
   * with zeros.
   *
   * @param bytes the 24 bytes of the cookie
   */
  private record VrpnCookie(byte[] bytes) {
    static final int LENGTH = 24;

    /** Version 07.38, without remote logging. */
    static final VrpnCookie OURS =
        new VrpnCookie(
            Arrays.copyOf("vrpn: ver. 07.38  0".getBytes(StandardCharsets.US_ASCII), LENGTH));

    private static final Pattern FORM = Pattern.compile("vrpn: ver\\. (\\d\\d)\\.(\\d\\d).*");
    private static final String MAJOR = "07";

    static VrpnCookie read(VrpnStream stream) throws IOException {
      stream.require(LENGTH);
      return new VrpnCookie(stream.bytes(LENGTH));
    }

    /**
     * Checks the major version; minor versions are compatible.
     *
     * @throws TrackerException if the server has another major version, or is not a VRPN server
     */
    void check(String host) throws TrackerException {
      Matcher matcher = FORM.matcher(new String(bytes, StandardCharsets.ISO_8859_1));
      if (!matcher.lookingAt()) {
        throw new TrackerException("the server at " + host + " is not a VRPN server");
      }
      if (!matcher.group(1).equals(MAJOR)) {
        throw new TrackerException(
            "the VRPN server at "
                + host
                + " has protocol version "
                + matcher.group(1)
                + "."
                + matcher.group(2)
                + ", but this program needs "
                + MAJOR
                + ".38");
      }
    }
  }
}
