package org.selectiverenderer.x3d.url;

import java.util.Locale;
import java.util.regex.Pattern;

/**
 * A pattern of hosts from which the user allows scenes to fetch.
 *
 * @param text the name or address of a host, or {@code *.domain} for all hosts of a domain
 */
public record HostPattern(String text) {
  private static final Pattern FORM =
      Pattern.compile("(\\*\\.)?[\\p{Alnum}_]([\\p{Alnum}_.-]*[\\p{Alnum}_])?|\\[[0-9a-fA-F:.]+]");

  /**
   * Normalizes and checks the text.
   *
   * @throws IllegalArgumentException if it is neither, with a message for the user
   */
  public HostPattern {
    text = text.strip().toLowerCase(Locale.ROOT);
    if (!FORM.matcher(text).matches()) {
      throw new IllegalArgumentException(
          "'%s' is no host; write one such as example.org or *.example.org".formatted(text));
    }
  }

  boolean matches(String host) {
    String asked = host.toLowerCase(Locale.ROOT);
    return text.startsWith("*.")
        ? asked.endsWith(text.substring(1)) && asked.length() > text.length() - 1
        : asked.equals(text);
  }

  @Override
  public String toString() {
    return text;
  }
}
