package org.selectiverenderer.x3d.url;

import java.net.Inet4Address;
import java.net.Inet6Address;
import java.net.InetAddress;

/**
 * Tells the addresses of this computer and of its own network from those of the Internet. A server
 * at such an address often trusts whoever reaches it, so the name of a host of the Internet must
 * not lead there.
 */
final class PrivateAddress {
  private PrivateAddress() {}

  /**
   * Returns whether an address is of the loopback, of one link, of a private network (RFC 1918, RFC
   * 4193, RFC 6598), of a group or of none.
   */
  static boolean is(InetAddress address) {
    return address.isLoopbackAddress()
        || address.isAnyLocalAddress()
        || address.isLinkLocalAddress()
        || address.isSiteLocalAddress()
        || address.isMulticastAddress()
        || address instanceof Inet4Address && isSpecial(address.getAddress())
        || address instanceof Inet6Address && isSpecial6(address.getAddress());
  }

  /** Returns whether it is "this network" (RFC 1122), a carrier's (RFC 6598), or broadcast. */
  private static boolean isSpecial(byte[] parts) {
    int first = parts[0] & 0xff;
    return first == 0 || first == 100 && (parts[1] & 0xc0) == 64 || first >= 240;
  }

  /** Returns whether it is unique local (RFC 4193), or leads to an IPv4 address (NAT64, 6to4). */
  private static boolean isSpecial6(byte[] parts) {
    boolean uniqueLocal = (parts[0] & 0xfe) == 0xfc;
    boolean nat64 = parts[0] == 0 && parts[1] == 0x64 && (parts[2] & 0xff) == 0xff;
    boolean sixToFour = parts[0] == 0x20 && parts[1] == 2;
    return uniqueLocal || nat64 || sixToFour;
  }
}
