package org.selectiverenderer.x3d.files;

import java.util.Locale;
import java.util.regex.Pattern;

/**
 * A host that the user lets scenes fetch from.
 *
 * @param text a host's name or address, or {@code *.host} for all hosts below one
 */
public record HostPattern(String text) {
  private static final Pattern FORM =
      Pattern.compile("(\\*\\.)?[\\p{Alnum}_]([\\p{Alnum}_.-]*[\\p{Alnum}_])?|\\[[0-9a-fA-F:.]+]");

  /**
   * @throws IllegalArgumentException when it is neither, with a sentence for the user
   */
  public HostPattern {
    text = text.strip().toLowerCase(Locale.ROOT);
    if (!FORM.matcher(text).matches()) {
      throw new IllegalArgumentException(
          "'%s' is no host; name one such as example.org, or *.example.org".formatted(text));
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
