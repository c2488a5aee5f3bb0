package org.selectiverenderer.x3d.url;

import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;

/**
 * Parses urls of the scheme {@code file} (RFC 8089), including common malformed ones: with
 * unencoded spaces and letters, with backslashes, or with a Windows drive right after the scheme or
 * in the place of the host.
 */
public final class FileUrl {
  private static final int SCHEME = "file:".length();
  private static final Pattern DRIVE = Pattern.compile("/{0,2}[A-Za-z]:(/.*)?", Pattern.DOTALL);
  private static final Pattern HERE = Pattern.compile("(?i)//localhost(?=/)");
  private static final String KEPT = "/:@!$&'()*+,;=-._~";

  private FileUrl() {}

  /** Returns whether a url has the scheme {@code file}. */
  public static boolean is(String url) {
    return url.regionMatches(true, 0, "file:", 0, SCHEME);
  }

  /**
   * Returns the url in standard form: {@code file:///C:/My%20Scenes/a.x3d} for {@code file:C:\My
   * Scenes\a.x3d}. {@code Path.of} converts it to a path.
   *
   * @param url a url of the scheme {@code file}, without fragment
   * @throws IllegalArgumentException if it cannot be converted to a valid url
   */
  public static URI uri(String url) {
    String rest = url.substring(SCHEME).replace('\\', '/');
    if (DRIVE.matcher(rest).matches()) {
      rest = "///" + rest.substring(rest.startsWith("//") ? 2 : rest.startsWith("/") ? 1 : 0);
    }
    return URI.create("file:" + encoded(HERE.matcher(rest).replaceFirst("")));
  }

  private static String encoded(String path) {
    StringBuilder text = new StringBuilder(path.length());
    byte[] bytes = path.getBytes(StandardCharsets.UTF_8);
    for (int i = 0; i < bytes.length; i++) {
      char c = (char) (bytes[i] & 0xff);
      boolean kept = c < 0x80 && (Character.isLetterOrDigit(c) || KEPT.indexOf(c) >= 0);
      if (kept || c == '%' && code(bytes, i)) {
        text.append(c);
      } else {
        text.append('%');
        text.append(Character.toUpperCase(Character.forDigit(c >> 4, 16)));
        text.append(Character.toUpperCase(Character.forDigit(c & 15, 16)));
      }
    }
    return text.toString();
  }

  private static boolean code(byte[] bytes, int at) {
    return at + 2 < bytes.length
        && Character.digit(bytes[at + 1], 16) >= 0
        && Character.digit(bytes[at + 2], 16) >= 0;
  }
}
