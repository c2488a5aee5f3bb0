package org.selectiverenderer.tracker.net;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.tracker.TrackerException;

/**
 * The cookie that both sides of a VRPN connection send first: {@code vrpn: ver. 07.38 0}, padded
 * with zeros.
 *
 * @param bytes the 24 bytes of the cookie
 */
record VrpnCookie(byte[] bytes) {
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
