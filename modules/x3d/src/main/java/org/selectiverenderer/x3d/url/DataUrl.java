package org.selectiverenderer.x3d.url;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.HexFormat;
import java.util.Locale;
import java.util.regex.Pattern;

/** Decodes urls that contain their data: {@code data:[type][;base64],...} (RFC 2397). */
final class DataUrl {
  private static final Pattern SCHEME = Pattern.compile("(?i)data:");
  private static final int SHOWN = 40;

  private DataUrl() {}

  static boolean is(String url) {
    return SCHEME.matcher(url).lookingAt();
  }

  /**
   * Returns the offset of the fragment's sign #, or -1. An unencoded VRML scene begins with that
   * sign itself.
   */
  static int fragment(String url) {
    int comma = url.indexOf(',');
    return url.startsWith("#VRML V", comma + 1) || url.startsWith("#X3D V", comma + 1)
        ? -1
        : url.indexOf('#');
  }

  /**
   * Decodes a url.
   *
   * @param url the url without fragment
   * @param base the base of the file that contains the url, also used for relative urls in the data
   * @throws IOException with a predicate that follows the url
   */
  static UrlContent read(String url, BaseUrl base) throws IOException {
    int comma = url.indexOf(',');
    if (comma < 0) {
      throw new IOException("is a data: url without a comma before its data");
    }
    if (url.length() > 4L * HttpFetcher.MAX_BYTES) {
      throw new IOException("is a data: url that is too large");
    }
    boolean base64 =
        url.substring(0, comma).stripTrailing().toLowerCase(Locale.ROOT).endsWith(";base64");
    byte[] data = percentDecoded(url, comma + 1);
    if (base64) {
      try {
        data = Base64.getMimeDecoder().decode(data);
      } catch (IllegalArgumentException e) {
        throw new IOException("is a data: url with invalid base64", e);
      }
    }
    if (data.length > HttpFetcher.MAX_BYTES) {
      throw new IOException(
          "has more than %s MiB of data, which is the limit"
              .formatted(HttpFetcher.MAX_BYTES >> 20));
    }
    String name = (url.length() <= SHOWN ? url : url.substring(0, SHOWN) + "…");
    name = name.replaceAll("\\p{Cntrl}+", " "); // messages are one line
    return new UrlContent.OfBytes("data:" + digest(data), name, base, data);
  }

  /** Decodes percent-encoding; a sign % without two hexadecimal digits is kept. */
  private static byte[] percentDecoded(String url, int from) {
    ByteArrayOutputStream out = new ByteArrayOutputStream(url.length() - from);
    int plain = from;
    for (int at = url.indexOf('%', from); at >= 0; at = url.indexOf('%', at + 1)) {
      if (at + 2 < url.length()
          && HexFormat.isHexDigit(url.charAt(at + 1))
          && HexFormat.isHexDigit(url.charAt(at + 2))) {
        out.writeBytes(url.substring(plain, at).getBytes(StandardCharsets.UTF_8));
        out.write(HexFormat.fromHexDigits(url, at + 1, at + 3));
        plain = at + 3;
        at += 2;
      }
    }
    out.writeBytes(url.substring(plain).getBytes(StandardCharsets.UTF_8));
    return out.toByteArray();
  }

  private static String digest(byte[] data) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(data));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }
}
