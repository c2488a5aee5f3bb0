package org.selectiverenderer.x3d.url;

import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.regex.Pattern;

/** Parses http and https urls, including ones with unencoded characters. */
final class HttpUrl {
  private static final Pattern SCHEME = Pattern.compile("(?i)https?:");

  /** Characters, other than letters and digits, that need no encoding (RFC 3986, 2). */
  private static final String PLAIN = "-._~:/?[]@!$&'()*+,;=%";

  private HttpUrl() {}

  static boolean is(String location) {
    return SCHEME.matcher(location).lookingAt();
  }

  /**
   * Returns the address of a url; empty if it is invalid.
   *
   * @param location the url without fragment
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

  /** Returns the address of a relative url; empty if it is invalid or not http or https. */
  static Optional<URI> of(String location, URI base) {
    try {
      return of(base.resolve(encoded(location)).toString()).filter(uri -> is(uri.toString()));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  /** Percent-encodes spaces and non-ASCII letters, which are common in hand-written urls. */
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
