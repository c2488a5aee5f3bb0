package org.selectiverenderer.x3d.files;

import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;

/**
 * Urls of the scheme {@code file}, as people write them and as RFC 8089 has them: with spaces and
 * letters that should be percent-encoded, with the slashes of Windows, with a drive right after the
 * scheme or where a host belongs.
 */
public final class FileUrl {
  private static final int SCHEME = "file:".length();
  private static final Pattern DRIVE = Pattern.compile("/{0,2}[A-Za-z]:(/.*)?", Pattern.DOTALL);
  private static final Pattern HERE = Pattern.compile("(?i)//localhost(?=/)");
  private static final String KEPT = "/:@!$&'()*+,;=-._~";

  private FileUrl() {}

  /** Whether a url has the scheme. */
  public static boolean is(String url) {
    return url.regionMatches(true, 0, "file:", 0, SCHEME);
  }

  /**
   * The url as the standards have it: {@code file:///C:/My%20Scenes/a.x3d} for {@code file:C:\My
   * Scenes\a.x3d}. Which path that is, the system says ({@code Path.of}).
   *
   * @param url of the scheme, without fragment
   * @throws IllegalArgumentException when it cannot be a url even so
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
