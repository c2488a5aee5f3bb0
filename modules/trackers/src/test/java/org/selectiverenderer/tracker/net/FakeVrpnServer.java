package org.selectiverenderer.tracker.net;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.condition.OS;

/** The server's side of VRPN, as far as its published messages go; played by a test. */
final class FakeVrpnServer implements AutoCloseable {
  static final int TRACKER = 5;
  static final int POSE = 9;

  private final DatagramSocket asked = new DatagramSocket(0, InetAddress.getByName("127.0.0.1"));
  private Socket client = new Socket();
  private DataOutputStream out = new DataOutputStream(new ByteArrayOutputStream());

  FakeVrpnServer() throws IOException {}

  int port() {
    return asked.getLocalPort();
  }

  /** Waits for a client's question, connects back, and exchanges cookies; returns the client's. */
  String welcome(String cookie) throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[100], 100);
    asked.receive(packet);
    String question =
        new String(packet.getData(), 0, packet.getLength(), StandardCharsets.US_ASCII);
    if (!question.matches("127\\.0\\.0\\.1 \\d+\0")) {
      throw new AssertionError("asked: " + question);
    }
    String[] address = question.strip().split(" ");
    stranger(address[0], Integer.parseInt(address[1].replace("\0", "")));
    client = new Socket(address[0], Integer.parseInt(address[1].replace("\0", "")));
    client.setTcpNoDelay(true);
    out = new DataOutputStream(client.getOutputStream());
    byte[] theirs = client.getInputStream().readNBytes(24);
    out.write(Arrays.copyOf(cookie.getBytes(StandardCharsets.US_ASCII), 24));
    return new String(theirs, StandardCharsets.US_ASCII).replace("\0", "");
  }

  /** Another host finds the port first; the client must send it away. */
  private static void stranger(String host, int port) throws IOException {
    if (OS.LINUX.isCurrentOs()) { // all of 127.0.0.0/8 is this machine there
      Socket other = new Socket();
      other.bind(new InetSocketAddress("127.0.0.2", 0));
      other.connect(new InetSocketAddress(host, port));
      if (other.getInputStream().read() >= 0) {
        throw new AssertionError("a stranger was answered");
      }
      other.close();
    }
  }

  void describe(int kind, int number, String name) throws IOException {
    ByteArrayOutputStream payload = new ByteArrayOutputStream();
    DataOutputStream data = new DataOutputStream(payload);
    data.writeInt(name.length() + 1);
    data.writeBytes(name);
    data.writeByte(0);
    message(number, kind, payload.toByteArray());
  }

  /** Names the tracker and the type of its poses, among others. */
  void introduce() throws IOException {
    describe(-1, 1, "Mouse0");
    describe(-1, TRACKER, "Tracker0");
    describe(-2, 2, "vrpn_Base ping_message");
    describe(-2, POSE, "vrpn_Tracker Pos_Quat");
  }

  void pose(int sender, int sensor, double... quaternion) throws IOException {
    ByteArrayOutputStream payload = new ByteArrayOutputStream();
    DataOutputStream data = new DataOutputStream(payload);
    data.writeInt(sensor);
    data.writeInt(0);
    for (int i = 0; i < 3; i++) {
      data.writeDouble(100 + i);
    }
    for (double value : quaternion) {
      data.writeDouble(value);
    }
    message(sender, POSE, payload.toByteArray());
  }

  void message(int sender, int type, byte[] payload) throws IOException {
    ByteArrayOutputStream message = new ByteArrayOutputStream();
    DataOutputStream data = new DataOutputStream(message);
    for (int value : new int[] {24 + payload.length, 1_000, 2, sender, type, 7}) {
      data.writeInt(value);
    }
    data.write(Arrays.copyOf(payload, (payload.length + 7) / 8 * 8));
    out.write(message.toByteArray());
    out.flush();
  }

  void raw(byte... bytes) throws IOException {
    out.write(bytes);
    out.flush();
  }

  @Override
  public void close() throws IOException {
    client.close();
    asked.close();
  }
}
