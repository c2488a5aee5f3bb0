package org.selectiverenderer.x3d.files;

import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.regex.Pattern;

/** Urls of the network, as authors write them. */
final class WebUrl {
  private static final Pattern SCHEME = Pattern.compile("(?i)https?:");

  /** What may stand in an address as it is (RFC 3986, 2). */
  private static final String PLAIN = "-._~:/?[]@!$&'()*+,;=%";

  private WebUrl() {}

  static boolean is(String location) {
    return SCHEME.matcher(location).lookingAt();
  }

  /**
   * The address that a url means; empty when it is none.
   *
   * @param location without fragment
   */
  static Optional<URI> of(String location) {
    try {
      URI uri = URI.create(encoded(location));
      boolean whole = uri.getHost() != null && uri.getUserInfo() == null;
      return whole ? Optional.of(uri.normalize()) : Optional.empty();
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  /** The address of a relative url; empty when it is none of the network. */
  static Optional<URI> of(String location, URI base) {
    try {
      return of(base.resolve(encoded(location)).toString()).filter(uri -> is(uri.toString()));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  /** Spaces and letters of other alphabets are common in urls that people write. */
  private static String encoded(String location) {
    StringBuilder text = new StringBuilder(location.length() + 16);
    for (byte part : location.replace('\\', '/').getBytes(StandardCharsets.UTF_8)) {
      char sign = (char) (part & 0xff);
      boolean plain =
          sign >= 'a' && sign <= 'z'
              || sign >= 'A' && sign <= 'Z'
              || sign >= '0' && sign <= '9'
              || PLAIN.indexOf(sign) >= 0;
      if (plain) {
        text.append(sign);
      } else {
        text.append("%%%02X".formatted((int) sign));
      }
    }
    return text.toString();
  }
}
