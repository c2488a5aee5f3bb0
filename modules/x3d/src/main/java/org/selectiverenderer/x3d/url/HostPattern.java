package org.selectiverenderer.x3d.url;

import java.net.URI;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A pattern of hosts from which the user allows scenes to fetch.
 *
 * @param text the name or address of a host, or {@code *.domain} for all hosts of a domain, and
 *     after a colon the port; without one, the default ports of http and https
 */
public record HostPattern(String text) {
  private static final Pattern FORM =
      Pattern.compile(
          "((?:\\*\\.)?[\\p{Alnum}_](?:[\\p{Alnum}_.-]*[\\p{Alnum}_])?|\\[[0-9a-fA-F:.]+])"
              + "(?::(\\d{1,5}))?");

  private static final int HTTP = 80;
  private static final int HTTPS = 443;
  private static final int LAST_PORT = 65_535;

  /**
   * Normalizes and checks the text.
   *
   * @throws IllegalArgumentException if it is none of these, with a message for the user
   */
  public HostPattern {
    text = text.strip().toLowerCase(Locale.ROOT);
    Matcher form = FORM.matcher(text);
    if (!form.matches() || form.group(2) != null && !isPort(Integer.parseInt(form.group(2)))) {
      throw new IllegalArgumentException(
          "'%s' is no host; write one such as example.org, *.example.org or example.org:8080"
              .formatted(text));
    }
  }

  private static boolean isPort(int number) {
    return number > 0 && number <= LAST_PORT;
  }

  /** Returns what a user would type to allow an address. */
  static String allowing(URI uri) {
    int port = port(uri);
    return port == HTTP || port == HTTPS ? uri.getHost() : uri.getHost() + ":" + port;
  }

  /** Returns whether an address of http or https is one of these. */
  boolean matches(URI uri) {
    return uri.getHost() != null && ports(port(uri)) && matches(uri.getHost());
  }

  /** Returns whether this names one host, by the name or address that a url has, on any port. */
  boolean names(String host) {
    return host().equals(host.toLowerCase(Locale.ROOT));
  }

  private boolean matches(String host) {
    String pattern = host();
    String asked = host.toLowerCase(Locale.ROOT);
    return pattern.startsWith("*.")
        ? asked.endsWith(pattern.substring(1)) && asked.length() > pattern.length() - 1
        : asked.equals(pattern);
  }

  private boolean ports(int asked) {
    String port = group(2);
    return port.isEmpty() ? asked == HTTP || asked == HTTPS : asked == Integer.parseInt(port);
  }

  private String host() {
    return group(1);
  }

  private String group(int number) {
    Matcher form = FORM.matcher(text);
    String found = form.matches() ? form.group(number) : null;
    return found == null ? "" : found;
  }

  private static int port(URI uri) {
    return uri.getPort() >= 0
        ? uri.getPort()
        : "https".equalsIgnoreCase(uri.getScheme()) ? HTTPS : HTTP;
  }

  @Override
  public String toString() {
    return text;
  }
}
